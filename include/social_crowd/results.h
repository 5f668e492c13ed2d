#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "social_crowd/robot_result.h"

namespace crowd {

/// @brief Results of one agent in an episode. A new field also belongs in one of the functions below;
/// `scripts/generate metrics` writes AgentResult.msg from the comments.
struct AgentResult {
  bool arrived = false;             ///< reached its last goal in time
  bool removed = false;             ///< removed before it arrived; excluded from all metrics
  bool touched = false;             ///< in contact in any tick before it arrived
  bool collided = false;            ///< in collision (thesis, 4.1) in any tick before it arrived
  bool out_of_reach = false;        ///< on its way at the end, and no way leads to its goal
  bool endless = false;             ///< on a route that repeats: it never arrives, and has not failed
  std::uint64_t waypoints = 0;      ///< waypoints of routes that it has left behind
  std::uint64_t blocked_moves = 0;  ///< moves that were cut short at a contact; 0 in a ghost world
  std::uint64_t appeared = 0;       ///< tick at which it was added to the world
  double start_x = 0.0;             ///< place where it was added [m], `map`
  double start_y = 0.0;
  std::uint64_t ticks = 0;       ///< since it appeared, until its arrival, or until the end
  double heading = 0.0;          ///< at its arrival, or at the end [rad], `map`
  double path_length = 0.0;      ///< walked [m]
  double straight_length = 0.0;  ///< from the start via all goals, minus the goal tolerance [m]
  double path_ratio = 0.0;       ///< path_length / straight_length
  double time_ratio = 0.0;       ///< time * maximum speed / straight_length
  double turn_per_metre = 0.0;   ///< summed change of the direction of motion per metre walked [rad/m]
  double max_speed_ratio = 0.0;  ///< fastest tick / maximum speed
  double distance_gained = 0.0;  ///< decrease of the distance to the goal, summed over its goals [m]
  double gain_per_tick = 0.0;    ///< distance gained per step (thesis, 4.1): distance_gained / ticks [m]
  double path_per_gain = 0.0;    ///< path per distance gained (thesis, 4.1); NaN if distance_gained is not positive

  /// @brief Calls visit(name, field...) for each field that records and AgentResult.msg have; with several objects,
  /// such as a result and its message, for the field of all.
  template <typename Visit, typename... Results>
  static void visitMeasures(const Visit& visit, Results&... results) {
    visit("arrived", results.arrived...);
    visit("touched", results.touched...);
    visit("collided", results.collided...);
    visit("blocked_moves", results.blocked_moves...);
    visit("ticks", results.ticks...);
    visit("path_length", results.path_length...);
    visit("path_ratio", results.path_ratio...);
    visit("time_ratio", results.time_ratio...);
    visit("turn_per_metre", results.turn_per_metre...);
    visit("distance_gained", results.distance_gained...);
    visit("gain_per_tick", results.gain_per_tick...);
    visit("path_per_gain", results.path_per_gain...);
  }

  /// @brief The same for all fields.
  template <typename Visit, typename AResult>
  static void visitFields(const Visit& visit, AResult& result) {
    visitMeasures(visit, result);
    visit("removed", result.removed);
    visit("out_of_reach", result.out_of_reach);
    visit("endless", result.endless);
    visit("waypoints", result.waypoints);
    visit("appeared", result.appeared);
    visit("start_x", result.start_x);
    visit("start_y", result.start_y);
    visit("heading", result.heading);
    visit("straight_length", result.straight_length);
    visit("max_speed_ratio", result.max_speed_ratio);
  }
};

/// @brief Numbers of the agents of an episode that were not removed; metrics are about these.
struct EpisodeCounts {
  std::size_t agents = 0;
  std::size_t arrived = 0;
  std::size_t expected = 0;  ///< to arrive: without agents on routes that repeat
  std::size_t touched = 0;
  std::size_t collided = 0;
  std::uint64_t blocked_moves = 0;  ///< sum of all of them
  /// @brief Whether all expected agents arrived, and none was in contact.
  bool isClean() const { return arrived == expected && touched == 0; }
};

namespace library {

using crowd::AgentResult;
using crowd::EpisodeCounts;
using crowd::RobotGoalResult;
using crowd::RobotInput;
using crowd::RobotResult;

/// @brief Results of an episode, or of the part of it that has been walked.
struct EpisodeResult {
  std::string scenario;
  std::uint64_t ticks = 0;
  EpisodeCounts count;
  std::vector<AgentResult> agents;  ///< by id
  std::vector<RobotResult> robots;  ///< in the order of the scenario
  std::string way_finding_problem;  ///< why way-finding was left out from some tick on; empty: it was not
};

}  // namespace library
}  // namespace crowd
