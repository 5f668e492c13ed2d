#include "social_crowd/learning/goal_fan.h"

#include <algorithm>

#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

/// Unit vector towards the goal, agent frame; straight ahead at the goal itself.
Vector2 goalDirection(const Perception& perception) {
  const double distance = perception.self.goal.norm();
  if (distance <= 0.0) return Vector2::UnitX();
  return perception.self.goal / distance;
}

/// The fan around another bearing than the heading.
/// @param turned so many moves are measured from there, the others from the heading
void turn(const MoveBlock& fan, const Vector2& bearing, std::size_t turned, MoveBlock& moves) {
  const double cosine = bearing.x();
  const double sine = bearing.y();
  moves.x = fan.x;
  moves.y = fan.y;
  moves.wanted = fan.wanted;
  for (std::size_t i = 0; i < std::min(turned, MoveBlock::SIZE); ++i) {
    moves.x[i] = cosine * fan.x[i] - sine * fan.y[i];
    moves.y[i] = sine * fan.x[i] + cosine * fan.y[i];
  }
}

}  // namespace

GoalFan::GoalFan(const Parameters& parameters)
    : parameters_(parameters), rule_(parameters.gap_sharing, parameters.lookout) {
  addBothSides(parameters.headings, 1.0);
  addBothSides(parameters.slow_headings, parameters.slow_share);
  turned_ = size();
  if (parameters.stay) add(Vector2::UnitX(), 0.0, size());  // stay, and go on looking the same way
  repeatLast(fan_.data(), size());
}

void GoalFan::addBothSides(const std::vector<double>& headings, double share) {
  for (const double heading : headings) {
    const Action left = size();
    const bool has_two_sides = heading > 0.0 && heading < 180.0;
    add(unitVector(toRadians(heading)), share, has_two_sides ? left + 1 : left);
    if (has_two_sides) add(unitVector(toRadians(-heading)), share, left);
  }
}

void GoalFan::add(const Vector2& direction, double share, Action mirrored) {
  fan_.resize(blocksOf(mirrored_.size() + 1));
  setMove(fan_.data(), mirrored_.size(), {direction, share, share});
  mirrored_.push_back(mirrored);
}

void GoalFan::findAction(const Perception& perception, Action action, RelativeAction& relative) const {
  MoveBlock move;  // NOLINT(cppcoreguidelines-pro-type-member-init): turn() writes it
  const std::size_t lane = action % MoveBlock::SIZE;
  turn(fan_[action / MoveBlock::SIZE], goalDirection(perception), action < turned_ ? MoveBlock::SIZE : 0, move);
  move.set(0, move.move(lane));
  rule_.cut(perception, &move, 1);
  relative = toAction(move.move(0));
}

void GoalFan::findMoves(const Chooser& chooser) const { findMovesOfAll({&chooser, 1}); }

void GoalFan::findMovesOfAll(const Choosers& choosers) const {
  for (const Chooser& chooser : choosers) {
    const Vector2 bearing = goalDirection(chooser.seen);
    for (std::size_t block = 0; block < fan_.size(); ++block) {
      const std::size_t first = block * MoveBlock::SIZE;
      turn(fan_[block], bearing, turned_ > first ? turned_ - first : 0, chooser.moves[block]);
    }
  }
  rule_.cut(choosers, size());
}

std::string GoalFan::spec() const {
  return std::string("{type: ") + TYPE + ", headings: " + toText(parameters_.headings) +
         ", slow_headings: " + toText(parameters_.slow_headings) + ", slow_share: " + toText(parameters_.slow_share) +
         ", stay: " + (parameters_.stay ? "true" : "false") + ", gap_sharing: " + toText(parameters_.gap_sharing) +
         ", lookout: " + toText(parameters_.lookout) + "}";
}

}  // namespace crowd
