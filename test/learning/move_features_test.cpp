#include "learning/states/move_features.h"

#include <gtest/gtest.h>

#include "avoidance/time_to_collision.h"
#include "common/random.h"
#include "support/moves.h"
#include "support/perceptions.h"

namespace crowd::move_features_test {
namespace {

constexpr double MIN_FRACTION = 0.05;

Vector2 anyVector(KeyedRandom& random, double longest) {
  return random.uniform(0.0, longest) * unitVector(random.uniform(-PI, PI));
}

/// Agents and obstacles at rest and in motion, some of which overlap the agent, and walls.
PerceptionsBuilder anyScene(KeyedRandom& random) {
  PerceptionsBuilder scene;
  scene.agent(0, anyVector(random, 6.0));
  const Vector2 own = random.below(5) == 0 ? Vector2(Vector2::Zero()) : anyVector(random, 0.3);
  for (std::uint32_t left = random.below(50); left > 0; --left) {
    scene.neighbour(anyVector(random, 3.0), random.uniform(0.05, 0.5));
    scene.velocity(own, random.below(4) == 0 ? Vector2(Vector2::Zero()) : anyVector(random, 0.5));
    scene.kind(random.below(3) == 0 ? NeighbourKind::OBSTACLE : NeighbourKind::AGENT);
  }
  for (std::uint32_t left = random.below(4); left > 0; --left) {
    const Vector2 from = anyVector(random, 3.0);
    scene.wall(from, anyVector(random, 3.0));
  }
  return scene;
}

CandidateMove anyMove(KeyedRandom& random) {
  const double wanted = 0.5 * random.below(3);
  return {unitVector(random.uniform(-PI, PI)), wanted, random.below(2) == 0 ? wanted : random.uniform(0.0, wanted)};
}

/// Reference: the times, computed move by move in double precision.
struct Expected {
  double reciprocal = NEVER;
  double constant_velocity = NEVER;
  double static_bodies = NEVER;
};

/// At most 0.8 of the gap to the first agent, which is the nearest one of a real perception.
double spaceKept(const Perception& seen, double personal_space) {
  for (const Neighbour& neighbour : seen.neighbours) {
    if (neighbour.kind != NeighbourKind::AGENT) continue;
    const double gap = neighbour.position.norm() - seen.self.radius - neighbour.radius;
    return std::max(0.0, std::min(personal_space, 0.8 * gap));
  }
  return 0.0;
}

/// The share of the maximum speed at which collisions of a move are predicted.
double predictedShare(const CandidateMove& move, const CollisionPrediction& prediction) {
  if (prediction.speeds == CandidateSpeeds::ADMISSIBLE) return move.fraction;
  const bool blocked = move.wanted > 0.0 && move.fraction / move.wanted < prediction.min_fraction;
  return blocked ? 0.0 : move.wanted;
}

Expected expect(const Perception& seen, const CandidateMove& move, const CollisionPrediction& prediction) {
  const AgentPerception& self = seen.self;
  const Vector2 u = predictedShare(move, prediction) * self.max_speed * move.direction;
  Expected times;
  for (const Neighbour& neighbour : seen.neighbours) {
    const bool is_agent = neighbour.kind == NeighbourKind::AGENT;
    const double space = is_agent ? spaceKept(seen, prediction.personal_space) : 0.0;
    const double reach = self.radius + neighbour.radius + space;
    const double constant_velocity = timeToCollision(neighbour.position, u - neighbour.velocity, reach);
    double& place = neighbour.kind == NeighbourKind::AGENT ? times.constant_velocity : times.static_bodies;
    place = std::min(place, constant_velocity);
    if (neighbour.kind != NeighbourKind::AGENT) continue;
    const Vector2 shared = 2.0 * u - self.velocity - neighbour.velocity;
    times.reciprocal = std::min(times.reciprocal, timeToCollision(neighbour.position, shared, reach));
  }
  for (const Segment& wall : seen.walls)
    times.static_bodies = std::min(times.static_bodies, timeToCollision(wall, u, self.radius));
  for (double* time : {&times.reciprocal, &times.constant_velocity, &times.static_bodies}) {
    if (*time > self.goal.norm() / self.max_speed) *time = NEVER;
  }
  return times;
}

/// Whether two times are equal up to rounding. A grazing contact may be missed.
bool agree(double a, double b) { return std::abs(a - b) <= 1e-3 * (1.0 + std::min(a, b)); }

TEST(MoveFeatures, AgreeWithAReferenceForEachMove) {
  std::size_t compared = 0;
  std::size_t apart = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const PerceptionsBuilder scene = anyScene(random);
    std::vector<CandidateMove> moves(1 + random.below(MoveFeatures::LANES));
    for (CandidateMove& move : moves) move = anyMove(random);
    const auto speeds = random.below(2) == 0 ? CandidateSpeeds::WANTED : CandidateSpeeds::ADMISSIBLE;
    const double space = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 1.0);
    const CollisionPrediction prediction{speeds, MIN_FRACTION, space};
    const MoveFeatures features = featuresAlone(scene.perception(), toBlocks(moves)[0], moves.size(), prediction);
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const Expected expected = expect(scene.perception(), moves[i], prediction);
      compared += 3;
      apart += agree(features.reciprocal_times[i], expected.reciprocal) ? 0 : 1;
      apart += agree(features.constant_velocity_times[i], expected.constant_velocity) ? 0 : 1;
      apart += agree(features.static_times[i], expected.static_bodies) ? 0 : 1;
    }
  }
  EXPECT_GT(compared, 50000U);
  EXPECT_LE(apart, compared / 10000);
}

