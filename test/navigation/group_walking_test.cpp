#include "navigation/group_walking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "support/floors.h"
#include "support/scenes.h"
#include "world/world_editor.h"

namespace crowd::group_walking_test {
namespace {

constexpr double RADIUS = 0.2;
constexpr double SPACING = GroupWalking::SPACING;
constexpr GroupId GROUP = 0;

/// A member of the group that walks along the x axis, far from its goal.
AgentStart member(double x, double y, double speed = 1.0) {
  AgentStart start = scenes::agent({x, y}, {100.0, y}, speed, RADIUS);
  start.group = GROUP;
  return start;
}

/// Somebody else.
AgentStart stranger(double x, double y) { return scenes::agent({x, y}, {-100.0, y}, 1.0, RADIUS); }

/// The first decision about these agents. Ticks of 0.5 s, longer than the time between two decisions.
class Decision {
 public:
  explicit Decision(std::vector<AgentStart> agents, const FloorRuler* floor = nullptr)
      : world(scenes::halfSeconds(scenes::scene(std::move(agents)))) {
    groups.update(world, {}, floor);
  }
  const Agent& agent(AgentId id) const { return world.agents()[id]; }
  /// How far to the left of its way an agent is to walk [m].
  double shiftOf(AgentId id) {
    const Vector2 next = agent(id).goal();
    const auto aim = groups.aimOf(agent(id), next);
    return aim ? aim->y() - agent(id).pose.position.y() : 0.0;
  }
  double speedOf(AgentId id) const { return agent(id).wanted_speed; }

