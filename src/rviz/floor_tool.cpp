#include "rviz/floor_tool.h"

#include <OgrePlane.h>
#include <OgrePose.h>
#include <OgreQuaternion.h>
#include <OgreVector3.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/geometry.h>
#include <rviz/ogre_helpers/billboard_line.h>
#include <rviz/viewport_mouse_event.h>

#include <algorithm>

#include "ros/messages/names.h"

namespace crowd {
namespace {

constexpr float LINE_WIDTH = 0.05F;  // [m]
constexpr float HEIGHT = 0.06F;      // above the floor, so that bodies do not hide the lines [m]

}  // namespace

FloorTool::FloorTool(const QString& name, const QString& help)
    : name_(name),
      help_(help),
      controller_(new rviz::StringProperty("Controller", "crowd_controller", "Name of the crowd controller",
                                           getPropertyContainer())),
      line_(std::make_unique<ServiceLine>()) {}

FloorTool::~FloorTool() { line_.reset(); }

void FloorTool::onInitialize() {
  setName(name_);
  lines_ = std::make_unique<rviz::BillboardLine>(scene_manager_);
  lines_->setColor(0.1F, 0.45F, 0.9F, 1.0F);
  lines_->setLineWidth(LINE_WIDTH);
}

void FloorTool::activate() { setStatus(help_); }

void FloorTool::deactivate() { abandon(); }

void FloorTool::abandon() {
  from_.reset();
  lines_->clear();
}

void FloorTool::say(const std::string& text) { setStatus(QString::fromStdString(text)); }

std::optional<std::string> FloorTool::controllerName() {
  const std::string name = controller_->getStdString();
  std::string problem;
  if (ros::names::validate(name, problem)) return ros::NodeHandle().resolveName(name);
  tell(false, "Controller: " + problem);
  return std::nullopt;
}

void FloorTool::tell(bool success, const std::string& message) {
  if (!success) ROS_WARN("%s: %s", name_.toStdString().c_str(), message.c_str());
  const std::lock_guard<std::mutex> lock(mutex_);
  answer_ = (success ? "" : "refused: ") + message;
}

void FloorTool::update(float /*wall_dt*/, float /*ros_dt*/) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (answer_) say(*answer_);
  answer_.reset();
}

std::optional<Vector2> FloorTool::pointAt(Ogre::Viewport* viewport, int x, int y) const {
  Ogre::Vector3 origin;
  Ogre::Quaternion turn;
  if (!context_->getFrameManager()->getTransform(names::MAP_FRAME, ros::Time(), origin, turn)) return std::nullopt;
  Ogre::Plane floor(turn * Ogre::Vector3::UNIT_Z, origin);
  Ogre::Vector3 point;
  if (!rviz::getPointOnPlaneFromWindowXY(viewport, floor, x, y, point)) return std::nullopt;
  const Ogre::Vector3 in_map = turn.Inverse() * (point - origin);
  return Vector2(in_map.x, in_map.y);
}

void FloorTool::draw(const FloorOutline& outline) {
  Ogre::Vector3 origin;
  Ogre::Quaternion turn;
  context_->getFrameManager()->getTransform(names::MAP_FRAME, ros::Time(), origin, turn);
  lines_->clear();
  lines_->setPosition(origin);
  lines_->setOrientation(turn);
  lines_->setNumLines(static_cast<std::uint32_t>(std::max<std::size_t>(1, outline.size())));
  std::size_t most = 2;
  for (const std::vector<Vector2>& line : outline) most = std::max(most, line.size());
  lines_->setMaxPointsPerLine(static_cast<std::uint32_t>(most));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (i > 0) lines_->newLine();
    for (const Vector2& point : outline[i]) {
      lines_->addPoint({static_cast<float>(point.x()), static_cast<float>(point.y()), HEIGHT});
    }
  }
}

int FloorTool::processMouseEvent(rviz::ViewportMouseEvent& event) {
  const std::optional<Vector2> point = pointAt(event.viewport, event.x, event.y);
  if (event.rightDown()) abandon();
  if (!point && event.leftUp()) abandon();
  if (!point) return Render;
  if (event.leftDown()) from_ = point;
  if (!from_) return 0;
  const Vector2 from = *from_;
  if (event.leftUp()) {
    abandon();
    finish(from, *point);
  } else {
    draw(outline(from, *point));
  }
  return Render;
}

}  // namespace crowd
