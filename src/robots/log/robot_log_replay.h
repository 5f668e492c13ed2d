#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "robots/log/robot_log.h"
#include "robots/robot_monitor.h"
#include "world/robots.h"

namespace crowd {

/// @brief Measures the robots of a log as those of an episode, with the same RobotMonitor. The caller adds the ticks
/// one after the other; the first one is the start. Contacts that the log does not give are those of the ways in the
/// tick, as in a ghost world.
class RobotLogReplay {
 public:
  RobotLogReplay(const RobotLogHeader& header, const RobotMetricOptions& options);
  RobotLogReplay(const RobotLogReplay&) = delete;
  RobotLogReplay& operator=(const RobotLogReplay&) = delete;
  RobotLogReplay(RobotLogReplay&&) = delete;
  RobotLogReplay& operator=(RobotLogReplay&&) = delete;
  ~RobotLogReplay() = default;

  /// @throws InputError if a robot moves faster than the greatest speed that is permitted, or somebody arrived or is in
  /// contact who has not been among the people so far
  void add(const RobotLogTick& tick);

  const RobotLogHeader& header() const { return header_; }
  /// @brief Whether it has a start.
  bool hasBegun() const { return monitor_.has_value(); }
  /// @brief Number of the last tick, from the start on.
  std::uint64_t tick() const { return tick_; }
  /// @brief What was measured so far; hasBegun() must hold.
  const RobotMonitor& monitor() const { return *monitor_; }
  /// @brief The results by robot; hasBegun() must hold.
  std::vector<RobotResult> results() const;

 private:
  /// What is known of a person.
  struct Known {
    Agent body;
    std::optional<std::uint64_t> last_seen;  // tick
    bool endless = false;
    std::optional<std::uint64_t> arrival;  // tick
  };

  void begin(const RobotLogTick& tick);
  void moveRobots(const RobotLogTick& tick);
  void takePeople(const RobotLogTick& tick);
  void requireKnown(const RobotLogTick& tick) const;
  /// @param was_there in the tick before @return the way in the tick [m]
  Vector2 place(const LoggedPerson& logged, bool was_there, Known& person) const;
  void observe(const RobotLogTick& tick);
  double timeOfPeople() const;

  RobotLogHeader header_;
  RobotMetricOptions options_;
  std::uint64_t tick_ = 0;
  std::uint64_t first_tick_ = 0;
  std::map<AgentId, Known> known_;
  std::vector<Agent> people_;          // those who are there
  std::vector<PersonMotion> motions_;  // of these, in the tick
  std::optional<Robots> robots_;
  WallIndex walls_;
  ObservedScene scene_;
  std::optional<RobotMonitor> monitor_;
};

}  // namespace crowd
