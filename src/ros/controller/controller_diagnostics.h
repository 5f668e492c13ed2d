#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <ros/time.h>
#include <social_crowd/ControllerStatus.h>

#include <cstdint>

#include "robots/robot_commands.h"
#include "ros/controller/answer_collector.h"

namespace crowd {

/// @brief A tick rate below this part of the wanted one is reported.
constexpr double MIN_RATE_SHARE = 0.9;

/// @brief What the crowd controller has counted until a moment. Two of these, a diagnostic period apart, are compared.
struct ControllerSample {
  ros::WallTime at;
  std::uint64_t ticks = 0;      ///< since the start of the node
  std::uint64_t decisions = 0;  ///< since the start of the node
  AnswerCounts answers;         ///< since the start of the node
  CommandCounts commands;       ///< of all robots, of the present episode
  std::size_t robots = 0;       ///< number of robots
  bool paused = false;
  double tick_rate = 0.0;  ///< wanted by the wall clock [Hz]; 0: as fast as possible
  social_crowd::ControllerStatus status;
};

/// @brief Tick rate against the wanted one, and what walks. WARN if it lags behind.
void reportTicks(const ControllerSample& before, const ControllerSample& now,
                 diagnostic_updater::DiagnosticStatusWrapper& report);

/// @brief Missing, dropped and late answers of learners. WARN if there were some, ERROR if agents have no answer for
/// more than a second.
void reportAnswers(const ControllerSample& before, const ControllerSample& now,
                   diagnostic_updater::DiagnosticStatusWrapper& report);

/// @brief Missing, refused and late commands of robots. WARN if there were some.
void reportCommands(const ControllerSample& before, const ControllerSample& now,
                    diagnostic_updater::DiagnosticStatusWrapper& report);

}  // namespace crowd
