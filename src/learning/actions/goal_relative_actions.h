#pragma once

#include <memory>
#include <vector>

#include "avoidance/separation_rule.h"
#include "avoidance/time_gap.h"
#include "learning/actions/action_set.h"
#include "learning/actions/gait.h"

namespace crowd {

/// @brief Headings relative to the goal's bearing, at full speed and at a slower speed, and staying. The separation
/// rule limits the moves (see SeparationRule), and so does the time gap, if one is set (see TimeGap).
class GoalRelativeActions : public ActionSet {
 public:
  static constexpr const char* TYPE = "goal_relative";

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

  GoalRelativeActions() : GoalRelativeActions(Parameters()) {}
  explicit GoalRelativeActions(const Parameters& parameters);

  Action size() const override { return static_cast<Action>(mirrored_.size()); }
  void findMoves(const PerceptionBatch& batch, MoveBlock* moves) const override;
  RelativeAction relativeAction(const Perception& seen, const MoveBlock* moves, Action action) const override;
  /// @brief The same without gait and anticipation time; agents beside their goal do not slow down to reach it.
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

/// @brief Reads a map of the parameters, all optional. @throws InputError
std::shared_ptr<const ActionSet> readGoalRelativeActions(YamlMap& map);

}  // namespace crowd
