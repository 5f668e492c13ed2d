#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <ros/time.h>

#include <cstdint>
#include <string>

#include "learning/learner.h"

namespace crowd {

/// @brief What a learner has counted until a moment. Two of these, a diagnostic period apart, are compared.
struct LearnerSample {
  ros::WallTime at;
  ros::WallTime last_perceptions;  ///< zero: none yet
  std::uint64_t decisions = 0;     ///< answered since the start of the node
  bool lacks_vision = false;       ///< perceptions have contained less than the model needs for some seconds
  std::string mode;
  std::uint64_t episode = 0;  ///< of the last perceptions
  std::size_t agents = 0;     ///< served
};

/// @brief Decisions per second. WARN while perceptions come that lack the vision of the model.
void reportDecisions(const LearnerSample& before, const LearnerSample& now,
                     diagnostic_updater::DiagnosticStatusWrapper& report);

/// @brief Size and visited rows of the table of an agent, and the learning parameters. WARN if a learner in demo mode
/// has an empty table. Walks through the whole table.
void reportTable(const Learner& learner, AgentId agent, diagnostic_updater::DiagnosticStatusWrapper& report);

}  // namespace crowd
