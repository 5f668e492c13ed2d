#pragma once

#include "learning/learner.h"
#include "ros/node/live_parameters.h"

namespace crowd {

/// @brief What may change while a learner runs.
struct LearnerSettings {
  Mode mode = Mode::DEMO;
  LearningPlan plan;  ///< its epsilon as a parameter is the present value; a new one replaces the schedule
};

/// @brief Returns mode and learning parameters, with the names of the parameters of the node where it has them.
LiveParameters<LearnerSettings> liveLearnerParameters();

}  // namespace crowd
