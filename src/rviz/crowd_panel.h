#pragma once

#include <rviz/panel.h>

#include <QFileDialog>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <string>

#include "rviz/panel_link.h"
#include "rviz/panel_model.h"
#include "rviz/panel_widgets.h"
#include "rviz/view_follower.h"

namespace crowd {

/// @brief Panel `social_crowd/CrowdPanel` of RViz: controls a crowd and its learners, and shows how they do. PanelModel
/// has its logic, PanelLink its connection with ROS. A timer exchanges both, so that the thread of RViz never waits.
///
/// RViz makes it, and calls load() and save() with its part of the configuration.
class CrowdPanel : public rviz::Panel {
 public:
  explicit CrowdPanel(QWidget* parent = nullptr);

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  /// Connects with the nodes of the present settings.
  void connectNodes();
  /// Begins to fit the view, if the settings say so.
  void followView();
  void connectControls();
  void connectFiles();
  void refresh();
  /// The folder of the last file, else that of the files of the controller, if it is on this machine.
  QString startFolder() const;
  /// Asks for a file without waiting. @param take called with its path, and whether it exists
  void askFile(const char* title, QFileDialog::AcceptMode mode, const char* filter, const char* suffix,
               std::function<void(const std::string& file, bool exists)> take);

  QString controller_ = "crowd_controller";  // settings: names of nodes, in the namespace
  QString markers_ = "crowd_markers";
  QString folder_;  // of the last file; empty: none yet
  PanelWidgets widgets_;
  QTimer timer_;
  std::unique_ptr<PanelModel> model_;
  std::unique_ptr<PanelLink> link_;
  std::string name_space_;                  // a valid one
  bool fits_view_ = true;                   // setting
  std::unique_ptr<ViewFollower> follower_;  // with this setting
};

}  // namespace crowd
