#include "robots/robot_commands.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include "social_crowd/errors.h"

namespace crowd::robot_commands_test {
namespace {

constexpr PublisherId JOYSTICK = 0;
constexpr PublisherId PLANNER = 1;

Twist forward(double speed) { return {{speed, 0.0}, 0.0}; }

/// Commands of robots with a timeout of 0.5 s, in ticks of 0.1 s.
RobotCommands makeCommands(bool lockstep = false, std::size_t robots = 1, double period = 0.0) {
  CommandSettings settings;
  settings.lockstep = lockstep;
  settings.period = period;
  settings.misses_until_absent = 2;
  RobotCommands commands(settings);
  commands.begin(std::vector<double>(robots, 0.5), 0.1);
  return commands;
}

std::vector<double> speeds(RobotCommands& commands, std::uint64_t from, std::uint64_t to) {
  std::vector<double> speeds;
  for (std::uint64_t tick = from; tick < to; ++tick) speeds.push_back(commands.commandFor(0, tick).linear.x());
  return speeds;
}

TEST(RobotCommands, ACommandHoldsUntilItsTimeout) {
  RobotCommands commands = makeCommands();
  EXPECT_EQ(speeds(commands, 0, 2), (std::vector<double>{0.0, 0.0}));
  EXPECT_FALSE(commands.take(0, forward(1.0), JOYSTICK, 2));
  EXPECT_EQ(speeds(commands, 2, 9), (std::vector<double>{1.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0}));
  EXPECT_EQ(commands.countsOf(0).timeouts, 1U);
  EXPECT_FALSE(commands.take(0, forward(0.5), JOYSTICK, 9));
  EXPECT_EQ(speeds(commands, 9, 10), (std::vector<double>{0.5}));
  EXPECT_EQ(commands.countsOf(0).taken, 2U);
}

TEST(RobotCommands, ATimeoutOfSomeTicksIsExact) {
  for (int ticks = 1; ticks < 100; ++ticks) {
    SCOPED_TRACE(ticks);
    RobotCommands commands = makeCommands();
    commands.begin({0.1 * ticks}, 0.1);
    commands.take(0, forward(1.0), JOYSTICK, 0);
    EXPECT_EQ(commands.commandFor(0, static_cast<std::uint64_t>(ticks) - 1).linear.x(), 1.0);
    EXPECT_EQ(commands.commandFor(0, static_cast<std::uint64_t>(ticks)).linear.x(), 0.0);
  }
}

TEST(RobotCommands, WithoutLockstepTheLastOneCounts) {
  RobotCommands commands = makeCommands();
  EXPECT_FALSE(commands.take(0, forward(1.0), JOYSTICK, 0));
  EXPECT_FALSE(commands.take(0, forward(0.5), JOYSTICK, 0));
  EXPECT_EQ(speeds(commands, 0, 1), (std::vector<double>{0.5}));
  EXPECT_FALSE(commands.isAwaited(0, 1));
}

TEST(RobotCommands, InLockstepTheNewestOneCountsAndTheNextTickWaitsForItsOwn) {
  RobotCommands commands = makeCommands(true);
  EXPECT_FALSE(commands.take(0, forward(1.0), JOYSTICK, 0));
  EXPECT_FALSE(commands.take(0, forward(0.5), JOYSTICK, 0));
  EXPECT_FALSE(commands.take(0, forward(0.7), JOYSTICK, 0));
  EXPECT_EQ(speeds(commands, 0, 1), (std::vector<double>{0.7}));
  EXPECT_EQ(commands.countsOf(0).taken, 3U);
  EXPECT_EQ(commands.countsOf(0).newer, 2U);
  EXPECT_FALSE(commands.isAwaited(0, 0));
  EXPECT_TRUE(commands.isAwaited(0, 1));
}

TEST(RobotCommands, NumbersMustBeFinite) {
  RobotCommands commands = makeCommands();
  EXPECT_FALSE(commands.take(0, forward(1.0), JOYSTICK, 0));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(commands.take(0, {{bad, 0.0}, 0.0}, JOYSTICK, 1), CommandRefusal::NOT_FINITE);
    EXPECT_EQ(commands.take(0, {{0.0, bad}, 0.0}, JOYSTICK, 1), CommandRefusal::NOT_FINITE);
    EXPECT_EQ(commands.take(0, {{0.0, 0.0}, bad}, JOYSTICK, 1), CommandRefusal::NOT_FINITE);
  }
  EXPECT_EQ(commands.countsOf(0).refused[0], 6U);
  EXPECT_EQ(speeds(commands, 4, 6), (std::vector<double>{1.0, 0.0}));  // that of tick 0 times out
}

TEST(RobotCommands, APublisherHoldsTheRobotUntilItIsSilent) {
  RobotCommands commands = makeCommands();
  EXPECT_FALSE(commands.take(0, forward(1.0), JOYSTICK, 0));
  EXPECT_EQ(commands.take(0, forward(0.5), PLANNER, 4), CommandRefusal::OTHER_PUBLISHER);
  EXPECT_EQ(commands.holderOf(0, 4), JOYSTICK);
  EXPECT_EQ(commands.holderOf(0, 5), std::nullopt);
  EXPECT_FALSE(commands.take(0, forward(0.5), PLANNER, 5));
  EXPECT_EQ(commands.take(0, forward(1.0), JOYSTICK, 6), CommandRefusal::OTHER_PUBLISHER);
  EXPECT_EQ(commands.countsOf(0).refused[1], 2U);
}

TEST(RobotCommands, InLockstepARobotIsAwaitedFromItsFirstCommandOn) {
  RobotCommands commands = makeCommands(true, 2);
  EXPECT_FALSE(commands.isAnyAwaited(0));
  commands.take(1, forward(1.0), JOYSTICK, 0);
  EXPECT_FALSE(commands.isAwaited(1, 0));
  EXPECT_TRUE(commands.isAwaited(1, 1));
  EXPECT_FALSE(commands.isAwaited(0, 1));
  EXPECT_TRUE(commands.isAnyAwaited(1));
  commands.take(1, forward(1.0), JOYSTICK, 1);
  EXPECT_FALSE(commands.isAnyAwaited(1));
}

TEST(RobotCommands, ARobotThatMissesSeveralInARowIsAbsent) {
  RobotCommands commands = makeCommands(true);
  commands.take(0, forward(1.0), JOYSTICK, 0);
  EXPECT_TRUE(commands.giveUp(1).empty());
  commands.take(0, forward(1.0), JOYSTICK, 2);
  EXPECT_TRUE(commands.giveUp(2).empty());  // nothing was missed
  EXPECT_TRUE(commands.giveUp(3).empty());
  EXPECT_EQ(commands.giveUp(4), std::vector<RobotId>{0});
  EXPECT_FALSE(commands.isAwaited(0, 5));
  EXPECT_TRUE(commands.giveUp(5).empty());
  EXPECT_EQ(commands.countsOf(0).missed, 3U);
  commands.take(0, forward(1.0), JOYSTICK, 6);
  EXPECT_TRUE(commands.isAwaited(0, 7));
}

TEST(RobotCommands, ALateCommandDoesNotShiftThoseThatFollow) {
  RobotCommands commands = makeCommands(true);
  commands.take(0, forward(0.1), JOYSTICK, 0);
  EXPECT_TRUE(commands.isAwaited(0, 1));
  commands.giveUp(1);
  EXPECT_FALSE(commands.take(0, forward(0.2), JOYSTICK, 2));  // that of tick 1
  EXPECT_EQ(commands.countsOf(0).late, 1U);
  EXPECT_TRUE(commands.isAwaited(0, 2));
  EXPECT_FALSE(commands.take(0, forward(0.3), JOYSTICK, 2));  // that of tick 2
  EXPECT_FALSE(commands.isAwaited(0, 2));
  EXPECT_EQ(commands.countsOf(0).newer, 0U);
  EXPECT_FALSE(commands.take(0, forward(0.4), JOYSTICK, 2));
  EXPECT_EQ(speeds(commands, 2, 3), std::vector<double>{0.4});
  EXPECT_EQ(commands.countsOf(0).taken, 4U);
  EXPECT_EQ(commands.countsOf(0).newer, 1U);
  EXPECT_EQ(commands.countsOf(0).late, 1U);
  EXPECT_EQ(commands.countsOf(0).missed, 1U);
}

TEST(RobotCommands, ALateCommandIsExecutedIfNoOtherOneComes) {
  RobotCommands commands = makeCommands(true);
  commands.take(0, forward(0.1), JOYSTICK, 0);
  commands.giveUp(1);
  commands.take(0, forward(0.2), JOYSTICK, 2);
  EXPECT_TRUE(commands.giveUp(2).empty());
  EXPECT_EQ(speeds(commands, 2, 3), std::vector<double>{0.2});
  EXPECT_EQ(commands.countsOf(0).missed, 1U);
  EXPECT_FALSE(commands.take(0, forward(0.3), JOYSTICK, 3));  // not late: the one of tick 2 will not come
  EXPECT_FALSE(commands.isAwaited(0, 3));
  EXPECT_EQ(commands.countsOf(0).late, 1U);
}

TEST(RobotCommands, ALateCommandOfASlowControllerKeepsThePeriod) {
  RobotCommands commands = makeCommands(true, 1, 0.3);
  commands.take(0, forward(0.1), JOYSTICK, 10);
  commands.giveUp(13);
  commands.take(0, forward(0.2), JOYSTICK, 14);
  EXPECT_EQ(commands.countsOf(0).late, 1U);
  EXPECT_FALSE(commands.isAwaited(0, 15));
  EXPECT_TRUE(commands.isAwaited(0, 16));
}

TEST(RobotCommands, TheFirstCommandOfAnAbsentRobotIsNotLate) {
  RobotCommands commands = makeCommands(true);
  commands.take(0, forward(0.1), JOYSTICK, 0);
  commands.giveUp(1);
  commands.giveUp(2);
  commands.take(0, forward(0.2), JOYSTICK, 9);
  EXPECT_EQ(commands.countsOf(0).late, 0U);
  EXPECT_FALSE(commands.isAwaited(0, 9));
  EXPECT_TRUE(commands.isAwaited(0, 10));
}

TEST(RobotCommands, ARobotIsUnattendedBeforeItsFirstCommandAndWhileItIsAbsent) {
  RobotCommands commands = makeCommands(true);
  EXPECT_TRUE(commands.isUnattended(0));
  commands.take(0, forward(1.0), JOYSTICK, 0);
  EXPECT_FALSE(commands.isUnattended(0));
  commands.giveUp(1);
  EXPECT_FALSE(commands.isUnattended(0));
  commands.giveUp(2);
  EXPECT_TRUE(commands.isUnattended(0));
  commands.take(0, forward(1.0), JOYSTICK, 3);
  EXPECT_FALSE(commands.isUnattended(0));
  EXPECT_FALSE(makeCommands().isUnattended(0));  // commands are not awaited at all
}

TEST(RobotCommands, ASlowControllerIsAwaitedOncePerPeriod) {
  RobotCommands commands = makeCommands(true, 1, 0.3);
  commands.take(0, forward(1.0), JOYSTICK, 10);
  EXPECT_FALSE(commands.isAwaited(0, 11));
  EXPECT_FALSE(commands.isAwaited(0, 12));
  EXPECT_TRUE(commands.isAwaited(0, 13));
}

TEST(RobotCommands, AnEpisodeForgetsCommandsAndKeepsWhoIsAwaited) {
  RobotCommands commands = makeCommands(true);
  commands.take(0, forward(1.0), JOYSTICK, 0);
  commands.begin({0.5}, 0.1);
  EXPECT_EQ(speeds(commands, 0, 1), (std::vector<double>{0.0}));
  EXPECT_EQ(commands.countsOf(0).taken, 0U);
  EXPECT_TRUE(commands.isAwaited(0, 0));
  EXPECT_FALSE(commands.take(0, forward(1.0), PLANNER, 0));
  commands.begin({0.5, 0.5}, 0.1);  // other robots
  EXPECT_FALSE(commands.isAnyAwaited(0));
}

TEST(RobotCommands, RefusesAnUnknownRobot) {
  RobotCommands commands = makeCommands();
  EXPECT_THROW(commands.take(1, forward(1.0), JOYSTICK, 0), InputError);
}

}  // namespace
}  // namespace crowd::robot_commands_test
