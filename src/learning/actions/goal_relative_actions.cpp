#include "social_crowd/learning/actions/goal_relative_actions.h"

#include <algorithm>

#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

/// Returns the unit vector towards the goal, agent frame; straight ahead if the agent is at the goal.
Vector2 goalDirection(const Perception& perception) {
  const double distance = perception.self.goal.norm();
  if (distance <= 0.0) return Vector2::UnitX();
  return perception.self.goal / distance;
}

/// Rotates the first `turned` moves to a bearing; copies the others.
void turn(const MoveBlock& base_moves, const Vector2& bearing, std::size_t turned, MoveBlock& moves) {
  const double cosine = bearing.x();
  const double sine = bearing.y();
  moves.x = base_moves.x;
  moves.y = base_moves.y;
  moves.wanted = base_moves.wanted;
  for (std::size_t i = 0; i < std::min(turned, MoveBlock::SIZE); ++i) {
    moves.x[i] = cosine * base_moves.x[i] - sine * base_moves.y[i];
    moves.y[i] = sine * base_moves.x[i] + cosine * base_moves.y[i];
  }
}

}  // namespace

GoalRelativeActions::GoalRelativeActions(const Parameters& parameters)
    : parameters_(parameters), rule_(parameters.gap_sharing, parameters.lookout) {
  addBothSides(parameters.headings, 1.0);
  addBothSides(parameters.slow_headings, parameters.slow_fraction);
  turned_ = size();
  if (parameters.stay) add(Vector2::UnitX(), 0.0, size());  // keeps the heading
  repeatLast(base_moves_.data(), size());
}

void GoalRelativeActions::addBothSides(const std::vector<double>& headings, double fraction) {
  for (const double heading : headings) {
    const Action left = size();
    const bool has_two_sides = heading > 0.0 && heading < 180.0;
    add(unitVector(toRadians(heading)), fraction, has_two_sides ? left + 1 : left);
    if (has_two_sides) add(unitVector(toRadians(-heading)), fraction, left);
  }
}

void GoalRelativeActions::add(const Vector2& direction, double fraction, Action mirrored) {
  base_moves_.resize(blocksOf(mirrored_.size() + 1));
  setMove(base_moves_.data(), mirrored_.size(), {direction, fraction, fraction});
  mirrored_.push_back(mirrored);
}

void GoalRelativeActions::findAction(const Perception& perception, Action action, RelativeAction& relative) const {
  MoveBlock move;  // NOLINT(cppcoreguidelines-pro-type-member-init): turn() writes it
  const std::size_t lane = action % MoveBlock::SIZE;
  turn(base_moves_[action / MoveBlock::SIZE], goalDirection(perception), action < turned_ ? MoveBlock::SIZE : 0, move);
  move.set(0, move.move(lane));
  rule_.cut(perception, &move, 1);
  relative = toAction(move.move(0));
}

void GoalRelativeActions::findMoves(const DecisionContext& context) const { findMovesOfAll({&context, 1}); }

void GoalRelativeActions::findMovesOfAll(const DecisionBatch& contexts) const {
  for (const DecisionContext& context : contexts) {
    const Vector2 bearing = goalDirection(context.seen);
    for (std::size_t block = 0; block < base_moves_.size(); ++block) {
      const std::size_t first = block * MoveBlock::SIZE;
      turn(base_moves_[block], bearing, turned_ > first ? turned_ - first : 0, context.moves[block]);
    }
  }
  rule_.cut(contexts, size());
}

std::string GoalRelativeActions::spec() const {
  return std::string("{type: ") + TYPE + ", headings: " + toText(parameters_.headings) +
         ", slow_headings: " + toText(parameters_.slow_headings) +
         ", slow_fraction: " + toText(parameters_.slow_fraction) + ", stay: " + (parameters_.stay ? "true" : "false") +
         ", gap_sharing: " + toText(parameters_.gap_sharing) + ", lookout: " + toText(parameters_.lookout) + "}";
}

}  // namespace crowd
