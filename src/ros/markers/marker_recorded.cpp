#include "ros/markers/marker_recorded.h"

#include "ros/markers/marker_drawings.h"
#include "ros/markers/marker_style.h"
#include "ros/messages/conversions.h"

namespace crowd {
namespace {

constexpr double STANDING_SPEED = 0.2;  // below, the direction of a recorded velocity is mostly error [m/s]

}  // namespace

void RecordedDrawing::take(const social_crowd::AgentStates& states) {
  people_.agents.clear();
  for (const social_crowd::ObstacleState& obstacle : states.obstacles) {
    if (obstacle.recorded == 0) continue;
    const Vector2 velocity = fromVector3(obstacle.velocity);
    double& heading = headings_[obstacle.obstacle];
    if (velocity.norm() >= STANDING_SPEED) heading = bearingOf(velocity);
    social_crowd::AgentState& person = people_.agents.emplace_back();
    person.agent = obstacle.obstacle;
    person.pose.x = obstacle.position.x;
    person.pose.y = obstacle.position.y;
    person.pose.theta = heading;
    person.radius = obstacle.radius;
    person.status = social_crowd::AgentState::WALKING;
  }
  figures_.take(people_);
}

void RecordedDrawing::clear() {
  headings_.clear();
  figures_.clear();
}

void RecordedDrawing::draw(bool figures, bool whole, visualization_msgs::MarkerArray& array) {
  if (people_.agents.empty() && !is_drawn_) return;
  array.markers.push_back(drawRecordedBodies(people_, figures));
  array.markers.push_back(drawHeadings(people_, figures, marker_style::RECORDED));
  figures_.draw(people_, figures, whole, array);
  is_drawn_ = !people_.agents.empty() || !whole;
}

}  // namespace crowd
