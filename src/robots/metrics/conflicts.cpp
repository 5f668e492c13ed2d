#include "robots/metrics/conflicts.h"

#include <algorithm>
#include <limits>

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

const Vector2* Conflicts::velocityBefore(AgentId id) const {
  const auto found = std::lower_bound(before_.begin(), before_.end(), id,
                                      [](const auto& known, AgentId other) { return known.first < other; });
  return found != before_.end() && found->first == id ? &found->second : nullptr;
}

void Conflicts::observe(const ObservedScene& scene) {
  std::swap(before_, now_);
  now_.clear();
  for (const ObservedPerson& person : scene.people) {
    const Vector2 unknown = Vector2::Constant(std::numeric_limits<double>::quiet_NaN());
    now_.emplace_back(person.id, velocityBefore(person.id) != nullptr ? person.velocity : unknown);
  }
  std::sort(now_.begin(), now_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

ResolvedConflicts Conflicts::resolved(const ObservedScene& scene, RobotId id, const VelocityChange& velocity) const {
  const Robot& robot = *scene.robots[id].robot;
  const std::vector<RobotContact>& contacts = *scene.robots[id].contacts;
  ResolvedConflicts sum;
  for (const ObservedPerson& person : scene.people) {
    const auto is_of_person = [&](const RobotContact& contact) { return contact.agent == person.id; };
    const Vector2* const before = velocityBefore(person.id);
    if (before == nullptr || std::any_of(contacts.begin(), contacts.end(), is_of_person)) continue;
    const ResolvedConflicts part =
        resolvedConflict(person.position - robot.pose.position, velocity, {*before, person.velocity},
                         robot.start.footprint.reach() + person.radius);
    sum.by_robot += part.by_robot;
    sum.by_people += part.by_people;
  }
  return sum;
}

}  // namespace crowd
