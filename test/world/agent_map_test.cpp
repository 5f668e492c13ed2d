#include "world/agent_map.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "common/random.h"

namespace crowd::agent_map_test {
namespace {

std::vector<AgentId> idsOf(const AgentMap<int>& map) {
  std::vector<AgentId> ids;
  for (std::size_t i = 0; i < map.size(); ++i) ids.push_back(map.idAt(i));
  return ids;
}

TEST(AgentMap, ValuesOfTheFirstAgents) {
  AgentMap<int> map({5, 6, 7});
  EXPECT_EQ(map.size(), 3U);
  EXPECT_EQ(map[2], 7);
  EXPECT_EQ(map.positionOf(2), 2U);
  EXPECT_EQ(map.find(3), nullptr);
  EXPECT_EQ(map.replace({1}), (std::vector<int>{5, 6, 7}));
  EXPECT_EQ(idsOf(map), std::vector<AgentId>{0});
}

TEST(AgentMap, AgentsThatLeaveMakeRoom) {
  AgentMap<int> map({5, 6, 7, 8});
  map.eraseIf([](AgentId id, int value) { return id == 1 || value == 7; });
  EXPECT_EQ(idsOf(map), (std::vector<AgentId>{0, 3}));
  EXPECT_EQ(map.values(), (std::vector<int>{5, 8}));
  EXPECT_EQ(map[3], 8);
  EXPECT_EQ(map.positionOf(3), 1U);
  EXPECT_FALSE(map.contains(1));
  EXPECT_EQ(map.lowerBound(1), 1U);
  map.add(9) = 4;
  map.add(3) = 2;  // is there already
  map.add(2) = 1;
  EXPECT_EQ(idsOf(map), (std::vector<AgentId>{0, 2, 3, 9}));
  EXPECT_EQ(map.values(), (std::vector<int>{5, 1, 2, 4}));
}

TEST(AgentMap, FollowsAnother) {
  AgentMap<int> leader({1, 2, 3});
  AgentMap<int> map({7, 8});
  map.follow(leader);
  EXPECT_EQ(map.values(), (std::vector<int>{7, 8, 0}));
  leader.eraseIf([](AgentId id, int) { return id == 0; });
  leader.add(5);
  std::vector<AgentId> forgotten;
  map.keepOnly(leader, [&](AgentId id, int value) { forgotten.insert(forgotten.end(), {id, AgentId(value)}); });
  EXPECT_EQ(forgotten, (std::vector<AgentId>{0, 7}));
  map.follow(leader);
  EXPECT_EQ(idsOf(map), (std::vector<AgentId>{1, 2, 5}));
  EXPECT_EQ(map.values(), (std::vector<int>{8, 0, 0}));
  map.follow(AgentMap<int>({1, 1}));  // also if ids begin again
  EXPECT_EQ(idsOf(map), (std::vector<AgentId>{0, 1}));
  EXPECT_EQ(map.values(), (std::vector<int>{0, 8}));
}

/// Any sequence of changes has the same result as with a std::map.
TEST(AgentMap, IsAMap) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    KeyedRandom random(seed, KeyedRandom::CONTENT, {});
    AgentMap<int> map;
    std::map<AgentId, int> expected;
    for (int change = 0; change < 500; ++change) {
      const AgentId id = random.below(40);
      if (random.below(3) > 0) {
        map.add(id) = expected[id] = change;
      } else {
        const auto leaves = [&](AgentId other) { return other % 7 == id % 7; };
        map.eraseIf([&](AgentId other, int) { return leaves(other); });
        for (auto next = expected.begin(); next != expected.end();) {
          next = leaves(next->first) ? expected.erase(next) : std::next(next);
        }
      }
      ASSERT_EQ(map.size(), expected.size());
      std::size_t position = 0;
      for (const auto& [agent, value] : expected) {
        ASSERT_EQ(map.idAt(position), agent);
        ASSERT_EQ(map.positionOf(agent), position++);
        ASSERT_EQ(map[agent], value);
      }
      for (AgentId agent = 0; agent < 40; ++agent) ASSERT_EQ(map.contains(agent), expected.count(agent) > 0);
    }
  }
}

}  // namespace
}  // namespace crowd::agent_map_test
