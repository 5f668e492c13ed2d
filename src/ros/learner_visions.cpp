#include "social_crowd/ros/learner_visions.h"

#include <ros/console.h>

#include <cmath>

#include "social_crowd/ros/vision.h"

namespace crowd {

void LearnerVisions::report(const std::string& learner, const Vision& vision) {
  const bool is_valid = std::isfinite(vision.radius) && vision.radius >= 0.0;
  if (!is_valid) {
    ROS_WARN("'%s' requests a vision radius of %g; expected a number of at least 0. The request is ignored",
             learner.c_str(), vision.radius);
    return;
  }
  if (vision.radius == 0.0) {
    reported_.erase(learner);
  } else {
    reported_[learner] = vision;
  }
  widest_ = reported_.empty() ? Vision() : reported_.begin()->second;
  for (const auto& [name, reported] : reported_) widest_ = crowd::widest(widest_, reported);
}

}  // namespace crowd