  World world;
  GroupWalking groups;
};

/// At (0, 0) and (0, 2): 1.05 m farther apart than they are to be, by which each comes nearer.
TEST(GroupWalking, APairWalksSideBySide) {
  Decision pair({member(0.0, 0.0), member(0.0, 2.0)});
  EXPECT_NEAR(pair.shiftOf(0), 0.5 * (2.0 - SPACING), 1e-12);
  EXPECT_NEAR(pair.shiftOf(1), -0.5 * (2.0 - SPACING), 1e-12);
  EXPECT_NEAR(pair.speedOf(0), 1.0 - GroupWalking::SIZE_SLOWDOWN, 1e-12);
  EXPECT_EQ(pair.speedOf(0), pair.speedOf(1));
}

TEST(GroupWalking, ThePaceIsThatOfTheSlowest) {
  const Decision pair({member(0.0, 0.0, 1.5), member(0.0, SPACING, 0.8)});
  EXPECT_NEAR(pair.speedOf(0), 0.8 - GroupWalking::SIZE_SLOWDOWN, 1e-12);
  EXPECT_NEAR(pair.speedOf(1), 0.8 - GroupWalking::SIZE_SLOWDOWN, 1e-12);
}

/// One is 1 m ahead of the other: 0.5 m ahead of the mean, 0.6 / s times that slower.
TEST(GroupWalking, WhoIsAheadWaits) {
  const Decision pair({member(1.0, 0.0), member(0.0, SPACING)});
  EXPECT_NEAR(pair.speedOf(0), 0.94 - 0.3, 1e-12);
  EXPECT_NEAR(pair.speedOf(1), 1.15, 1e-12);  // the greatest share of its own speed
  const Decision far_apart({member(9.0, 0.0), member(0.0, SPACING)});
  EXPECT_NEAR(far_apart.speedOf(0), 0.2 * 0.94, 1e-12);
}

TEST(GroupWalking, TheMembersKeepTheirOrder) {
  Decision three({member(0.0, 1.0), member(0.0, -1.2), member(0.0, 0.2)});
  EXPECT_NEAR(1.0 + three.shiftOf(0), SPACING, 1e-12);
  EXPECT_NEAR(-1.2 + three.shiftOf(1), -SPACING, 1e-12);
  EXPECT_NEAR(0.2 + three.shiftOf(2), 0.0, 1e-12);
}

/// Eight others within 3 m of the place 3 m ahead: 0.28 per m2, at which the V is bent fully, by 0.6 rad.
TEST(GroupWalking, AmongOthersThreeWalkInAV) {
  std::vector<AgentStart> agents = {member(0.0, -SPACING), member(0.0, 0.0), member(0.0, SPACING)};
  for (int i = 0; i < 8; ++i) agents.push_back(stranger(2.0 + 0.5 * i, i % 2 == 0 ? 1.0 : -1.0));
  Decision three(agents);
  const double outer = SPACING * std::cos(0.6);
  EXPECT_NEAR(-SPACING + three.shiftOf(0), -outer, 1e-12);
  EXPECT_NEAR(three.shiftOf(1), 0.0, 1e-12);
  const double lead = SPACING * std::sin(0.6) / 3.0;  // of the outer ones; the middle one is behind by twice that
  const double speed = 1.0 - 2.0 * GroupWalking::SIZE_SLOWDOWN;
  EXPECT_NEAR(three.speedOf(0), speed + 0.6 * lead, 1e-12);
  EXPECT_NEAR(three.speedOf(1), speed - 0.6 * 2.0 * lead, 1e-12);
}

/// Two rows: the three in front, and the one who was behind.
TEST(GroupWalking, FiveWalkInRows) {
  Decision five({member(0.0, 0.0), member(0.0, 1.0), member(0.0, 2.0), member(-1.0, 0.2), member(-1.0, 1.8)});
  EXPECT_NEAR(five.shiftOf(0) + 0.0, 1.0 - SPACING, 1e-12);
  EXPECT_NEAR(five.shiftOf(2) + 2.0, 1.0 + SPACING, 1e-12);
  EXPECT_NEAR(five.shiftOf(3) + 0.2, 1.0 - 0.5 * SPACING, 1e-12);
  EXPECT_EQ(five.speedOf(0), five.speedOf(3));  // the rows are 1 m apart, as they are to be
}

/// A corridor in which one disc fits beside another, but not at that distance.
TEST(GroupWalking, InNarrowCorridorsTheyWalkInFile) {
  const FloorPlan floor = floors::room({-50.0, -0.6}, {50.0, 0.6});
  const FloorRuler ruler(floor, 2.0);
  Decision pair({member(0.5, 0.3), member(0.0, -0.3)}, &ruler);
  EXPECT_NEAR(pair.shiftOf(0), -0.3, 1e-12);
  EXPECT_NEAR(pair.shiftOf(1), 0.3, 1e-12);
  EXPECT_GT(pair.speedOf(0), pair.speedOf(1));  // until they are 1 m apart
}

/// A corridor of 2.4 m: room for two, and for one if somebody comes towards them, who gets the other half.
TEST(GroupWalking, ThoseWhoComeTowardsThemGetHalfOfTheFloor) {
  const FloorPlan floor = floors::room({-50.0, -1.2}, {50.0, 1.2});
  const FloorRuler ruler(floor, 2.0);
  const std::vector<AgentStart> pair = {member(0.5, 0.8), member(0.0, -0.8)};
  std::vector<AgentStart> with_stranger = pair;
  with_stranger.push_back(stranger(4.0, 0.0));
  Decision alone(pair, &ruler);
  Decision standing(with_stranger, &ruler);
  with_stranger.back().velocity = {-1.0, 0.0};
  Decision oncoming(with_stranger, &ruler);
  EXPECT_NEAR(alone.shiftOf(0), 0.5 * SPACING - 0.8, 1e-12);
  EXPECT_NEAR(standing.shiftOf(0), alone.shiftOf(0), 0.01);  // the V is hardly bent
  EXPECT_NEAR(oncoming.shiftOf(0), -0.8, 1e-12);
}

/// 60 others far away, among which nobody is ahead of the group.
TEST(GroupWalking, OthersFarAwayDoNotMatter) {
  std::vector<AgentStart> agents = {member(0.0, 0.0), member(0.0, 2.0)};
  for (int i = 0; i < 60; ++i) {
    agents.push_back(stranger(30.0 + 0.6 * (i % 10), 0.6 * (i / 10)));
    agents.back().velocity = {-1.0, 0.0};
  }
  Decision pair(agents);
  EXPECT_NEAR(pair.shiftOf(0), 0.5 * (2.0 - SPACING), 1e-12);
  agents.resize(2);
  Decision alone(agents);
  EXPECT_EQ(pair.shiftOf(0), alone.shiftOf(0));
}

/// Eight of 60 others are ahead, as in AmongOthersThreeWalkInAV.
TEST(GroupWalking, OthersAheadAreFoundInACrowd) {
  std::vector<AgentStart> agents = {member(0.0, -SPACING), member(0.0, 0.0), member(0.0, SPACING)};
  for (int i = 0; i < 52; ++i) agents.push_back(stranger(30.0 + 0.6 * (i % 10), 0.6 * (i / 10)));
  for (int i = 0; i < 8; ++i) agents.push_back(stranger(2.0 + 0.5 * i, i % 2 == 0 ? 1.0 : -1.0));
  Decision three(agents);
  EXPECT_NEAR(-SPACING + three.shiftOf(0), -SPACING * std::cos(0.6), 1e-12);
}

/// Two agents whose goals are far apart have no common way.
TEST(GroupWalking, MembersWithOtherGoalsWalkAlone) {
  std::vector<AgentStart> agents = {member(0.0, 0.0), member(0.0, 2.0)};
  agents[1].goals = {{50.0, 0.0}};
  Decision pair(agents);
  EXPECT_EQ(pair.speedOf(0), 1.0);
  EXPECT_EQ(pair.shiftOf(0), 0.0);
}

TEST(GroupWalking, WhoIsLeftWalksAtItsOwnSpeed) {
  Decision pair({member(0.0, 0.0), member(0.0, 2.0)});
  WorldEditor(pair.world).removeAgent(1);
  pair.world.step({});
  pair.groups.update(pair.world, {}, nullptr);
  EXPECT_EQ(pair.speedOf(0), 1.0);
  EXPECT_EQ(pair.shiftOf(0), 0.0);
}

TEST(GroupWalking, AgentsWithoutAGroupAreNotLed) {
  Decision two({stranger(0.0, 0.0), stranger(0.0, 2.0)});
  EXPECT_TRUE(two.groups.empty());
  EXPECT_EQ(two.shiftOf(0), 0.0);
  EXPECT_EQ(two.speedOf(0), 1.0);
}

}  // namespace
}  // namespace crowd::group_walking_test
