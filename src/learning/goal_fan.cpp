#include "social_crowd/learning/goal_fan.h"

#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

/// Unit vector towards the goal, agent frame; straight ahead at the goal itself.
Vector2 goalDirection(const Perception& perception) {
  const double distance = perception.self.goal.norm();
  if (distance <= 0.0) return Vector2::UnitX();
  return perception.self.goal / distance;
}

}  // namespace

GoalFan::GoalFan(const Parameters& parameters)
    : parameters_(parameters), rule_(parameters.gap_sharing, parameters.lookout) {
  addBothSides(parameters.headings, 1.0);
  addBothSides(parameters.slow_headings, parameters.slow_share);
  if (parameters.stay) add(Vector2::UnitX(), 0.0, true, size());  // stay, and go on looking the same way
}

void GoalFan::addBothSides(const std::vector<double>& headings, double share) {
  for (const double heading : headings) {
    const Action left = size();
    const bool has_two_sides = heading > 0.0 && heading < 180.0;
    add(unitVector(toRadians(heading)), share, false, has_two_sides ? left + 1 : left);
    if (has_two_sides) add(unitVector(toRadians(-heading)), share, false, left);
  }
}

void GoalFan::add(const Vector2& direction, double share, bool from_heading, Action mirrored) {
  moves_.push_back({direction, share, from_heading, mirrored});
}

CandidateMove GoalFan::moveOf(const FanMove& move, const Vector2& bearing) const {
  const Vector2& d = move.direction;
  if (move.from_heading) return {d, move.share, move.share};
  return {
      {bearing.x() * d.x() - bearing.y() * d.y(), bearing.y() * d.x() + bearing.x() * d.y()}, move.share, move.share};
}

RelativeAction GoalFan::relativeAction(const Perception& perception, Action action) const {
  CandidateMove move = moveOf(moves_[action], goalDirection(perception));
  rule_.cut(perception, &move, 1);
  return toAction(move);
}

void GoalFan::findMoves(const Perception& perception, CandidateMove* moves) const {
  const Vector2 bearing = goalDirection(perception);
  for (std::size_t i = 0; i < moves_.size(); ++i) moves[i] = moveOf(moves_[i], bearing);
  rule_.cut(perception, moves, moves_.size());
}

std::string GoalFan::spec() const {
  return std::string("{type: ") + TYPE + ", headings: " + toText(parameters_.headings) +
         ", slow_headings: " + toText(parameters_.slow_headings) + ", slow_share: " + toText(parameters_.slow_share) +
         ", stay: " + (parameters_.stay ? "true" : "false") + ", gap_sharing: " + toText(parameters_.gap_sharing) +
         ", lookout: " + toText(parameters_.lookout) + "}";
}

}  // namespace crowd
