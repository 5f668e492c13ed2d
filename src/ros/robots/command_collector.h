#pragma once

#include <geometry_msgs/Twist.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "robots/robot_commands.h"
#include "ros/node/main_loop.h"
#include "ros/robots/robot_parameters.h"
#include "simulation/episode.h"

namespace crowd {

/// @brief Collects the commands of all robots in each tick and hands them to the episode. The owner calls begin() for
/// each episode, then ask() and wait() in each tick. All functions run in the main loop, which wait() serves.
class CommandCollector {
 public:
  /// Commands by robot.
  using Commands = std::map<RobotId, Twist>;

  /// @param parameters of the owner; ~command_deadline and ~misses_until_absent may change between two calls
  CommandCollector(MainLoop& loop, const RobotParameters& parameters);

  /// @brief Begins an episode, which must outlive the next call; a wait() in progress ends.
  void begin(Episode& episode);
  /// @brief A robot has been added to the world, as the last one.
  void add(const RobotStart& start) { commands_.add(start.cmd_timeout); }
  /// @brief A robot has been removed from the world. @param robot its former id
  void remove(RobotId robot);
  /// @brief Whether commands are held, so that robots must not change.
  bool isHolding() const { return held_.has_value(); }
  /// @brief The robots are other ones: warnings are repeated.
  void forgetWarnings() {
    warned_.clear();
    warned_of_lateness_.clear();
    abandoned_.clear();
  }
  /// @brief Whether nobody will command a robot any more, because its controller has crashed.
  void abandon(RobotId robot, bool abandoned) { abandoned_[robot] = abandoned; }
  /// @brief Takes a command from a topic. @param node that published it
  void take(RobotId robot, const Twist& command, const std::string& node);
  const CommandCounts& countsOf(RobotId robot) const { return commands_.countsOf(robot); }

  /// @brief Sum of all robots, of the present episode.
  CommandCounts totals() const;

  /// @brief The commands of the coming tick are awaited from now on.
  void ask();
  /// @brief Serves the main loop until no command is awaited any more, or for ~command_deadline, and hands the commands
  /// to the episode. @return false if another episode has begun or the node shuts down
  bool wait();
  /// @brief Waits for the answers to the last scans of an episode, so that the next one does not take them for its own.
  /// @return false if another episode has begun or the node shuts down
  bool awaitLast();
  /// @brief Whether a robot that is on its way to a goal has no controller in lockstep: it starts, or is absent, but is
  /// not abandoned.
  bool isAnyUnattended() const;

  /// @brief Commands by the names of robots. @throws InputError that names what is wrong, or if there are no robots
  Commands commandsOf(const std::vector<std::string>& names, const std::vector<geometry_msgs::Twist>& commands) const;
  /// @brief From now on these commands are executed instead of those from topics, and none is awaited.
  void hold(const Commands& commands) { held_ = commands; }
  /// @brief Ends that.
  void release() { held_.reset(); }

 private:
  using Clock = ros::WallTime;

  const std::vector<Robot>& robots() const { return episode_->world().robots().list(); }
  std::uint64_t tick() const { return episode_->world().tick(); }
  PublisherId numberOf(const std::string& node);
  void warnOfRefusal(RobotId robot, CommandRefusal cause, const std::string& node);
  void warnOfLateness(RobotId robot, const std::string& node);
  void warnOfAbsence(const std::vector<RobotId>& absent) const;
  Twist commandFor(RobotId robot);
  bool await();

  MainLoop& loop_;
  const RobotParameters& parameters_;
  Episode* episode_ = nullptr;
  RobotCommands commands_;
  std::optional<Commands> held_;
  std::vector<std::string> publishers_;  // of commands; the index is the PublisherId
  std::set<std::tuple<RobotId, CommandRefusal, PublisherId>> warned_;
  std::set<RobotId> warned_of_lateness_;
  std::map<RobotId, bool> abandoned_;
  bool cancelled_ = false;
  Clock wait_until_;
};

}  // namespace crowd
