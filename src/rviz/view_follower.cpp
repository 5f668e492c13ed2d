#include "rviz/view_follower.h"

#include <rviz/properties/property.h>
#include <rviz/properties/vector_property.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "ros/markers/marker_scene.h"
#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"

namespace crowd {
namespace {

constexpr double MARGIN = 1.0;       // [m] around the floor
constexpr double LEAST_SCALE = 0.5;  // [pixels/m]
constexpr double MOST_SCALE = 100.0;
constexpr double HALF_FIELD = 22.5 * PI / 180.0;  // half of the vertical field of view of RViz's cameras [rad]

/// Where the middle of a floor is in the target frame of the view [m]; null if the frame is another one.
std::optional<Vector2> placeInTarget(rviz::ViewController& view, const Vector2& middle) {
  const std::string target = view.subProp("Target Frame")->getValue().toString().toStdString();
  if (target == names::CROWD_FRAME) return Vector2(middle - middle.array().round().matrix());
  const bool is_map = target == names::MAP_FRAME || target == "<Fixed Frame>";
  return is_map ? std::optional<Vector2>(middle) : std::nullopt;
}

/// Pixels for each metre with which a floor is in view that is turned by `angle` [rad].
double scaleFor(const Vector2& size, double angle, const QSize& window) {
  const double c = std::abs(std::cos(angle));
  const double s = std::abs(std::sin(angle));
  const double wide = window.width() / (c * size.x() + s * size.y() + 2.0 * MARGIN);
  const double high = window.height() / (s * size.x() + c * size.y() + 2.0 * MARGIN);
  return std::clamp(std::min(wide, high), LEAST_SCALE, MOST_SCALE);
}

void fit(rviz::ViewController& view, const Eigen::AlignedBox2d& floor, const QSize& window) {
  const std::optional<Vector2> place = placeInTarget(view, floor.center());
  if (!place || window.isEmpty()) return;
  if (view.getClassId() == "rviz/TopDownOrtho") {
    const double angle = view.subProp("Angle")->getValue().toDouble();
    view.subProp("X")->setValue(place->x());
    view.subProp("Y")->setValue(place->y());
    view.subProp("Scale")->setValue(scaleFor(floor.sizes(), angle, window));
    return;
  }
  static const QStringList AROUND_A_POINT = {"rviz/Orbit", "rviz/XYOrbit", "rviz/ThirdPersonFollower"};
  if (!AROUND_A_POINT.contains(view.getClassId())) return;
  auto* const focus = dynamic_cast<rviz::VectorProperty*>(view.subProp("Focal Point"));
  if (focus == nullptr) return;
  focus->setVector({static_cast<float>(place->x()), static_cast<float>(place->y()), 0.0F});
  const double height = window.height() / scaleFor(floor.sizes(), 0.0, window);  // of the picture at the focus [m]
  view.subProp("Distance")->setValue(0.5 * height / std::tan(HALF_FIELD));
}

}  // namespace

ViewFollower::ViewFollower(ros::NodeHandle node, rviz::VisualizationManager& manager) : manager_(manager) {
  // RViz calls the callbacks of this queue in its thread. It is ROS's own, which outlives panels and manager.
  node.setCallbackQueue(manager.getUpdateQueue());
  subscriber_ = node.subscribe<social_crowd::Scenario>(names::SCENARIO, SHORT_QUEUE,
                                                       [this](const auto& message) { take(*message); });
}

void ViewFollower::take(const social_crowd::Scenario& scenario) {
  const bool is_other = !scenario_.empty() && scenario.name != scenario_;  // as in crowd_markers, which moves the frame
  scenario_ = scenario.name;
  const Eigen::AlignedBox2d floor = boundsOf(scenario);
  rviz::ViewController* const view = manager_.getViewManager()->getCurrent();
  if (is_other && !floor.isEmpty() && view != nullptr) fit(*view, floor, manager_.getRenderPanel()->size());
}

}  // namespace crowd
