// Division of the perceptions of a turn among the topics of learners.

#include "ros/messages/perception_routes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/random.h"

namespace crowd::perception_routes_test {
namespace {

using Topics = std::vector<std::string>;

Perceptions perceptionsOf(const std::vector<AgentId>& agents) {
  Perceptions perceptions;
  for (const AgentId agent : agents) perceptions.agents.emplace_back().agent = agent;
  return perceptions;
}

TEST(PerceptionRoutes, NothingIsClaimedAtFirst) {
  const PerceptionRoutes routes;
  EXPECT_EQ(routes.topics(), Topics());
  EXPECT_TRUE(routes.split(perceptionsOf({0, 1})).empty());
  EXPECT_EQ(routes.rowsOf("/a", perceptionsOf({0, 1})), PerceptionRows());
}

TEST(PerceptionRoutes, EachTopicGetsItsAgents) {
  PerceptionRoutes routes;
  EXPECT_TRUE(routes.claim("/one", "/b", {3, 1, 3}));
  EXPECT_TRUE(routes.claim("/two", "/a", {5, 2, 70}));
  EXPECT_EQ(routes.topics(), (Topics{"/a", "/b"}));
  const Perceptions perceptions = perceptionsOf({0, 1, 2, 3, 4, 5});
  EXPECT_EQ(routes.split(perceptions), (std::vector<PerceptionRows>{{2, 5}, {1, 3}}));
  EXPECT_EQ(routes.rowsOf("/a", perceptions), (PerceptionRows{2, 5}));
  EXPECT_EQ(routes.rowsOf("/b", perceptions), (PerceptionRows{1, 3}));
  EXPECT_EQ(routes.split(perceptionsOf({4})), (std::vector<PerceptionRows>{{}, {}}));
  EXPECT_EQ(routes.split(perceptionsOf({})), (std::vector<PerceptionRows>{{}, {}}));
}

TEST(PerceptionRoutes, AgentsInAnyOrder) {
  PerceptionRoutes routes;
  routes.claim("/one", "/a", {1, 2, 9});
  EXPECT_EQ(routes.split(perceptionsOf({9, 2, 4, 1, 2})), (std::vector<PerceptionRows>{{0, 1, 3, 4}}));
}

TEST(PerceptionRoutes, LearnersThatClaimTheSameTopicShareIt) {
  PerceptionRoutes routes;
  routes.claim("/one", "/a", {0, 1});
  EXPECT_TRUE(routes.claim("/two", "/a", {1, 2}));
  EXPECT_EQ(routes.topics(), (Topics{"/a"}));
  EXPECT_EQ(routes.split(perceptionsOf({0, 1, 2, 3})), (std::vector<PerceptionRows>{{0, 1, 2}}));
  EXPECT_TRUE(routes.claim("/one", "", {}));
  EXPECT_EQ(routes.split(perceptionsOf({0, 1, 2, 3})), (std::vector<PerceptionRows>{{1, 2}}));
}

TEST(PerceptionRoutes, AnAgentOfTwoTopicsIsOnBoth) {
  PerceptionRoutes routes;
  routes.claim("/one", "/a", {0, 1});
  routes.claim("/two", "/b", {1, 2});
  EXPECT_EQ(routes.split(perceptionsOf({0, 1, 2})), (std::vector<PerceptionRows>{{0, 1}, {1, 2}}));
}

TEST(PerceptionRoutes, NewClaimReplacesThePreviousOne) {
  PerceptionRoutes routes;
  routes.claim("/one", "/a", {0, 1});
  EXPECT_FALSE(routes.claim("/one", "/a", {1, 0}));
  EXPECT_TRUE(routes.claim("/one", "/a", {2}));
  EXPECT_EQ(routes.split(perceptionsOf({0, 1, 2})), (std::vector<PerceptionRows>{{2}}));
  EXPECT_TRUE(routes.claim("/one", "/b", {2}));
  EXPECT_EQ(routes.topics(), (Topics{"/b"}));
  EXPECT_TRUE(routes.claim("/one", "", {2}));
  EXPECT_FALSE(routes.claim("/one", "", {2}));
  EXPECT_FALSE(routes.claim("/other", "", {}));
  EXPECT_EQ(routes.topics(), Topics());
}

TEST(PerceptionRoutes, SharesHoldForAllAgents) {
  PerceptionRoutes routes;
  EXPECT_TRUE(routes.claim("/one", "/a", {}, {0, 3}));
  EXPECT_TRUE(routes.claim("/two", "/b", {}, {2, 3}));
  EXPECT_FALSE(routes.claim("/two", "/b", {2, 5}, {2, 3})) << "its agents follow from its share";
  const Perceptions perceptions = perceptionsOf({0, 1, 2, 3, 4, 5, 3000002});
  EXPECT_EQ(routes.split(perceptions), (std::vector<PerceptionRows>{{0, 3}, {2, 5, 6}}));
  EXPECT_EQ(routes.rowsOf("/b", perceptions), (PerceptionRows{2, 5, 6}));
  EXPECT_TRUE(routes.claim("/two", "/a", {2, 3}));
  EXPECT_EQ(routes.split(perceptions), (std::vector<PerceptionRows>{{0, 2, 3}})) << "each row once";
  EXPECT_TRUE(routes.claim("/one", "/a", {}, {1, 3}));
  EXPECT_EQ(routes.split(perceptions), (std::vector<PerceptionRows>{{1, 2, 3, 4}}));
}

/// Returns up to 60 agents of 0 to 99, in random order if `shuffled`.
std::vector<AgentId> randomAgents(KeyedRandom& random, bool shuffled) {
  std::vector<AgentId> agents;
  for (std::uint32_t i = random.below(61); i > 0; --i) agents.push_back(random.below(100));
  if (shuffled) return agents;
  const std::set<AgentId> sorted(agents.begin(), agents.end());
  return {sorted.begin(), sorted.end()};
}

TEST(PerceptionRoutesProperty, AgreesWithASearchOfAllClaims) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    PerceptionRoutes routes;
    std::map<std::string, std::pair<std::string, std::vector<AgentId>>> claims;
    for (int i = 0; i < 20; ++i) {
      const std::string learner = "/learner_" + std::to_string(random.below(6));
      const std::string topic = "/topic_" + std::to_string(random.below(4));
      const std::vector<AgentId> agents = randomAgents(random, true);
      routes.claim(learner, topic, agents);
      claims[learner] = {topic, agents};
    }
    const Perceptions perceptions = perceptionsOf(randomAgents(random, seed % 2 == 0));
    std::map<std::string, PerceptionRows> expected;
    for (const auto& [learner, claim] : claims) expected[claim.first];
    for (std::uint32_t row = 0; row < perceptions.agents.size(); ++row) {
      for (auto& [topic, rows] : expected) {
        const auto claims_it = [&, &name = topic](const auto& entry) {
          const auto& [claimed, agents] = entry.second;
          return claimed == name && std::count(agents.begin(), agents.end(), perceptions.agents[row].agent) > 0;
        };
        if (std::any_of(claims.begin(), claims.end(), claims_it)) rows.push_back(row);
      }
    }
    std::vector<PerceptionRows> all_rows;
    all_rows.reserve(expected.size());
    for (const auto& [topic, rows] : expected) all_rows.push_back(rows);
    EXPECT_EQ(routes.split(perceptions), all_rows);
  }
}

}  // namespace
}  // namespace crowd::perception_routes_test
