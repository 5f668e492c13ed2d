#include "ros/markers/marker_gait.h"

#include <cmath>
#include <iterator>

namespace crowd {
namespace {

constexpr double GOLDEN_RATIO = 0.61803398874989485;  // spreads the beginnings evenly, for any number of persons

}  // namespace

void WalkingCycles::walk(std::uint32_t person, const Pose& pose) {
  const auto [entry, is_new] = persons_.try_emplace(person, Walker{pose.position, GOLDEN_RATIO * person, STILL_STATES});
  if (is_new) return;
  Walker& walker = entry->second;
  const Vector2 moved = pose.position - walker.position;
  const double distance = moved.norm();
  if (distance < LEAST_MOVE) {
    if (walker.still < STILL_STATES) ++walker.still;
    return;  // the position stays, so that slow movements add up
  }
  walker.position = pose.position;
  if (distance > JUMP) return;
  walker.still = 0;
  walker.cycles += (moved.dot(unitVector(pose.heading)) < 0.0 ? -distance : distance) / STRIDE;
}

int WalkingCycles::frameOf(std::uint32_t person) const {
  const auto found = persons_.find(person);
  if (found == persons_.end() || found->second.still >= STILL_STATES) return STANDING;
  const double cycles = found->second.cycles;
  return static_cast<int>((cycles - std::floor(cycles)) * FRAMES) % FRAMES;
}

void WalkingCycles::keepOnly(const std::set<std::uint32_t>& persons) {
  for (auto person = persons_.begin(); person != persons_.end();) {
    person = persons.count(person->first) > 0 ? std::next(person) : persons_.erase(person);
  }
}

}  // namespace crowd
