// Serialised perceptions of some agents, compared with the generated message of the same content.

#include <gtest/gtest.h>
#include <ros/serialization.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "common/random.h"
#include "ros/messages/tick_messages.h"
#include "support/perception_bits.h"
#include "support/perceptions.h"
#include "support/scenes.h"
#include "support/worlds.h"

namespace crowd::perception_selection_test {
namespace {

template <typename Message>
std::vector<std::uint8_t> serialized(const Message& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  EXPECT_EQ(stream.getLength(), 0U) << "bytes that were announced, but not written";
  return bytes;
}

PerceptionsMessage messageWith(const Perceptions& perceptions) {
  PerceptionsMessage message;
  message.header.frame_id = "map";
  message.header.stamp = ros::Time(12, 34);
  message.header.seq = 5;
  message.run = 1790000000000000000;
  message.vision = {6.5, 16, true};
  message.shared = std::make_shared<const Perceptions>(perceptions);
  return message;
}

/// Reference: the generated message with copies of these agents, their neighbours and their walls.
social_crowd::Perceptions cut(const PerceptionsMessage& all, const PerceptionRows& rows) {
  const Perceptions& content = *all.shared;
  social_crowd::Perceptions message;
  message.header = all.header;
  message.episode = content.episode;
  message.tick = content.tick;
  message.turn = content.turn;
  message.tick_duration = content.tick_duration;
  message.run = all.run;
  message.last = static_cast<std::uint8_t>(content.last);
  message.vision_radius = all.vision.radius;
  message.max_neighbours = all.vision.max_neighbours;
  message.occlusion = static_cast<std::uint8_t>(all.vision.occlusion);
  for (const std::uint32_t row : rows) {
    const AgentPerception& self = content.agents[row];
    social_crowd::AgentPerception agent;
    agent.agent = self.agent;
    agent.pose.x = self.pose.position.x();
    agent.pose.y = self.pose.position.y();
    agent.pose.theta = self.pose.heading;
    agent.velocity_x = self.velocity.x();
    agent.velocity_y = self.velocity.y();
    agent.max_speed = self.max_speed;
    agent.radius = self.radius;
    agent.goal_x = self.goal.x();
    agent.goal_y = self.goal.y();
    agent.goal_number = self.goal_number;
    agent.arrived = static_cast<std::uint8_t>(self.arrived);
    agent.acted = static_cast<std::uint8_t>(self.acted);
    agent.first_neighbour = static_cast<std::uint32_t>(message.neighbours.size());
    agent.neighbour_count = self.neighbour_count;
    agent.first_wall = static_cast<std::uint32_t>(message.walls.size());
    agent.wall_count = self.wall_count;
    message.agents.push_back(agent);
    for (std::uint32_t i = 0; i < self.neighbour_count; ++i) {
      const Neighbour seen = content.neighbours[self.first_neighbour + i];
      social_crowd::Neighbour neighbour;
      neighbour.kind = static_cast<std::uint8_t>(seen.kind);
      neighbour.x = seen.position.x();
      neighbour.y = seen.position.y();
      neighbour.velocity_x = seen.velocity.x();
      neighbour.velocity_y = seen.velocity.y();
      neighbour.radius = seen.radius;
      message.neighbours.push_back(neighbour);
    }
    for (std::uint32_t i = 0; i < self.wall_count; ++i) {
      const Segment seen = content.walls[self.first_wall + i];
      social_crowd::PerceivedWall wall;
      wall.from_x = seen.from.x();
      wall.from_y = seen.from.y();
      wall.to_x = seen.to.x();
      wall.to_y = seen.to.y();
      message.walls.push_back(wall);
    }
  }
  return message;
}

void expectSelected(const Perceptions& perceptions, const PerceptionRows& rows) {
  PerceptionsMessage message = messageWith(perceptions);
  message.rows = rows;
  EXPECT_EQ(serialized(message), serialized(cut(message, rows)));
}

PerceptionRows allRows(const Perceptions& perceptions) {
  PerceptionRows rows(perceptions.agents.size());
  std::iota(rows.begin(), rows.end(), 0U);
  return rows;
}

Perceptions threeAgents() {
  return PerceptionsBuilder(7, 3)
      .agent(0, {1, 2})
      .neighbour({3, 4}, 0.5)
      .neighbour({5, 6}, 0.25)
      .agent(4, {-1, 0})
      .agent(6, {0, 1})
      .neighbour({7, 8}, 0.3)
      .all();
}

TEST(PerceptionSelection, AgentsAndNeighboursByHand) {
  PerceptionsMessage message = messageWith(threeAgents());
  message.rows = PerceptionRows{1, 2};
  std::vector<std::uint8_t> bytes = serialized(message);
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  social_crowd::Perceptions received;
  ros::serialization::deserialize(stream, received);
  ASSERT_EQ(received.agents.size(), 2U);
  EXPECT_EQ(received.agents[0].agent, 4U);
  EXPECT_EQ(received.agents[0].neighbour_count, 0U);
  EXPECT_EQ(received.agents[1].agent, 6U);
  EXPECT_EQ(received.agents[1].first_neighbour, 0U);
  ASSERT_EQ(received.neighbours.size(), 1U);
  EXPECT_EQ(received.neighbours[0].x, 7.0);
  EXPECT_EQ(received.episode, 7U);
  EXPECT_EQ(received.tick, 3U);
}

TEST(PerceptionSelection, NoAgent) {
  expectSelected(threeAgents(), {});
  PerceptionsMessage message = messageWith(threeAgents());
  message.rows = PerceptionRows();
  // Header: 4 + 8 + 4 + "map"; then 6 numbers of 8 bytes, 2 of 4, 2 flags, the source and 3 numbers of motion limits,
  // and 4 lengths of lists.
  EXPECT_EQ(serialized(message).size(), 19U + 48U + 8U + 2U + 25U + 16U);
}

TEST(PerceptionSelection, ReceivedMessageHasNoSelection) {
  PerceptionsMessage message = messageWith(threeAgents());
  std::vector<std::uint8_t> bytes = serialized(message);
  message.rows = PerceptionRows{0};  // of a message in a reused buffer
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(stream, message);
  EXPECT_FALSE(message.rows.has_value());
  EXPECT_EQ(message.content().agents.size(), 3U);
  EXPECT_EQ(serialized(message), bytes);
}

TEST(PerceptionSelectionProperty, EqualsTheGeneratedMessage) {
  std::size_t neighbours = 0;
  std::size_t walls = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    World world(scenes::randomScene(seed, 60));
    Perceptions perceptions = perceive(world);
    perceptions.episode = seed;
    perceptions.last = seed % 2 == 0;
    PerceptionRows rows;
    for (const std::uint32_t row : allRows(perceptions)) {
      if (random.below(2) == 0) continue;
      rows.push_back(row);
      neighbours += perceptions.agents[row].neighbour_count;
      walls += perceptions.agents[row].wall_count;
    }
    expectSelected(perceptions, rows);
    expectSelected(perceptions, allRows(perceptions));
    const PerceptionsMessage complete = messageWith(perceptions);
    EXPECT_EQ(serialized(complete), serialized(cut(complete, allRows(perceptions))));
  }
  EXPECT_GT(neighbours, 1000U);
  EXPECT_GT(walls, 100U);
}

}  // namespace
}  // namespace crowd::perception_selection_test
