#include <gtest/gtest.h>

#include "common/random.h"
#include "common/text/numbers.h"
#include "support/error_of.h"
#include "support/parts.h"
#include "support/perceptions.h"

namespace crowd::progress_reward_test {
namespace {

constexpr double SPEED = 0.3;  // of the builder's agents [m/s]; 0.03 m a tick

std::shared_ptr<const Reward> make(const std::string& yaml) { return rewardOf(yaml, *statesOf("{type: occupancy}")); }

/// The reward with one penalty at most.
std::shared_ptr<const Reward> withOnly(const std::string& penalty, double value = 0.0) {
  std::string yaml = "{type: progress";
  for (const std::string key : {"turn_penalty", "conflict_penalty", "rest_penalty", "contact_penalty"}) {
    yaml += ", " + key + ": " + (key == penalty ? toText(value) : "0");
  }
  return make(yaml + "}");
}

AgentPerception before(const Vector2& goal) {
  AgentPerception self;
  self.goal = goal;
  self.max_speed = SPEED;
  return self;
}

PerceptionsBuilder after(const Vector2& goal) { return PerceptionsBuilder().agent(0, goal); }

TEST(ProgressReward, IsTheNumberOfLostTicks) {
  const auto made = withOnly("");
  const Reward& reward = *made;
  EXPECT_NEAR(reward(before({5.0, 0.0}), after({4.97, 0.0}).perception(), 0), 0.0, 1e-9);
  EXPECT_NEAR(reward(before({5.0, 0.0}), after({5.0, 0.0}).perception(), 0), -1.0, 1e-9);
  EXPECT_NEAR(reward(before({5.0, 0.0}), after({5.03, 0.0}).perception(), 0), -2.0, 1e-9);
  EXPECT_NEAR(reward(before({5.0, 0.0}), after({4.985, 0.0}).arrived().perception(), 0), -0.5, 1e-9);
}

TEST(ProgressReward, PenalisesTurnsInBothDirections) {
  const auto made = withOnly("turn_penalty", 2.0);
  const Reward& reward = *made;
  AgentPerception self = before({5.0, 0.0});
  self.pose.heading = 0.25;  // the heading of the builder's agents is 0
  EXPECT_NEAR(reward(self, after({4.97, 0.0}).perception(), 0), -0.5, 1e-9);
  self.pose.heading = -0.25;
  EXPECT_NEAR(reward(self, after({4.97, 0.0}).perception(), 0), -0.5, 1e-9);
}

TEST(ProgressReward, PenalisesStanding) {
  const auto made = withOnly("rest_penalty", 0.5);
  const Reward& reward = *made;
  EXPECT_NEAR(reward(before({5.0, 0.0}), after({5.0, 0.0}).perception(), 0), -1.5, 1e-9);
}

TEST(ProgressReward, PenaltyOfACollisionCourseGrowsWithProximity) {
  const auto made = withOnly("conflict_penalty", 3.0);
  const Reward& reward = *made;
  const auto penalty = [&](double gap, const Vector2& goal) {
    auto scene = after(goal).neighbour({0.5 + gap, 0.0}, 0.25).velocity({SPEED, 0.0}, {-0.7, 0.0});
    return 1.0 + reward(before(goal), scene.perception(), 0);  // no progress: minus one tick
  };
  EXPECT_NEAR(penalty(1.0, {5.0, 0.0}), -2.25, 1e-9);  // 1 s ahead at 1 m/s: three quarters
  EXPECT_NEAR(penalty(3.0, {5.0, 0.0}), -0.75, 1e-9);
  EXPECT_NEAR(penalty(4.5, {5.0, 0.0}), 0.0, 1e-9);
  EXPECT_NEAR(penalty(1.0, {0.2, 0.0}), 0.0, 1e-9);  // it arrives before the contact
}

TEST(ProgressReward, PenalisesContact) {
  const auto made = withOnly("contact_penalty", 20.0);
  const Reward& reward = *made;
  auto apart = after({5.0, 0.0}).neighbour({0.51, 0.0}, 0.25);
  EXPECT_NEAR(reward(before({5.0, 0.0}), apart.perception(), 0), -1.0, 1e-9);
  auto overlapping = after({5.0, 0.0}).neighbour({0.49, 0.0}, 0.25);
  EXPECT_NEAR(reward(before({5.0, 0.0}), overlapping.perception(), 0), -21.0, 1e-9);
}

constexpr std::size_t MIDDLE = 1;  // of three agents

/// An agent that stands, with neighbours, of which number `touching` overlaps it, between two agents whose neighbours
/// all overlap them: data of the others in the list must not be used.
PerceptionsBuilder sceneOf(std::size_t neighbours, std::size_t touching, const Vector2& goal, KeyedRandom& random) {
  PerceptionsBuilder scene;
  addTouchedAgent(0, scene);
  scene.agent(MIDDLE, goal);
  for (std::size_t i = 0; i < neighbours; ++i) {
    const double radius = random.uniform(0.1, 0.4);
    const double gap = i == touching ? random.uniform(-0.1, -0.001) : random.uniform(0.001, 5.0);
    scene.neighbour(polar(random.uniform(-180, 180), 0.25 + radius + gap), radius);
  }
  addTouchedAgent(2, scene);
  return scene;
}

TEST(ProgressReward, PenalisesContactWithAnyNeighbour) {
  const auto made = withOnly("contact_penalty", 20.0);
  const Reward& reward = *made;
  const Vector2 goal(5.0, 0.0);
  constexpr std::uint64_t SEED = 1;
  KeyedRandom random(SEED, KeyedRandom::PLACEMENT, {});
  for (std::size_t count = 0; count <= 40; ++count) {
    for (std::size_t touching = 0; touching <= count; ++touching) {
      const PerceptionsBuilder scene = sceneOf(count, touching, goal, random);
      EXPECT_EQ(reward(before(goal), scene.perception(MIDDLE), 0), touching < count ? -21.0 : -1.0)
          << "seed " << SEED << ", " << count << " bodies, touched by number " << touching;
    }
  }
}

TEST(ProgressReward, AgreesWithItsSpec) {
  const std::string spec =
      "{type: progress, turn_penalty: 1.5, conflict_penalty: 2, conflict_time: 3, rest_penalty: 0.25, contact_penalty: "
      "7}";
  EXPECT_EQ(make(spec)->spec(), spec);
  EXPECT_TRUE(
      contains(errorOf<InputError>([] { make("{type: progress, conflict_time: 0}"); }), "conflict_time: expected"));
}

}  // namespace
}  // namespace crowd::progress_reward_test
