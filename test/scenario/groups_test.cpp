#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenario/group_placement.h"
#include "scenario/group_share.h"
#include "support/error_of.h"
#include "support/scenario_texts.h"

namespace crowd::groups_test {
namespace {

using scenario_texts::agentError;
using scenario_texts::HEAD;
using scenario_texts::sceneOf;

/// 44 % of the people in groups, of which 3 in 4 are pairs and the others have four members. 100 people: 12.57 pairs
/// ... the shares are those of the definition, to three standard deviations of 20,000 draws.
TEST(GroupShare, DrawsThisShareOfThePeople) {
  const GroupShare groups{0.44, {{2, 0.75}, {4, 0.25}}};
  double people = 0.0;
  std::vector<double> count(5, 0.0);
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const std::size_t size = groups.drawSize(KeyedRandom(7, KeyedRandom::GROUPS, {i}));
    ASSERT_TRUE(size == 1 || size == 2 || size == 4) << size;
    count[size] += 1.0;
    people += static_cast<double>(size);
  }
  EXPECT_NEAR((2.0 * count[2] + 4.0 * count[4]) / people, 0.44, 0.015);
  EXPECT_NEAR(count[2] / (count[2] + count[4]), 0.75, 0.02);
}

TEST(GroupShare, WithoutAShareAllWalkAlone) {
  EXPECT_EQ(GroupShare().drawSize(KeyedRandom(7, KeyedRandom::GROUPS, {1})), 1U);
}

TEST(Parties, EndWithTheEntry) {
  const GroupShare groups{1.0, {{3, 1.0}}};
  Parties parties(groups, KeyedRandom(1, KeyedRandom::GROUPS, {}));
  EXPECT_EQ(parties.next(4, 5), std::nullopt);
  EXPECT_TRUE(parties.leads());
  EXPECT_EQ(parties.next(5, 4), std::optional<AgentId>(4));
  EXPECT_EQ(parties.next(6, 3), std::optional<AgentId>(4));
  EXPECT_FALSE(parties.leads());
  EXPECT_EQ(parties.next(7, 2), std::nullopt);  // only one is left to follow it
  EXPECT_EQ(parties.next(8, 1), std::optional<AgentId>(7));
}

/// Followers stand 0.5 to 1.2 m from their leader, and no wall separates them from it.
TEST(GroupPlacement, FollowersStartBesideTheirLeader) {
  const Scene scene =
      sceneOf(std::string(HEAD) +
              "agents: [{count: 40, position: {box: [[-8, -8], [8, 8]]}, goal: [20, 0], speed: 1, radius: "
              "0.2, groups: {share: 1, sizes: {2: 1}}}]\n"
              "walls: [[[-9, 0], [9, 0]], [[0, -9], [0, 9]]]\n");
  for (std::size_t i = 0; i < 40; i += 2) {
    const AgentStart& follower = scene.agents[i + 1];
    ASSERT_TRUE(follower.leader);
    EXPECT_EQ(follower.leader->number, i);
    const Vector2 offset = follower.position - scene.agents[i].position;
    EXPECT_GE(offset.norm(), 0.5 - 1e-9);
    EXPECT_LE(offset.norm(), 1.2 + 1e-9);
    EXPECT_GT(follower.position.x() * scene.agents[i].position.x(), 0.0);
    EXPECT_GT(follower.position.y() * scene.agents[i].position.y(), 0.0);
  }
}

/// 60 agents, all in groups of two or three.
std::vector<GroupId> groupsOf(const std::string& sizes) {
  std::vector<GroupId> groups;
  const Scene scene =
      sceneOf(std::string(HEAD) +
              "agents: [{count: 60, position: {box: [[-9, -9], [9, 9]]}, goal: [20, 0], speed: 1, radius: 0.2, "
              "groups: {share: 1, sizes: {" +
              sizes + "}}}]\n");
  for (const AgentStart& agent : scene.agents) groups.push_back(agent.group);
  return groups;
}

TEST(GroupReader, DrawsDoNotDependOnOrderAndSizesWithoutAWeight) {
  const std::vector<GroupId> expected = groupsOf("2: 4, 3: 1");
  EXPECT_EQ(groupsOf("3: 1, 2: 4"), expected);
  EXPECT_EQ(groupsOf("4: 0, 2: 4, 3: 1"), expected);
  EXPECT_NE(groupsOf("2: 1, 3: 4"), expected);
}

TEST(GroupReader, ReportsErrors) {
  const std::string base = "position: [0, 0], goal: [4, 3], speed: 1.3, radius: 0.25";
  const std::string follower = "position: [0, 0], speed: 1.3, radius: 0.25, leader: ";
  EXPECT_TRUE(contains(agentError(base + ", leader: 0"), "agents[0].goal: goes without `leader` only"));
  EXPECT_TRUE(
      contains(agentError(follower + "0"), "line 5: agents[0].leader: expected an agent with a goal of its own"));
  EXPECT_TRUE(contains(agentError(follower + "1"), "expected the number of an agent, 0 to 0, got 1"));
  EXPECT_TRUE(contains(agentError(follower + "{robot: r}"), "there is no robot 'r'"));
  EXPECT_TRUE(contains(agentError(base + ", groups: {share: 2}"), "agents[0].groups.share"));
  EXPECT_TRUE(contains(agentError(base + ", groups: {share: 1, sizes: {1: 1}}"), "a map of sizes from 2 to 20"));
  EXPECT_TRUE(
      contains(agentError(base + ", groups: {share: 1, sizes: {2: 0}}"), "groups.sizes: expected a weight above 0"));
  EXPECT_TRUE(contains(agentError(base + ", groups: {share: 1, sizes: {2: -1}}"), "groups.sizes.2: expected a number"));
  const auto groups_error = [&](const std::string& groups) {
    const std::string other = "position: [9, 9], goal: [4, 3], speed: 1.3, radius: 0.25";
    return scenario_texts::errorOf(std::string(HEAD) + "agents:\n  - {" + base + "}\n  - {" + other + "}\ngroups:\n" +
                                   groups);
  };
  EXPECT_TRUE(
      contains(groups_error("  - {members: [0]}\n"), "groups[0].members: expected the numbers of at least two"));
  EXPECT_TRUE(
      contains(groups_error("  - {members: [0, 2]}\n"), "line 8: groups[0].members: expected the number of an"));
  EXPECT_TRUE(contains(groups_error("  - {members: [0, 0]}\n"), "agent 0 is in another group already"));
}

}  // namespace
}  // namespace crowd::groups_test
