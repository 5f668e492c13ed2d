#include "rviz/panel_widgets.h"

#include <QGroupBox>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ros/controller/controller_parameters.h"
#include "rviz/widget_kit.h"

namespace crowd {
namespace {

constexpr int MOST_TICKS = 100'000;
constexpr int MOST_AGENTS = 1'000'000;

QGroupBox* crowdGroup(const PanelWidgets& w) {
  auto* const group = new QGroupBox("Crowd");
  QFormLayout* const form = makeForm(group);
  form->addRow("State", w.state);
  form->addRow("Speed", w.speed);
  form->addRow("Scenario", makeRow({w.scenario, w.open_scenario}));
  form->addRow("Floor", w.save_scenario);
  form->addRow("Episode", w.episode);
  form->addRow("Tick", w.tick);
  form->addRow("Arrived", w.success);
  form->addRow("Contact", w.contact);
  form->addRow("Collision", w.collision);
  form->addRow("Decisions/s", w.decisions);
  form->addRow("No answer", w.missing);
  form->addRow("Agent", w.agent);
  return group;
}

QGroupBox* learningGroup(const PanelWidgets& w) {
  auto* const group = new QGroupBox("Learning");
  QFormLayout* const form = makeForm(group);
  form->addRow("Learner", w.learner);
  form->addRow("Mode", w.mode);
  form->addRow("Epsilon", w.epsilon);
  form->addRow("Alpha", w.alpha);
  form->addRow("Gamma", w.gamma);
  form->addRow("Q-table", w.table);
  form->addRow("", makeRow({w.save_table, w.load_table}));
  form->addRow("", makeRow({w.share_table, w.share_method}));
  return group;
}

/// Puts all controls below each other, in an area that scrolls where RViz leaves little space.
void layOut(const PanelWidgets& w, QWidget* parent) {
  auto* const content = new QWidget;
  auto* const column = new QVBoxLayout(content);
  column->setContentsMargins(4, 4, 4, 4);
  column->setSpacing(4);
  column->addLayout(makeRow({w.play, w.pause, w.reset}));
  column->addLayout(makeRow({w.step, w.ticks}));
  column->addWidget(w.message);
  column->addWidget(crowdGroup(w));
  column->addWidget(learningGroup(w));
  QFormLayout* const settings = makeForm(nullptr);
  settings->addRow("Namespace", w.name_space);
  column->addLayout(settings);
  column->addStretch();
  auto* const scroll = new QScrollArea;
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* const frame = new QVBoxLayout(parent);
  frame->setContentsMargins(0, 0, 0, 0);
  frame->addWidget(scroll);
}

template <typename Box, typename Value>
void showNumber(Box* box, Value value) {
  const auto* const edit = box->template findChild<QLineEdit*>();
  if (box->hasFocus() && edit->isModified()) return;
  const QSignalBlocker blocker(box);
  if (box->value() != value) box->setValue(value);
}

void showChoice(QComboBox* box, const std::string& entry) {
  const QString text = QString::fromStdString(entry);
  if (box->currentText() == text) return;
  const QSignalBlocker blocker(box);
  if (!text.isEmpty() && box->findText(text) < 0) box->addItem(text);
  box->setCurrentIndex(box->findText(text));
}

void showChoices(QComboBox* box, const std::vector<std::string>& entries, const std::string& entry) {
  QStringList wanted;
  for (const std::string& one : entries) wanted.append(QString::fromStdString(one));
  const QString chosen = QString::fromStdString(entry);
  if (!chosen.isEmpty() && !wanted.contains(chosen)) wanted.append(chosen);
  QStringList present;
  for (int i = 0; i < box->count(); ++i) present.append(box->itemText(i));
  if (wanted != present) {
    const QSignalBlocker blocker(box);
    box->clear();
    box->addItems(wanted);
    box->setCurrentIndex(-1);
  }
  showChoice(box, entry);
}

void showText(QLabel* label, const std::string& text) {
  const QString shown = text.empty() ? QString("-") : QString::fromStdString(text);
  if (label->text() != shown) label->setText(shown);
}

void enable(bool enabled, std::initializer_list<QWidget*> widgets) {
  for (QWidget* const widget : widgets) widget->setEnabled(enabled);
}

}  // namespace

PanelWidgets::PanelWidgets(QWidget* parent)
    : play(makeButton("play", "Play", "Let the crowd walk")),
      pause(makeButton("pause", "Pause", "Pause before the next tick")),
      step(makeButton("step", "Step", "Walk this number of ticks while paused")),
      ticks(makeCount("ticks", 1, MOST_TICKS, "Number of ticks of a step")),
      reset(makeButton("reset", "Reset", "Restart the scenario with the same seed")),
      speed(makeExactNumber("speed", ControllerParameters::REAL_TIME_FACTOR.high, 0.5,
                            "Factor of real time; 0: as fast as possible")),
      scenario(makeChoice("scenario", {}, "Scenarios of the controller; a choice loads one")),
      open_scenario(makeButton("open_scenario", "Open...", "Load a scenario file")),
      save_scenario(makeButton("save_scenario", "Save floor as...", "Save what is on the floor as a scenario file")),
      learner(makeChoice("learner", {}, "The learner that the controls below change")),
      mode(makeChoice("mode", {"demo", "training"}, "demo: greedy, the table does not change; training: learns")),
      epsilon(makeNumber("epsilon", 1.0, 4, 0.01, "Probability of a random decision in training mode")),
      alpha(makeNumber("alpha", 1.0, 4, 0.01, "Learning rate")),
      gamma(makeNumber("gamma", 1.0, 4, 0.01, "Discount")),
      save_table(makeButton("save_table", "Save...", "Save the Q-table to a file")),
      load_table(makeButton("load_table", "Load...", "Replace the Q-table by that of a file")),
      share_table(makeButton("share_table", "Share", "Give the table of the shown agent to all agents")),
      share_method(makeChoice("share_method", {"merge", "replace"}, "What receiving agents do with the shared table")),
      state(makeText("state")),
      episode(makeText("episode", "Number of the episode")),
      tick(makeText("tick", "Ticks and simulated time since the start of the episode")),
      success(makeText("success", "Agents that have reached their last goal")),
      contact(makeText("contact", "Agents that were in contact in the episode so far")),
      collision(
          makeText("collision", "Agents that were in collision, as the thesis defines it, in the episode so far")),
      decisions(makeText("decisions", "Decisions of the learners per second of the wall clock")),
      missing(makeText("missing", "Agents that have had no answer of a learner for more than a second")),
      table(makeText("table", "Q-table of the learner")),
      agent(
          makeCount("agent", -1, MOST_AGENTS, "The agent whose radii and sectors are shown; also that of 2D Nav Goal")),
      name_space(named<QLineEdit>("name_space")),
      message(makeText("message", "Result of the last request")) {
  const auto name_ticks = [box = ticks](int count) { box->setSuffix(count == 1 ? " tick" : " ticks"); };
  QObject::connect(ticks, static_cast<void (QSpinBox::*)(int)>(&QSpinBox::valueChanged), ticks, name_ticks);
  name_ticks(ticks->value());
  speed->setSpecialValueText("fast");
  speed->setSuffix(" x real time");
  agent->setSpecialValueText("none");
  share_method->setMinimumContentsLength(5);
  layOut(*this, parent);
}

void PanelWidgets::show(const PanelView& view) {
  enable(view.has_controller, {reset, speed, scenario, open_scenario, save_scenario});
  play->setEnabled(view.can_play);
  pause->setEnabled(view.can_pause);
  enable(view.can_step, {step, ticks});
  enable(view.has_learner, {mode, epsilon, alpha, gamma, save_table, load_table});
  learner->setEnabled(!view.learners.empty());
  enable(view.can_share, {share_table, share_method});
  agent->setEnabled(view.has_markers);

  showNumber(speed, view.speed);
  showChoices(scenario, view.scenarios, view.scenario);
  showChoices(learner, view.learners, view.learner);
  showChoice(mode, view.mode);
  showNumber(epsilon, view.epsilon);
  showNumber(alpha, view.alpha);
  showNumber(gamma, view.gamma);
  showNumber(agent, static_cast<int>(view.chosen_agent));

  showText(state, view.state);
  showText(episode, view.episode);
  showText(tick, view.tick);
  showText(success, view.success);
  showText(contact, view.contact);
  showText(collision, view.collision);
  showText(decisions, view.decisions);
  showText(missing, view.missing);
  showText(table, view.table);
  if (message->text() != QString::fromStdString(view.message)) message->setText(QString::fromStdString(view.message));
  message->setStyleSheet(view.is_error ? "color: #b00020" : "");
}

}  // namespace crowd
