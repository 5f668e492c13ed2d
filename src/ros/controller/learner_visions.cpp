#include "ros/controller/learner_visions.h"

#include <ros/console.h>

#include <string>

#include "geometry/limits.h"
#include "ros/messages/motion_fields.h"
#include "ros/messages/vision.h"

namespace crowd {

void LearnerVisions::report(const std::string& learner, const Vision& vision) {
  const std::string refusal = refusalOf(vision.radius, limits::DISTANCE_OR_0);
  if (!refusal.empty()) {
    ROS_WARN("'%s' requests a vision radius of %g; expected %s. The request is ignored", learner.c_str(), vision.radius,
             refusal.c_str());
    return;
  }
  if (vision.max_neighbours > limits::NEIGHBOURS) {
    ROS_WARN("'%s' requests up to %u neighbours; expected at most %u, or 0 for all. The request is ignored",
             learner.c_str(), vision.max_neighbours, limits::NEIGHBOURS);
    return;
  }
  const double wall_distance = wallDistanceField(vision);
  const std::string wall_refusal = refusalOf(wall_distance, limits::DISTANCE_OR_0);
  if (!wall_refusal.empty()) {
    ROS_WARN("'%s' requests walls up to a distance of %g; expected %s. The request is ignored", learner.c_str(),
             wall_distance, wall_refusal.c_str());
    return;
  }
  const std::string motion_refusal = vision.motion ? refusalOf(*vision.motion) : "";
  if (!motion_refusal.empty()) {
    ROS_WARN("'%s' requests invalid motion limits: %s. The request is ignored", learner.c_str(),
             motion_refusal.c_str());
    return;
  }
  if (vision.radius == 0.0) {
    reported_.erase(learner);
  } else {
    reported_[learner] = vision;
  }
  findWidest();
}

void LearnerVisions::keepMotionOf(const std::set<std::string>& learners) {
  if (learners.empty()) return;
  for (auto& [name, reported] : reported_) {
    if (learners.count(name) == 0) reported.motion.reset();
  }
  findWidest();
}

void LearnerVisions::findWidest() {
  widest_ = reported_.empty() ? Vision() : reported_.begin()->second;
  for (const auto& [name, reported] : reported_) widest_ = crowd::widest(widest_, reported);
}

}  // namespace crowd