TEST(MoveFeatures, OncomingIsTheFastestApproachOnTheWayToTheGoal) {
  // To the goal with 0.3 m/s; one comes with 0.15 m/s, one overtakes from behind with 0.9 m/s, an obstacle comes
  // faster.
  auto scene = PerceptionsBuilder().agent(0, {5.0, 0.0}).neighbour({2.0, 0.0}, 0.25).velocity({0.3, 0.0}, {-0.15, 0.0});
  const MoveBlock moves = toBlocks({CandidateMove()})[0];
  const auto oncoming = [&] { return featuresAlone(scene.perception(), moves, 1, {}).oncoming; };
  EXPECT_NEAR(oncoming(), 1.5, 1e-6);
  scene.neighbour({-2.0, 0.0}, 0.25).velocity({0.3, 0.0}, {0.9, 0.0});
  EXPECT_NEAR(oncoming(), 2.0, 1e-6);
  scene.neighbour({1.0, 0.0}, 0.25).velocity({0.3, 0.0}, {-0.9, 0.0}).kind(NeighbourKind::OBSTACLE);
  EXPECT_NEAR(oncoming(), 2.0, 1e-6);
}

TEST(MoveFeatures, CollisionsArePredictedAtTheWantedOrTheAdmissibleSpeed) {
  // 0.5 m from rim to rim of a pillar, at 0.5 m/s; the separation rule admits a fifth of the move.
  const auto scene =
      PerceptionsBuilder().agent(0, {9.0, 0.0}).neighbour({1.0, 0.0}, 0.25).kind(NeighbourKind::OBSTACLE);
  const Perception seen = scene.perception();
  ASSERT_EQ(seen.self.radius, 0.25);
  const MoveBlock moves = toBlocks({CandidateMove{{1.0, 0.0}, 0.5, 0.1}})[0];
  const auto time = [&](const CollisionPrediction& prediction) {
    return featuresAlone(seen, moves, 1, prediction).static_times[0];
  };
  EXPECT_NEAR(time({CandidateSpeeds::WANTED, 0.05}), 0.5 / (0.5 * seen.self.max_speed), 1e-5);
  EXPECT_NEAR(time({CandidateSpeeds::ADMISSIBLE, 0.05}), 0.5 / (0.1 * seen.self.max_speed), 1e-5);
}

}  // namespace
}  // namespace crowd::move_features_test
