#include "learning/states/move_features.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "avoidance/time_to_collision.h"

namespace crowd {
namespace {

using Lanes = MoveFeatures::Lanes;

/// Intermediate results of one agent.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): begin() writes it; zeroing takes time
struct Course {
  CandidateVelocities candidates;
  Vector2 preferred;   // straight to the goal at maximum speed, agent frame [m/s]
  float max_speed;     // upper bound of the speed of candidates [m/s]
  float time_to_goal;  // at full speed; later collisions do not count [s]
};

/// Writes the velocities of the moves at which collisions are predicted.
/// @details One short loop per step: the compiler vectorises these, but not one loop with all steps.
/// @param walking whether the agent moved in the last tick; if not, no move is a turn
void findCandidates(const MoveBlock& __restrict moves, const CollisionPrediction& prediction, float max_speed,
                    bool walking, MoveFeatures& __restrict features, CandidateVelocities& __restrict candidates) {
  // NOLINTBEGIN(cppcoreguidelines-pro-type-member-init): written below
  Lanes x;
  Lanes speed;
  Lanes share;
  // NOLINTEND(cppcoreguidelines-pro-type-member-init)
  Lanes& left = features.admissible_fractions;
  for (std::size_t i = 0; i < MoveFeatures::LANES; ++i) x[i] = static_cast<float>(moves.x[i]);
  for (std::size_t i = 0; i < MoveFeatures::LANES; ++i) speed[i] = static_cast<float>(moves.wanted[i]);
  for (std::size_t i = 0; i < MoveFeatures::LANES; ++i) share[i] = static_cast<float>(moves.fraction[i]);
  for (std::size_t i = 0; i < MoveFeatures::LANES; ++i) {
    const float quotient = share[i] / speed[i];
    left[i] = speed[i] > 0.0F ? quotient : 1.0F;
  }
  if (prediction.speeds == CandidateSpeeds::ADMISSIBLE) {
    for (std::size_t i = 0; i < MoveFeatures::LANES; ++i) speed[i] = share[i] * max_speed;
  } else {
    const auto least = static_cast<float>(prediction.min_fraction);
    for (std::size_t i = 0; i < MoveFeatures::LANES; ++i) speed[i] = left[i] < least ? 0.0F : speed[i] * max_speed;
  }
  for (std::size_t i = 0; i < MoveFeatures::LANES; ++i) candidates.xs[i] = speed[i] * x[i];
  for (std::size_t i = 0; i < MoveFeatures::LANES; ++i) candidates.ys[i] = speed[i] * static_cast<float>(moves.y[i]);
  if (walking) {
    features.turn_cosines = x;
  } else {
    features.turn_cosines.fill(1.0F);
  }
}

void begin(const AgentPerception& self, const MoveBlock& moves, std::size_t count,
           const CollisionPrediction& prediction, MoveFeatures& features, Course& candidate) {
  const double distance = self.goal.norm();
  const double speed_per_metre = distance > 0.0 ? self.max_speed / distance : 0.0;
  candidate.preferred = speed_per_metre * self.goal;
  candidate.max_speed = static_cast<float>(self.max_speed);
  candidate.time_to_goal = static_cast<float>(distance / self.max_speed);
  candidate.candidates.count = count;
  candidate.candidates.clear();
  findCandidates(moves, prediction, candidate.max_speed, self.velocity != Vector2::Zero(), features,
                 candidate.candidates);
}

/// Converts inverse times to times; collisions after the arrival at the goal do not count.
/// @param unit the inverses are unit / time
void toTimes(const Lanes& soonest, float unit, float time_to_goal, Lanes& times) {
  for (std::size_t i = 0; i < MoveFeatures::LANES; ++i) {
    const float time = unit / soonest[i];
    times[i] = time > time_to_goal ? static_cast<float>(NEVER) : time;
  }
}

void finish(const Course& candidate, MoveFeatures& features) {
  const CandidateVelocities& candidates = candidate.candidates;
  features.oncoming = std::sqrt(candidates.fastest) / candidate.max_speed;
  toTimes(candidates.reciprocal, 0.5F, candidate.time_to_goal, features.reciprocal_times);
  toTimes(candidates.constant_velocity, 1.0F, candidate.time_to_goal, features.constant_velocity_times);
  if (candidates.any_static) {
    toTimes(candidates.static_bodies, 1.0F, candidate.time_to_goal, features.static_times);
  } else {
    features.static_times.fill(static_cast<float>(NEVER));
  }
}

}  // namespace

void computeMoveFeatures(const PerceptionBatch& batch, const MoveBlock* moves, std::size_t stride, std::size_t count,
                         const CollisionPrediction& prediction, MoveFeatures* features) {
  std::array<Course, MAX_BATCH> candidates;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  const std::size_t size = batch.size();
  for (std::size_t k = 0; k < size; ++k) {
    begin(batch[k].self, moves[k * stride], count, prediction, features[k], candidates[k]);
  }
  for (std::size_t k = 0; k < size; ++k) {
    accumulateTimeToCollision(batch[k], candidates[k].preferred, prediction.personal_space, candidates[k].candidates);
  }
  for (std::size_t k = 0; k < size; ++k) finish(candidates[k], features[k]);
}

}  // namespace crowd
