#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scenario/robot.h"

namespace crowd {

/// @brief Identifier of a publisher of commands, assigned by the owner of the RobotCommands.
using PublisherId = std::uint32_t;

/// @brief Reason why a command is not executed.
enum class CommandRefusal : std::uint8_t {
  NOT_FINITE = 0,       ///< a number is infinite or not a number
  OTHER_PUBLISHER = 1,  ///< another publisher commands the robot
};
constexpr std::size_t COMMAND_REFUSALS = 2;

/// @brief Numbers of commands of one robot in an episode.
struct CommandCounts {
  std::uint64_t taken = 0;
  std::uint64_t timeouts = 0;                             ///< stops because no command arrived for too long
  std::uint64_t missed = 0;                               ///< commands that were awaited in vain
  std::uint64_t late = 0;                                 ///< taken, but after the end of the wait for them
  std::uint64_t newer = 0;                                ///< of those taken: in place of one of the same tick
  std::array<std::uint64_t, COMMAND_REFUSALS> refused{};  ///< by cause
};

/// @brief Settings of RobotCommands.
struct CommandSettings {
  bool lockstep = false;        ///< commands are awaited
  double period = 0.0;          ///< simulated time between two awaited commands [s]; 0: every tick
  int misses_until_absent = 3;  ///< consecutive missed commands until a robot is not awaited any more
};

/// @brief Collects the commands of the robots and decides which one is executed in a tick. It has no clock: its owner
/// decides when to stop waiting. Not thread-safe.
///
/// A command holds from the tick in which it is taken until the next one or the robot's timeout; then the robot is to
/// stop. The publisher whose command was accepted last holds the robot until it has been silent for the timeout;
/// commands of others are refused. In lockstep a robot is awaited from its first command on, until it has missed
/// several in a row, and again from its next command on.
///
/// A command has no number of a tick, so in lockstep the first one after a missed one counts as late: the robot
/// executes it, unless the tick's own command arrives in time and replaces it. A single delay therefore does not
/// shift all later commands by a tick. A tick whose own command does not come then is not counted as missed.
///
/// Of several commands in a tick, the newest one counts.
class RobotCommands {
 public:
  explicit RobotCommands(const CommandSettings& settings) : settings_(settings) {}
  void setMissesUntilAbsent(int misses) { settings_.misses_until_absent = misses; }

  /// @brief Begins an episode: forgets all commands and counts. With the same number of robots, those that were awaited
  /// remain so. @param timeouts of the commands, by robot [s] @param tick_duration [s]
  void begin(const std::vector<double>& timeouts, double tick_duration);

  /// @brief Adds a robot, as the last one. @param timeout of its commands [s]
  void add(double timeout) { records_.emplace_back().timeout = ticksOf(timeout); }
  /// @brief Removes a robot.
  void remove(RobotId robot) { records_.erase(records_.begin() + robot); }

  /// @brief Accepts a command for a tick, or says why it is refused. @throws InputError if there is no such robot
  std::optional<CommandRefusal> take(RobotId robot, const Twist& command, PublisherId publisher, std::uint64_t tick);
  /// @brief The publisher that holds the robot in this tick.
  std::optional<PublisherId> holderOf(RobotId robot, std::uint64_t tick) const;

  /// @brief Whether the tick should wait for a command of the robot.
  bool isAwaited(RobotId robot, std::uint64_t tick) const;
  bool isAnyAwaited(std::uint64_t tick) const;
  /// @brief Whether the robot is not awaited in lockstep because it was never commanded, or is absent.
  bool isUnattended(RobotId robot) const;
  /// @brief Counts the commands that are still awaited as missed. @return the robots that are not awaited any more
  std::vector<RobotId> giveUp(std::uint64_t tick);

  /// @brief The command to execute in this tick; zero if there is none or it has timed out. Called once for each tick.
  Twist commandFor(RobotId robot, std::uint64_t tick);

  const CommandCounts& countsOf(RobotId robot) const { return records_[robot].counts; }

 private:
  struct Record {
    std::uint64_t timeout = 0;  // [ticks]
    Twist command;
    std::optional<std::uint64_t> taken_at;   // tick of the last accepted command
    std::optional<std::uint64_t> missed_at;  // first tick that missed its command since the last accepted one
    std::uint64_t due = 0;                   // tick from which on the next command is awaited
    PublisherId holder = 0;
    bool is_stopped = true;  // timed out, and counted
    bool heard = false;
    bool absent = false;
    int misses = 0;  // consecutive
    CommandCounts counts;
  };

  std::uint64_t ticksOf(double seconds) const;
  std::uint64_t period() const { return std::max<std::uint64_t>(1, ticksOf(settings_.period)); }
  void noteTiming(Record& record, std::uint64_t tick) const;
  std::optional<CommandRefusal> causeOf(const Record& record, const Twist& command, PublisherId publisher,
                                        std::uint64_t tick) const;
  static bool isHeld(const Record& record, std::uint64_t tick);

  CommandSettings settings_;
  double tick_duration_ = 1.0;   // [s]
  std::vector<Record> records_;  // by robot
};

}  // namespace crowd
