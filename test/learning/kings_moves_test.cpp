#include <gtest/gtest.h>

#include <array>

#include "support/error_of.h"
#include "support/moves.h"
#include "support/parts.h"
#include "support/perceptions.h"

namespace crowd::kings_moves_test {
namespace {

std::string errorIn(const std::string& yaml) {
  return errorOf<InputError>([&] { actionsOf(yaml); });
}

double rotationInDegrees(const ActionSet& actions, Action action) {
  const PerceptionsBuilder scene = PerceptionsBuilder().agent(0, polar(90.0, 3.0));
  return toDegrees(relativeAction(actions, scene.perception(), action).rotation);
}

TEST(KingsMoves, TurnByMultiplesOf45DegreesAtFullSpeed) {
  const auto kings = actionsOf("{type: kings_moves}");
  const ActionSet& moves = *kings;
  ASSERT_EQ(moves.size(), 8U);
  const std::array<double, 8> expected = {0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0};
  for (Action action = 0; action < 8; ++action) {
    EXPECT_NEAR(rotationInDegrees(moves, action), expected.at(action), 1e-9);
    const PerceptionsBuilder scene = PerceptionsBuilder().agent(0, {1.0, 0.0});
    EXPECT_EQ(relativeAction(moves, scene.perception(), action).speed_fraction, 1.0);
  }
}

TEST(KingsMoves, DoNotDependOnThePerception) {
  const auto kings = actionsOf("{type: kings_moves}");
  const ActionSet& moves = *kings;
  const PerceptionsBuilder free = PerceptionsBuilder().agent(0, {1.0, 0.0});
  const PerceptionsBuilder blocked =
      PerceptionsBuilder().agent(1, {-2.0, 5.0}).neighbour({0.5, 0.0}, 0.3).wall({0.0, 1.0}, {1.0, 1.0});
  for (Action action = 0; action < moves.size(); ++action) {
    const RelativeAction one = relativeAction(moves, free.perception(), action);
    const RelativeAction other = relativeAction(moves, blocked.perception(), action);
    EXPECT_EQ(one.rotation, other.rotation);
    EXPECT_EQ(one.speed_fraction, other.speed_fraction);
  }
}

TEST(KingsMoves, AcceptAnyNumberOfRotations) {
  const auto kings = actionsOf("{type: kings_moves, rotations: 3}");
  const ActionSet& moves = *kings;
  ASSERT_EQ(moves.size(), 3U);
  EXPECT_NEAR(rotationInDegrees(moves, 0), 0.0, 1e-9);
  EXPECT_NEAR(rotationInDegrees(moves, 1), 120.0, 1e-9);
  EXPECT_NEAR(rotationInDegrees(moves, 2), 240.0, 1e-9);
}

TEST(KingsMoves, CanIncludeStayingAsTheLastAction) {
  const auto kings = actionsOf("{type: kings_moves, stay: true}");
  const ActionSet& moves = *kings;
  ASSERT_EQ(moves.size(), 9U);
  const PerceptionsBuilder scene = PerceptionsBuilder().agent(0, polar(90.0, 3.0));
  EXPECT_EQ(relativeAction(moves, scene.perception(), 8).rotation, 0.0);
  EXPECT_EQ(relativeAction(moves, scene.perception(), 8).speed_fraction, 0.0);
  const auto without = actionsOf("{type: kings_moves}");
  for (Action action = 0; action < 8; ++action) {
    const RelativeAction one = relativeAction(moves, scene.perception(), action);
    const RelativeAction other = relativeAction(*without, scene.perception(), action);
    EXPECT_EQ(one.rotation, other.rotation);
    EXPECT_EQ(one.speed_fraction, other.speed_fraction);
  }
}

TEST(KingsMoves, StayingIsItsOwnMirrorImage) {
  const auto kings = actionsOf("{type: kings_moves, stay: true}");
  const ActionSet& moves = *kings;
  const std::array<Action, 9> images = {0, 7, 6, 5, 4, 3, 2, 1, 8};
  for (Action action = 0; action < 9; ++action) EXPECT_EQ(moves.mirrored(action), images.at(action));
  const auto three = actionsOf("{type: kings_moves, rotations: 3, stay: true}");
  EXPECT_EQ(three->mirrored(1), 2U);
  EXPECT_EQ(three->mirrored(2), 1U);
  EXPECT_EQ(three->mirrored(3), 3U);
}

TEST(KingsMoves, WriteStayingInTheirSpec) {
  EXPECT_EQ(actionsOf("{type: kings_moves, stay: true}")->spec(), "{type: kings_moves, rotations: 8, stay: true}");
  EXPECT_EQ(actionsOf("{type: kings_moves, rotations: 4, stay: true}")->size(), 5U);
  EXPECT_EQ(actionsOf("{type: kings_moves, stay: false}")->spec(), "{type: kings_moves, rotations: 8}");
  EXPECT_EQ(actionsOf("{type: kings_moves, rotations: 8, stay: true}")->mirrored(8), 8U);
  EXPECT_TRUE(contains(errorIn("{type: kings_moves, stay: often}"), "action_set.stay: expected"));
}

TEST(KingsMoves, TurnToMultiplesInTheMapWithAbsoluteDirections) {
  const auto moves = actionsOf("{type: kings_moves, stay: true, directions: absolute}");
  EXPECT_EQ(moves->spec(), "{type: kings_moves, rotations: 8, stay: true, directions: absolute}");
  EXPECT_FALSE(moves->hasConstantMoves());
  const PerceptionsBuilder scene = PerceptionsBuilder().agent(0, {3.0, 0.0}).heading(30.0);
  EXPECT_NEAR(toDegrees(relativeAction(*moves, scene.perception(), 0).rotation), -30.0, 1e-9);
  EXPECT_NEAR(toDegrees(relativeAction(*moves, scene.perception(), 2).rotation), 60.0, 1e-9);
  EXPECT_EQ(relativeAction(*moves, scene.perception(), 8).rotation, 0.0);  // stays, without turning
  EXPECT_EQ(relativeAction(*moves, scene.perception(), 8).speed_fraction, 0.0);
  EXPECT_EQ(actionsOf("{type: kings_moves, directions: relative}")->spec(), "{type: kings_moves, rotations: 8}");
  EXPECT_TRUE(contains(errorIn("{type: kings_moves, directions: left}"), "expected relative or absolute, got 'left'"));
}

TEST(KingsMoves, ReadBackTheirSpec) {
  EXPECT_EQ(actionsOf("{type: kings_moves}")->spec(), "{type: kings_moves, rotations: 8}");
  EXPECT_EQ(actionsOf("{rotations: 16, type: kings_moves}")->spec(), "{type: kings_moves, rotations: 16}");
  EXPECT_EQ(actionsOf("{type: kings_moves, rotations: 2}")->size(), 2U);
  EXPECT_EQ(actionsOf("{type: kings_moves, rotations: 360}")->size(), 360U);
}

TEST(KingsMoves, ErrorsNameWrongKeysAndValues) {
  EXPECT_TRUE(
      contains(errorIn("{type: queens_moves}"), "expected " + namesOf(actionSetTypes()) + ", got 'queens_moves'"));
  EXPECT_TRUE(contains(errorIn("{rotations: 8}"), "'type' is missing"));
  EXPECT_TRUE(contains(errorIn("{type: kings_moves, rotation: 8}"), "unknown key 'rotation'"));
  for (const char* const rotations : {"1", "0", "-8", "361", "8.0", "many", "[8]", "4294967304"}) {
    const std::string message = errorIn("{type: kings_moves, rotations: " + std::string(rotations) + "}");
    EXPECT_TRUE(contains(message, "action_set.rotations: expected a whole number from 2 to 360")) << message;
  }
}

}  // namespace
}  // namespace crowd::kings_moves_test
