#include "rviz/crowd_panel.h"

#include <pluginlib/class_list_macros.hpp>

namespace crowd {
namespace {

constexpr int PERIOD = 50;  // [ms] between two exchanges with the nodes
constexpr const char* SCENARIO_FILES = "Scenario files (*.yaml)";
constexpr const char* TABLE_FILES = "Q-tables (*.txt);;All files (*)";

constexpr auto NUMBER_CHANGED = static_cast<void (QDoubleSpinBox::*)(double)>(&QDoubleSpinBox::valueChanged);
constexpr auto COUNT_CHANGED = static_cast<void (QSpinBox::*)(int)>(&QSpinBox::valueChanged);
constexpr auto CHOSEN = static_cast<void (QComboBox::*)(int)>(&QComboBox::activated);

/// Reads the name of a node; keeps the present one if the setting is not a valid name.
void readName(const rviz::Config& config, const QString& key, QString& name) {
  QString read = name;
  config.mapGetString(key, &read);
  std::string problem;
  if (ros::names::validate(read.toStdString(), problem)) {
    name = read;
  } else {
    ROS_WARN("CrowdPanel, %s: %s", key.toStdString().c_str(), problem.c_str());
  }
}

}  // namespace

CrowdPanel::CrowdPanel(QWidget* parent) : rviz::Panel(parent), widgets_(this) {
  connectNodes();
  connectControls();
  connectFiles();
  QObject::connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  timer_.start(PERIOD);
}

void CrowdPanel::onInitialize() { followView(); }

void CrowdPanel::followView() {
  follower_.reset();
  if (!fits_view_ || vis_manager_ == nullptr) return;
  follower_ = std::make_unique<ViewFollower>(ros::NodeHandle(name_space_), *vis_manager_);
}

void CrowdPanel::connectNodes() {
  std::string name_space = widgets_.name_space->text().trimmed().toStdString();
  std::string problem;
  if (!ros::names::validate(name_space, problem)) name_space.clear();
  widgets_.name_space->setStyleSheet(problem.empty() ? "" : "color: #b00020");
  widgets_.name_space->setToolTip(problem.empty() ? "Namespace of the crowd; empty: that of RViz"
                                                  : QString::fromStdString(problem));
  const ros::NodeHandle node(name_space);
  const std::string controller = node.resolveName(controller_.toStdString());
  const std::string markers = node.resolveName(markers_.toStdString());
  link_.reset();
  model_ = std::make_unique<PanelModel>(controller, markers);
  link_ = std::make_unique<PanelLink>(node, controller, markers);
  if (name_space != name_space_) {
    name_space_ = name_space;
    followView();
  }
}

void CrowdPanel::refresh() {
  link_->exchange(*model_);
  widgets_.show(model_->view(ros::SteadyTime::now().toSec()));
}

void CrowdPanel::connectControls() {
  const PanelWidgets& w = widgets_;
  QObject::connect(w.play, &QPushButton::clicked, this, [this] { model_->play(); });
  QObject::connect(w.pause, &QPushButton::clicked, this, [this] { model_->pause(); });
  QObject::connect(w.step, &QPushButton::clicked, this, [this] { model_->step(widgets_.ticks->value()); });
  QObject::connect(w.reset, &QPushButton::clicked, this, [this] { model_->reset(); });
  QObject::connect(w.ticks, COUNT_CHANGED, this, [this] { Q_EMIT configChanged(); });
  QObject::connect(w.speed, NUMBER_CHANGED, this, [this](double factor) { model_->setSpeed(factor); });
  QObject::connect(w.agent, COUNT_CHANGED, this, [this](int agent) { model_->chooseAgent(agent); });
  QObject::connect(w.scenario, CHOSEN, this,
                   [this] { model_->loadScenario(widgets_.scenario->currentText().toStdString()); });
  QObject::connect(w.learner, CHOSEN, this, [this] {
    model_->chooseLearner(widgets_.learner->currentText().toStdString());
    Q_EMIT configChanged();
  });
  QObject::connect(w.mode, CHOSEN, this, [this] { model_->setMode(widgets_.mode->currentText().toStdString()); });
  for (QDoubleSpinBox* const box : {w.epsilon, w.alpha, w.gamma}) {
    QObject::connect(box, NUMBER_CHANGED, this, [this, name = box->objectName().toStdString()](double value) {
      model_->setParameter(name, value);
    });
  }
  QObject::connect(w.share_table, &QPushButton::clicked, this,
                   [this] { model_->shareTable(widgets_.share_method->currentText().toStdString()); });
  QObject::connect(w.name_space, &QLineEdit::editingFinished, this, [this] {
    if (!widgets_.name_space->isModified()) return;
    widgets_.name_space->setModified(false);
    connectNodes();
    Q_EMIT configChanged();
  });
}

void CrowdPanel::connectFiles() {
  const PanelWidgets& w = widgets_;
  QObject::connect(w.open_scenario, &QPushButton::clicked, this, [this] {
    askFile("Open a scenario", QFileDialog::AcceptOpen, SCENARIO_FILES, "yaml",
            [this](const std::string& file, bool /*exists*/) { model_->loadScenario(file); });
  });
  QObject::connect(w.save_scenario, &QPushButton::clicked, this, [this] {
    askFile("Save the floor as a scenario", QFileDialog::AcceptSave, SCENARIO_FILES, "yaml",
            [this](const std::string& file, bool exists) { model_->saveScenario(file, exists); });
  });
  QObject::connect(w.save_table, &QPushButton::clicked, this, [this] {
    askFile("Save the Q-table", QFileDialog::AcceptSave, TABLE_FILES, "txt",
            [this](const std::string& file, bool exists) { model_->saveTable(file, exists); });
  });
  QObject::connect(w.load_table, &QPushButton::clicked, this, [this] {
    askFile("Load a Q-table", QFileDialog::AcceptOpen, TABLE_FILES, "txt",
            [this](const std::string& file, bool /*exists*/) { model_->loadTable(file); });
  });
}

QString CrowdPanel::startFolder() const {
  if (!folder_.isEmpty()) return folder_;
  const QString data_folder = QString::fromStdString(model_->dataFolder());
  return QDir(data_folder).exists() && !data_folder.isEmpty() ? data_folder : QDir::homePath();
}

void CrowdPanel::askFile(const char* title, QFileDialog::AcceptMode mode, const char* filter, const char* suffix,
                         std::function<void(const std::string& file, bool exists)> take) {
  auto* const dialog = new QFileDialog(this, title, startFolder(), filter);
  dialog->setObjectName("file_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  // A dialog of the desktop has an event loop of its own in some environments, in which RViz does not draw.
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  dialog->setAcceptMode(mode);
  dialog->setFileMode(mode == QFileDialog::AcceptOpen ? QFileDialog::ExistingFile : QFileDialog::AnyFile);
  dialog->setDefaultSuffix(suffix);
  QObject::connect(dialog, &QFileDialog::fileSelected, this, [this, take = std::move(take)](const QString& file) {
    folder_ = QFileInfo(file).absolutePath();
    Q_EMIT configChanged();
    take(file.toStdString(), QFileInfo::exists(file));  // to save, the dialog has asked whether to replace it
  });
  dialog->open();
}

void CrowdPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString name_space;
  QString learner;
  int ticks = widgets_.ticks->value();
  config.mapGetString("Namespace", &name_space);
  readName(config, "Controller", controller_);
  readName(config, "Markers", markers_);
  config.mapGetString("Folder", &folder_);
  config.mapGetString("Learner", &learner);
  config.mapGetInt("Ticks", &ticks);
  config.mapGetBool("Fit view", &fits_view_);
  widgets_.name_space->setText(name_space);
  widgets_.ticks->setValue(ticks);
  connectNodes();
  followView();
  model_->chooseLearner(learner.toStdString());
}

void CrowdPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Namespace", widgets_.name_space->text());
  config.mapSetValue("Controller", controller_);
  config.mapSetValue("Markers", markers_);
  config.mapSetValue("Folder", folder_);
  config.mapSetValue("Learner", QString::fromStdString(model_->chosenLearner()));
  config.mapSetValue("Ticks", widgets_.ticks->value());
  config.mapSetValue("Fit view", fits_view_);
}

}  // namespace crowd

PLUGINLIB_EXPORT_CLASS(crowd::CrowdPanel, rviz::Panel)
