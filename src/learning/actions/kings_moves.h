#pragma once

#include <vector>

#include "learning/actions/action_set.h"
#include "learning/directions.h"

namespace crowd {

/// @brief The action set of the thesis (3.2.2.2): turn by a multiple of 360 degrees / rotations and walk at full speed.
/// With the thesis's 8 rotations these are a chess king's moves: 0, 45, ... 315 degrees, in an order of our choice.
/// Optionally, the last action is to stay (thesis 5.2): neither turn nor move. With absolute directions the agent turns
/// to that multiple in `map`.
class KingsMoves : public ActionSet {
 public:
  static constexpr const char* TYPE = "kings_moves";
  static constexpr int DEFAULT_ROTATIONS = 8;

  explicit KingsMoves(int rotations = DEFAULT_ROTATIONS, bool stay = false,
                      Directions directions = Directions::RELATIVE);

  Action size() const override { return static_cast<Action>(relative_actions_.size()); }
  void findMoves(const PerceptionBatch& batch, MoveBlock* moves) const override;
  bool hasConstantMoves() const override { return directions_ == Directions::RELATIVE; }
  /// @brief Returns the exact multiple of 360 degrees / rotations, less the heading with absolute directions.
  RelativeAction relativeAction(const Perception& seen, const MoveBlock* moves, Action action) const override;
  Action mirrored(Action action) const override { return turns(action) ? (rotations_ - action) % rotations_ : action; }
  std::string spec() const override;

 private:
  bool turns(Action action) const { return action < rotations_; }

  Action rotations_;
  Directions directions_;
  std::vector<RelativeAction> relative_actions_;
};

/// @brief Reads a map of the parameters, all optional. @throws InputError
std::shared_ptr<const ActionSet> readKingsMoves(YamlMap& map);

}  // namespace crowd
