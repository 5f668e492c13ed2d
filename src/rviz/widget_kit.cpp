#include "rviz/widget_kit.h"

#include <limits>

namespace crowd {
namespace {

/// Enough that no number above 0 is rounded to 0; as many as Qt supports.
constexpr int MAX_DECIMALS = std::numeric_limits<double>::max_exponent10 + std::numeric_limits<double>::digits10;

/// Shows no more decimals than its number has.
class ExactBox : public QDoubleSpinBox {
 public:
  QString textFromValue(double value) const override {
    QLocale plain = locale();
    plain.setNumberOptions(plain.numberOptions() | QLocale::OmitGroupSeparator);
    return plain.toString(value, 'f', QLocale::FloatingPointShortest);
  }
};

QDoubleSpinBox* numberFrom0(QDoubleSpinBox* box, double most, int decimals, double step) {
  box->setDecimals(decimals);
  box->setRange(0.0, most);
  box->setSingleStep(step);
  box->setKeyboardTracking(false);  // a number counts when it is complete
  return box;
}

}  // namespace

QPushButton* makeButton(const char* name, const char* text, const char* tip) {
  auto* const button = named<QPushButton>(name, tip);
  button->setText(text);
  button->setMinimumWidth(1);
  return button;
}

QDoubleSpinBox* makeNumber(const char* name, double most, int decimals, double step, const char* tip) {
  return numberFrom0(named<QDoubleSpinBox>(name, tip), most, decimals, step);
}

QDoubleSpinBox* makeExactNumber(const char* name, double most, double step, const char* tip) {
  return numberFrom0(named<ExactBox>(name, tip), most, MAX_DECIMALS, step);
}

QSpinBox* makeCount(const char* name, int least, int most, const char* tip) {
  auto* const box = named<QSpinBox>(name, tip);
  box->setRange(least, most);
  box->setKeyboardTracking(false);
  return box;
}

QComboBox* makeChoice(const char* name, const QStringList& entries, const char* tip) {
  auto* const box = named<QComboBox>(name, tip);
  box->addItems(entries);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
  return box;
}

QLabel* makeText(const char* name, const char* tip) {
  auto* const label = named<QLabel>(name, tip);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QHBoxLayout* makeRow(std::initializer_list<QWidget*> widgets) {
  auto* const layout = new QHBoxLayout;
  layout->setSpacing(4);
  for (QWidget* const widget : widgets) layout->addWidget(widget);
  return layout;
}

QFormLayout* makeForm(QWidget* parent) {
  auto* const form = new QFormLayout(parent);
  form->setContentsMargins(6, 4, 6, 4);
  form->setVerticalSpacing(3);
  form->setHorizontalSpacing(8);
  return form;
}

}  // namespace crowd
