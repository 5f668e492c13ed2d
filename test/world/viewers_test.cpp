#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "support/perception_bits.h"
#include "support/scenes.h"
#include "support/worlds.h"
#include "world/world_editor.h"

namespace crowd::viewers_test {
namespace {

using scenes::agent;
using scenes::pillar;
using scenes::wanderer;
using Ids = std::vector<AgentId>;

/// Workspace and output of perceptions for some bodies.
struct Eyes {
  Viewers viewers;
  Perceiver perceiver;
  Perceptions perceptions;

  const Perceptions& look(const World& world, const Vision& vision, std::size_t begin, std::size_t end) {
    perceiver.perceive(world, vision, viewers.among(world, begin, end), perceptions);
    return perceptions;
  }
};

Ids agentsOf(const Perceptions& perceptions) {
  Ids ids;
  for (const AgentPerception& self : perceptions.agents) ids.push_back(self.agent);
  return ids;
}

/// Bodies of a small scene are in the order of their numbers.
Ids agentsAmong(const World& world, std::size_t begin, std::size_t end) {
  return agentsOf(Eyes().look(world, FAR_SIGHT, begin, end));
}

TEST(Viewers, AreTheAgentsAmongTheBodies) {
  const World world(scenes::scene({wanderer({0.0, 0.0}), wanderer({3.0, 0.0}), wanderer({6.0, 0.0})},
                                  {pillar({0.0, 5.0}, 0.5), pillar({3.0, 5.0}, 0.5)}));
  ASSERT_EQ(world.grid().size(), 5U);
  EXPECT_EQ(agentsAmong(world, 0, 5), (Ids{0, 1, 2}));
  EXPECT_EQ(agentsAmong(world, 1, 2), Ids{1});
  EXPECT_EQ(agentsAmong(world, 2, 4), Ids{2});
  EXPECT_EQ(agentsAmong(world, 3, 5), Ids{});  // obstacles have no perceptions
  EXPECT_EQ(agentsAmong(world, 2, 2), Ids{});
}

TEST(Viewers, AmongBodiesByHand) {
  World world(scenes::halfSeconds(scenes::scene({wanderer({0.0, 0.0}, 1.0), wanderer({3.0, 4.0}, 1.0)},
                                                {pillar({0.0, -2.0}, 0.5)}, {{{-1.0, -9.0}, {-1.0, 9.0}}})));
  world.step({{0, {0.0, 1.0}}, {1, {PI / 2, 1.0}}});  // to (0.5, 0) and (3, 4.5)
  Eyes eyes;
  const Perceptions& perceptions = eyes.look(world, FAR_SIGHT, 1, 3);
  EXPECT_EQ(perceptions.tick, 1U);
  EXPECT_EQ(perceptions.tick_duration, 0.5);
  ASSERT_EQ(agentsOf(perceptions), Ids{1});
  const Perception seen(perceptions, 0);
  expectVector(seen.self.pose.position, 3.0, 4.5);
  expectVector(seen.self.velocity, 1.0, 0.0);
  EXPECT_TRUE(seen.self.acted);
  ASSERT_EQ(seen.neighbours.size(), 2U);
  expectVector(seen.neighbours[0].position, -4.5, 2.5);  // heading north: south is behind, west is left
  expectVector(seen.neighbours[0].velocity, 0.0, -1.0);
  EXPECT_EQ(seen.neighbours[0].kind, NeighbourKind::AGENT);
  expectVector(seen.neighbours[1].position, -6.5, 3.0);
  EXPECT_EQ(seen.neighbours[1].kind, NeighbourKind::OBSTACLE);
  ASSERT_EQ(seen.walls.size(), 1U);
  expectVector(seen.walls[0].from, -13.5, 4.0);
  expectVector(seen.walls[0].to, 4.5, 4.0);
}

TEST(Viewers, AmongBodiesAreNeitherArrivedNorRemoved) {
  World world(scenes::halfSeconds(
      scenes::scene({agent({0.0, 0.0}, {0.5, 0.0}, 1.0), wanderer({0.0, 3.0}), wanderer({0.0, 6.0})})));
  world.step({ahead(0)});
  ASSERT_TRUE(lookAround(world).agents.at(0).arrived);  // it is among all once more
  ASSERT_EQ(world.grid().size(), 2U);
  EXPECT_EQ(agentsAmong(world, 0, 2), (Ids{1, 2}));
  WorldEditor(world).removeAgent(1);
  ASSERT_EQ(world.grid().size(), 1U);
  EXPECT_EQ(agentsAmong(world, 0, 1), Ids{2});
}

/// The perceptions of all agents that have not arrived.
using BitsByAgent = std::map<AgentId, Bits>;

/// Numbers of compared items.
struct Count {
  std::size_t neighbours = 0;
  std::size_t walls = 0;
  std::size_t arrived = 0;
  std::size_t lists = 0;
};

BitsByAgent seenAtOnce(World& world, const Vision& vision, Count& count) {
  Perceptions perceptions;
  perceive(world, vision, perceptions);
  BitsByAgent bits;
  for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
    const Perception seen(perceptions, i);
    count.neighbours += seen.neighbours.size();
    count.walls += seen.walls.size();
    if (seen.self.arrived) {
      ++count.arrived;
    } else {
      bits[seen.self.agent] = bitsOf(seen);
    }
  }
  count.lists += world.grid().size() <= 32 ? 1 : 0;
  return bits;
}

/// Perceives in random blocks of up to `longest` bodies (some are empty), with a random workspace for each block.
BitsByAgent seenInBlocks(const World& world, const Vision& vision, std::size_t longest, KeyedRandom& random,
                         std::array<Eyes, 3>& eyes) {
  BitsByAgent bits;
  for (std::size_t begin = 0; begin < world.grid().size();) {
    const std::size_t size = random.below(static_cast<std::uint32_t>(longest) + 1);
    const std::size_t end = std::min(begin + size, world.grid().size());
    const Perceptions& perceptions = eyes[random.below(3)].look(world, vision, begin, end);
    EXPECT_EQ(perceptions.tick, world.tick());
    std::size_t walls = 0;
    for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
      const Perception seen(perceptions, i);
      EXPECT_TRUE(bits.emplace(seen.self.agent, bitsOf(seen)).second) << "agent " << seen.self.agent << " again";
      walls += seen.walls.size();
    }
    EXPECT_EQ(perceptions.walls.size(), walls) << "walls of no agent";
    begin = end;
  }
  return bits;
}

