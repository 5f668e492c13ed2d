#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "avoidance/braking_rule.h"
#include "avoidance/separation_rule.h"
#include "avoidance/time_gap.h"
#include "common/text/numbers.h"
#include "learning/actions/action_set.h"
#include "learning/actions/gait.h"

namespace crowd {
namespace {

constexpr double STANDING = 0.05;  // an agent whose move is admissible to less than this does not walk

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

/// A move of an agent with motion limits, so slow that from its velocity v the agent can still turn to the goal: at a
/// distance d and an angle phi to the direction of the move, the circle of radius v^2 / acceleration that leads from
/// the direction of the move through the goal has the radius d / (2 sin phi). Faster ones go round the goal for ever.
CandidateMove reachingGoal(const CandidateMove& move, const Perception& seen) {
  const double distance = seen.self.goal.norm();
  const double aside = std::abs(cross(seen.self.goal, move.direction));  // distance * sin(phi)
  if (aside <= 0.0) return move;
  const double fastest = std::sqrt(0.5 * seen.motion.acceleration * distance * distance / aside);
  return {move.direction, move.wanted, std::min(move.fraction, fastest / seen.self.max_speed)};
}

KeyedRandom randomGaitOf(const Perception& seen) { return {0, KeyedRandom::GAIT, {seen.episode, seen.self.agent}}; }

/// What becomes of a move by the gait of the agent.
CandidateMove deviate(const CandidateMove& move, const Gait& gait, const Perception& seen) {
  const GaitDeviation deviation = gait.at(randomGaitOf(seen), seen.time);
  // The smaller the admissible fraction of the move, the less the heading deviates.
  const double turn = move.fraction * deviation.turn;
  return {Rotation(turn).outOfFrame(move.direction), move.wanted, deviation.pace * move.fraction};
}

/// Headings relative to the goal's bearing, at full speed and at a slower speed, and staying. The separation
/// rule limits the moves (see SeparationRule), and so does the time gap, if one is set (see TimeGap).
class GoalRelativeActions : public ActionSet {
 public:
  static constexpr const char* TYPE = "goal_relative";
  static std::shared_ptr<const ActionSet> read(YamlMap& map);

  struct Parameters {
    std::vector<double> headings = {0, 10, 20, 35, 55, 80, 120, 180};  ///< to either side, ascending [degrees]
    std::vector<double> slow_headings = {0, 35};                       ///< of the slower moves [degrees]
    double slow_fraction = 0.5;                                        ///< of the maximum speed
    bool stay = true;                                                  ///< whether staying is an action, the last one
    GapSharing gap_sharing = GapSharing::MOVING;                       ///< see SeparationRule
    double lookout = 1.5;            ///< see SeparationRule [s]; 0: moving obstacles are ignored
    double time_gap = 0.0;           ///< see TimeGap [s]; 0: none is kept
    double time_gap_width = 1.0;     ///< see TimeGap
    double anticipation_time = 0.0;  ///< see TimeGap [s]
    MotionLimits motion;             ///< see ActionSet::motion()
    Gait gait;                       ///< of agents with motion limits
  };

  explicit GoalRelativeActions(const Parameters& parameters);

  Action size() const override { return static_cast<Action>(mirrored_.size()); }
  void findMoves(const PerceptionBatch& batch, MoveBlock* moves, BrakingLimits* limits) const override;
  RelativeAction relativeAction(const Perception& seen, const MoveBlock* moves, const BrakingLimits& limits,
                                Action action) const override;
  /// The same without gait and anticipation time; agents beside their goal do not slow down to reach it.
  std::shared_ptr<const ActionSet> whileLearning() const override;
  MotionLimits motion() const override { return parameters_.motion; }
  Action mirrored(Action action) const override { return mirrored_[action]; }
  std::string spec() const override;

 private:
  void addBothSides(const std::vector<double>& headings, double fraction);
  void add(const Vector2& direction, double fraction, Action mirrored);
  void keepTimeGap(const PerceptionBatch& batch, MoveBlock* moves) const;
  std::string timeGapSpec() const;

