#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QWidget>

#include "rviz/panel_state.h"

namespace crowd {

/// @brief The controls of the panel, laid out in a widget that owns them. Each has an object name, that of the member.
struct PanelWidgets {
  /// @brief Makes all controls and lays them out in `parent`.
  explicit PanelWidgets(QWidget* parent);

  /// @brief Shows a view. Does not change what the user is editing, and emits no signals.
  void show(const PanelView& view);

  QPushButton* play;
  QPushButton* pause;
  QPushButton* step;
  QSpinBox* ticks;
  QPushButton* reset;
  QDoubleSpinBox* speed;
  QComboBox* scenario;
  QPushButton* open_scenario;
  QPushButton* save_scenario;

  QComboBox* learner;
  QComboBox* mode;
  QDoubleSpinBox* epsilon;
  QDoubleSpinBox* alpha;
  QDoubleSpinBox* gamma;
  QPushButton* save_table;
  QPushButton* load_table;
  QPushButton* share_table;
  QComboBox* share_method;

  QLabel* state;
  QLabel* episode;
  QLabel* tick;
  QLabel* success;
  QLabel* contact;
  QLabel* collision;
  QLabel* decisions;
  QLabel* missing;
  QLabel* table;
  QSpinBox* agent;
  QLineEdit* name_space;
  QLabel* message;
};

}  // namespace crowd