TEST(Viewers, InAnyBlocksPerceiveAsAllAtOnce) {
  const std::array<Vision, 4> visions = {{{6.0, 0}, {6.0, 3}, {6.0, 0, true}, {3.0, 3, true}}};
  std::array<Count, 4> counts;
  std::array<Eyes, 3> eyes;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {1});
    World world(scenes::randomScene(seed, seed % 4 == 0 ? 3 : 40));
    perceive(world, visions[0], eyes[0].perceptions);  // old content is replaced
    for (int tick = 0; tick < 25; ++tick) {
      if (tick == 10 && world.isActive(1)) WorldEditor(world).removeAgent(1);
      for (std::size_t i = 0; i < visions.size(); ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", tick " << tick << ", vision " << i);
        const BitsByAgent expected = seenAtOnce(world, visions[i], counts[i]);
        for (const std::size_t longest : {std::size_t{1}, std::size_t{7}, 2 * world.grid().size()}) {
          ASSERT_EQ(seenInBlocks(world, visions[i], longest, random, eyes), expected);
        }
      }
      world.step(scenes::purposefulActions(world, random));
    }
  }
  for (const Count& count : counts) {
    EXPECT_GT(count.walls, 1000U);
    EXPECT_GT(count.arrived, 100U);
    EXPECT_GT(count.lists, 100U);
    EXPECT_LT(count.lists, 2400U);  // of 2500: some worlds are larger
  }
  EXPECT_LT(counts[1].neighbours, counts[0].neighbours);  // some perceived more than 3
  EXPECT_LT(counts[2].neighbours, counts[0].neighbours);  // some were hidden
}

}  // namespace
}  // namespace crowd::viewers_test
