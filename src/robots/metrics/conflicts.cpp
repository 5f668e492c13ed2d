#include "robots/metrics/conflicts.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr double LEAST_DECREASE = 1e-6;  // of an overlap; less may be rounding [m]

/// Overlap of two discs at their least distance within CONFLICT_TIME. @param velocity of the first, relative to the
/// second [m/s]
double predictedOverlap(const Vector2& offset, const Vector2& velocity, double reach) {
  const double closing = offset.dot(velocity);
  const double time = closing > 0.0 ? std::min(closing / velocity.squaredNorm(), Conflicts::CONFLICT_TIME) : 0.0;
  return std::max(0.0, reach - (offset - time * velocity).norm());
}

bool isKnown(const VelocityChange& change) { return change.before.allFinite() && change.now.allFinite(); }

}  // namespace

ResolvedConflicts resolvedConflict(const Vector2& offset, const VelocityChange& robot, const VelocityChange& person,
                                   double reach) {
  if (!isKnown(robot) || !isKnown(person)) return {};
  const auto overlap = [&](const Vector2& of_robot, const Vector2& of_person) {
    return predictedOverlap(offset, of_robot - of_person, reach);
  };
  const double before = overlap(robot.before, person.before);
  const double now = overlap(robot.now, person.now);
  if (before - now < LEAST_DECREASE) return {};
  const double robot_first = overlap(robot.now, person.before);
  const double person_first = overlap(robot.before, person.now);
  return {std::max(0.0, 0.5 * (before - robot_first + person_first - now)),
          std::max(0.0, 0.5 * (before - person_first + robot_first - now))};
}

void Conflicts::observe(const ObservedScene& scene) {
  std::swap(before_, now_);
  now_.clear();
  for (const ObservedPerson& person : scene.people) now_.emplace_back(person.id, person.velocity);
  std::sort(now_.begin(), now_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

ResolvedConflicts Conflicts::resolved(const ObservedScene& scene, const Robot& robot,
                                      const VelocityChange& velocity) const {
  ResolvedConflicts sum;
  for (const ObservedPerson& person : scene.people) {
    const auto found = std::lower_bound(before_.begin(), before_.end(), person.id,
                                        [](const auto& known, AgentId id) { return known.first < id; });
    if (found == before_.end() || found->first != person.id) continue;
    const ResolvedConflicts part =
        resolvedConflict(person.position - robot.pose.position, velocity, {found->second, person.velocity},
                         robot.start.footprint.reach() + person.radius);
    sum.by_robot += part.by_robot;
    sum.by_people += part.by_people;
  }
  return sum;
}

}  // namespace crowd
