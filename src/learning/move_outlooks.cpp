#include "social_crowd/learning/move_outlooks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "social_crowd/learning/time_to_contact.h"

namespace crowd {
namespace {

using Lanes = MoveOutlooks::Lanes;
constexpr std::size_t LANES = MoveOutlooks::LANES;

/// What is known of an agent while its outlooks are worked out.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): begin() writes it, and zeroing takes time
struct Course {
  CandidateVelocities candidates;
  Vector2 preferred;   // its velocity if nobody were there [m/s]
  float speed;         // no candidate is faster [m/s]
  float time_to_goal;  // at full speed; what lies behind the goal does not count [s]
};

/// Of a move of which the rule leaves too little the velocity is that of staying.
/// @param walking whether the agent walked in the last tick: else no move is a turn
void findCandidates(const MoveBlock& moves, float least_share, float speed, bool walking,
                    MoveOutlooks& __restrict outlooks, CandidateVelocities& __restrict candidates) {
  for (std::size_t i = 0; i < LANES; ++i) {
    const auto x = static_cast<float>(moves.x[i]);
    const auto y = static_cast<float>(moves.y[i]);
    const auto wanted = static_cast<float>(moves.wanted[i]);
    const float share = static_cast<float>(moves.share[i]) / wanted;
    const float left = wanted > 0.0F ? share : 1.0F;
    const float pace = left < least_share ? 0.0F : wanted * speed;
    outlooks.shares[i] = left;
    outlooks.turn_cosines[i] = walking ? x : 1.0F;
    candidates.xs[i] = pace * x;
    candidates.ys[i] = pace * y;
  }
}

void begin(const Chooser& chooser, std::size_t block, std::size_t count, double least_share, MoveOutlooks& outlooks,
           Course& course) {
  const AgentPerception& self = chooser.seen.self;
  const MoveBlock& moves = chooser.moves[block];
  const double distance = self.goal.norm();
  const double pace_to_goal = distance > 0.0 ? self.speed / distance : 0.0;
  course.preferred = pace_to_goal * self.goal;
  course.speed = static_cast<float>(self.speed);
  course.time_to_goal = static_cast<float>(distance / self.speed);
  course.candidates.count = count;
  course.candidates.clear();
  findCandidates(moves, static_cast<float>(least_share), course.speed, self.velocity != Vector2::Zero(), outlooks,
                 course.candidates);
}

/// What lies behind the goal does not count.
/// @param unit of the times that the inverses stand for [s]
void toTimes(const Lanes& soonest, float unit, float time_to_goal, Lanes& times) {
  for (std::size_t i = 0; i < LANES; ++i) {
    const float time = unit / soonest[i];
    times[i] = time > time_to_goal ? static_cast<float>(NEVER) : time;
  }
}

void finish(const Course& course, MoveOutlooks& outlooks) {
  const CandidateVelocities& candidates = course.candidates;
  outlooks.oncoming = std::sqrt(candidates.fastest) / course.speed;
  toTimes(candidates.reciprocal, 0.5F, course.time_to_goal, outlooks.reciprocal_times);
  toTimes(candidates.constant_velocity, 1.0F, course.time_to_goal, outlooks.selfish_times);
  if (candidates.any_fixed) {
    toTimes(candidates.fixed, 1.0F, course.time_to_goal, outlooks.fixed_times);
  } else {
    outlooks.fixed_times.fill(static_cast<float>(NEVER));
  }
}

}  // namespace

void foresee(const Choosers& choosers, std::size_t block, std::size_t count, double least_share,
             MoveOutlooks* outlooks) {
  std::array<Course, MAX_CHOOSERS> courses;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  const std::size_t size = choosers.size();
  for (std::size_t k = 0; k < size; ++k) begin(choosers[k], block, count, least_share, outlooks[k], courses[k]);
  for (std::size_t k = 0; k < size; ++k) {
    accumulateTimeToCollision(choosers[k].seen, courses[k].preferred, courses[k].candidates);
  }
  for (std::size_t k = 0; k < size; ++k) finish(courses[k], outlooks[k]);
}

}  // namespace crowd