  Parameters parameters_;
  SeparationRule rule_;
  TimeGap time_gap_;
  std::vector<MoveBlock> base_moves_;  // relative to the heading
  std::size_t turned_ = 0;             // number of moves, from the first, that are relative to the goal's bearing
  std::vector<Action> mirrored_;
  bool slows_at_goal_ = true;  // see reachingGoal()
};

GoalRelativeActions::GoalRelativeActions(const Parameters& parameters)
    : parameters_(parameters),
      rule_(parameters.gap_sharing, parameters.lookout),
      time_gap_(parameters.time_gap, parameters.time_gap_width, parameters.anticipation_time) {
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

void GoalRelativeActions::findMoves(const PerceptionBatch& batch, MoveBlock* moves, BrakingLimits* limits) const {
  MoveBlock* next = moves;
  for (const Perception& seen : batch) {
    const Vector2 bearing = goalDirection(seen);
    for (std::size_t block = 0; block < base_moves_.size(); ++block) {
      const std::size_t first = block * MoveBlock::SIZE;
      turn(base_moves_[block], bearing, turned_ > first ? turned_ - first : 0, *next++);
    }
  }
  rule_.cut(batch, moves, size(), limits);
  if (time_gap_.isOn()) keepTimeGap(batch, moves);
}

/// An agent that must escape from a moving obstacle does not slow down.
void GoalRelativeActions::keepTimeGap(const PerceptionBatch& batch, MoveBlock* moves) const {
  for (std::size_t k = 0; k < batch.size(); ++k) {
    if (!rule_.mustEscape(batch[k])) time_gap_.cut(batch[k], moves + k * base_moves_.size(), size());
  }
}

RelativeAction GoalRelativeActions::relativeAction(const Perception& seen, const MoveBlock* moves,
                                                   const BrakingLimits& limits, Action action) const {
  const CandidateMove chosen = moveAt(moves, action);
  if (!seen.motion.areOn()) return toAction(chosen);
  const BrakingRule rule(seen, limits);
  if (seen.self.held) return rule.actionTowards(CandidateMove{Vector2::UnitX(), 0.0, 0.0});
  if (rule_.mustEscape(seen)) return rule.actionTowards(chosen);  // as it is
  if (chosen.fraction < STANDING) {
    const auto tick = static_cast<std::uint64_t>(std::llround(seen.time / seen.tick_duration));
    const auto shift = parameters_.gait.shiftAt(randomGaitOf(seen), size(), tick, seen.tick_duration);
    if (shift) return rule.actionTowards(moveAt(moves, *shift));
  }
  const CandidateMove move = slows_at_goal_ ? reachingGoal(chosen, seen) : chosen;
  if (!parameters_.gait.isOn()) return rule.actionTowards(move);
  return rule.actionTowards(deviate(move, parameters_.gait, seen), move);
}

std::shared_ptr<const ActionSet> GoalRelativeActions::whileLearning() const {
  Parameters parameters = parameters_;
  parameters.gait = {};
  parameters.anticipation_time = 0.0;
  const auto actions = std::make_shared<GoalRelativeActions>(parameters);
  actions->slows_at_goal_ = false;
  return actions;
}

/// Absent while it is off: headers of tables stay as they were.
std::string GoalRelativeActions::timeGapSpec() const {
  if (!time_gap_.isOn()) return "";
  return ", time_gap: " + toText(parameters_.time_gap) + ", time_gap_width: " + toText(parameters_.time_gap_width) +
         (parameters_.anticipation_time > 0.0 ? ", anticipation_time: " + toText(parameters_.anticipation_time) : "");
}

std::string GoalRelativeActions::spec() const {
  return std::string("{type: ") + TYPE + ", headings: " + toText(parameters_.headings) +
         ", slow_headings: " + toText(parameters_.slow_headings) +
         ", slow_fraction: " + toText(parameters_.slow_fraction) + ", stay: " + (parameters_.stay ? "true" : "false") +
         ", gap_sharing: " + GAP_SHARINGS.nameOf(parameters_.gap_sharing) +
         ", lookout: " + toText(parameters_.lookout) + timeGapSpec() +
         (parameters_.motion.areOn() ? ", motion: " + toText(parameters_.motion) : "") +
         (parameters_.gait.isOn() ? ", gait: " + toText(parameters_.gait) : "") + "}";
}

std::shared_ptr<const ActionSet> GoalRelativeActions::read(YamlMap& map) {
  map.allow({"type", "headings", "slow_headings", "slow_fraction", "stay", "gap_sharing", "lookout", "time_gap",
             "time_gap_width", "anticipation_time", "motion", "gait"});
  Parameters parameters;
  parameters.headings = map.risingNumbers("headings", 0.0, 180.0, parameters.headings);
  if (parameters.headings.empty()) throwExpected(map.placeOf("headings"), map.need("headings"), "at least one");
  parameters.slow_headings = map.risingNumbers("slow_headings", 0.0, 180.0, parameters.slow_headings);
  parameters.slow_fraction = map.number("slow_fraction", NumberRule::FRACTION, parameters.slow_fraction);
  parameters.stay = map.flag("stay", parameters.stay);
  parameters.gap_sharing = GAP_SHARINGS.read(map, parameters.gap_sharing);
  parameters.lookout = map.number("lookout", NumberRule::NOT_NEGATIVE, parameters.lookout);
  parameters.time_gap = map.number("time_gap", NumberRule::NOT_NEGATIVE, parameters.time_gap);
  parameters.time_gap_width = map.number("time_gap_width", NumberRule::NOT_NEGATIVE, parameters.time_gap_width);
  parameters.anticipation_time =
      map.number("anticipation_time", NumberRule::NOT_NEGATIVE, parameters.anticipation_time);
  if (map.has("motion")) parameters.motion = readMotionLimits(map.find("motion"), map.placeOf("motion"));
  if (map.has("gait")) parameters.gait = readGait(map.find("gait"), map.placeOf("gait"));
  return std::make_shared<GoalRelativeActions>(parameters);
}

}  // namespace

ActionSetType goalRelativeActions() {
  return {GoalRelativeActions::TYPE, "headings relative to the goal's bearing, limited by the separation rule",
          GoalRelativeActions::read};
}

}  // namespace crowd
