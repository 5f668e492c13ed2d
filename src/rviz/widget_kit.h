#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <initializer_list>

namespace crowd {

// Makers of the panel's controls. The widget in whose layout a control is put owns it.

/// @brief A widget with an object name, by which tests find it, and a tool tip.
template <typename Widget>
Widget* named(const char* name, const char* tip = "") {
  auto* const widget = new Widget;
  widget->setObjectName(name);
  widget->setToolTip(tip);
  return widget;
}

QPushButton* makeButton(const char* name, const char* text, const char* tip);
/// @brief A number from 0 on, which counts when its text is complete.
QDoubleSpinBox* makeNumber(const char* name, double most, int decimals, double step, const char* tip);
/// @brief The same, of which all decimals are shown.
QDoubleSpinBox* makeExactNumber(const char* name, double most, double step, const char* tip);
/// @brief A whole number, the same.
QSpinBox* makeCount(const char* name, int least, int most, const char* tip);
QComboBox* makeChoice(const char* name, const QStringList& entries, const char* tip);
/// @brief A text that the user can select and copy.
QLabel* makeText(const char* name, const char* tip = "");

/// @brief Widgets side by side.
QHBoxLayout* makeRow(std::initializer_list<QWidget*> widgets);
/// @brief Rows of a label and a control.
QFormLayout* makeForm(QWidget* parent);

}  // namespace crowd
