#pragma once

#include <utility>
#include <vector>

#include "robots/log/robot_log_replay.h"

/// Logs of robots that are made by hand.
namespace crowd::robots {

/// A header with one disc robot of 0.3 m, which has a goal with a tolerance of 0.1 m and may drive at 2 m/s.
inline RobotLogHeader headerTo(const Vector2& goal, double tick_duration = 1.0) {
  RobotLogHeader header;
  header.scenario = "by_hand";
  header.tick_duration = tick_duration;
  RobotStart& robot = header.robots.emplace_back();
  robot.name = "robot";
  robot.drive = Drive::EXTERNAL;
  robot.footprint.radius = 0.3;
  robot.limits.max_speed = 2.0;
  robot.goals = {goal};
  robot.goal_tolerance = 0.1;
  return header;
}

/// A tick with one robot. At the start it stands.
inline RobotLogTick tickAt(std::uint64_t tick, const Pose& pose, std::vector<LoggedPerson> people = {}) {
  RobotLogTick made;
  made.tick = tick;
  made.robots.emplace_back().pose = pose;
  if (tick == 0) made.robots.back().velocity = Vector2::Zero();
  made.people = std::move(people);
  return made;
}

inline LoggedPerson personAt(AgentId id, const Vector2& place) {
  LoggedPerson person;
  person.id = id;
  person.position = place;
  return person;
}

/// The result of the first robot.
inline RobotResult scoreOf(const RobotLogHeader& header, const std::vector<RobotLogTick>& ticks,
                           const RobotMetricOptions& options = {}) {
  RobotLogReplay replay(header, options);
  for (const RobotLogTick& tick : ticks) replay.add(tick);
  return replay.results().at(0);
}

/// The same if the robot is at these poses at the ends of the ticks.
inline RobotResult scoreOf(const RobotLogHeader& header, const std::vector<Pose>& poses,
                           const RobotMetricOptions& options = {}) {
  std::vector<RobotLogTick> ticks;
  for (const Pose& pose : poses) ticks.push_back(tickAt(ticks.size(), pose));
  return scoreOf(header, ticks, options);
}

}  // namespace crowd::robots
