#pragma once

#include <vector>

#include "learning/actions/action_set.h"

namespace crowd {

/// @brief The action set of the thesis (3.2.2.2): turn by a multiple of 360 degrees / rotations and walk at full speed.
/// With the thesis's 8 rotations these are a chess king's moves: 0, 45, ... 315 degrees, in an order of our choice.
/// Optionally, the last action is to stay (thesis 5.2): neither turn nor move.
class KingsMoves : public ActionSet {
 public:
  static constexpr const char* TYPE = "kings_moves";
  static constexpr int DEFAULT_ROTATIONS = 8;

  explicit KingsMoves(int rotations = DEFAULT_ROTATIONS, bool stay = false);

  Action size() const override { return static_cast<Action>(relative_actions_.size()); }
  void findMoves(const PerceptionBatch& batch, MoveBlock* moves) const override;
  bool hasConstantMoves() const override { return true; }
  /// @brief Returns the exact multiple of 360 degrees / rotations.
  RelativeAction relativeAction(const Perception& /*seen*/, const MoveBlock* /*moves*/, Action action) const override {
    return relative_actions_[action];
  }
  Action mirrored(Action action) const override {
    return action < rotations_ ? (rotations_ - action) % rotations_ : action;
  }
  std::string spec() const override;

 private:
  Action rotations_;
  std::vector<RelativeAction> relative_actions_;
  std::vector<MoveBlock> moves_;  // the same for all agents
};

/// @brief Reads a map of the parameters, all optional. @throws InputError
std::shared_ptr<const ActionSet> readKingsMoves(YamlMap& map);

}  // namespace crowd
