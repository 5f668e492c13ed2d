#include <vector>

#include "learning/actions/action_set.h"
#include "learning/directions.h"

namespace crowd {
namespace {

/// The action set of the thesis (3.2.2.2): turn by a multiple of 360 degrees / rotations and walk at full speed.
/// With the thesis's 8 rotations these are a chess king's moves: 0, 45, ... 315 degrees, in an order of our choice.
/// Optionally, the last action is to stay (thesis 5.2): neither turn nor move. With absolute directions the agent turns
/// to that multiple in `map`.
class KingsMoves : public ActionSet {
 public:
  static constexpr const char* TYPE = "kings_moves";
  static std::shared_ptr<const ActionSet> read(YamlMap& map);

  KingsMoves(int rotations, bool stay, Directions directions);

  Action size() const override { return static_cast<Action>(relative_actions_.size()); }
  void findMoves(const PerceptionBatch& batch, MoveBlock* moves, BrakingLimits* limits) const override;
  bool hasConstantMoves() const override { return directions_ == Directions::RELATIVE; }
  /// Returns the exact multiple of 360 degrees / rotations, less the heading with absolute directions.
  RelativeAction relativeAction(const Perception& seen, const MoveBlock* moves, const BrakingLimits& limits,
                                Action action) const override;
  Action mirrored(Action action) const override { return turns(action) ? (rotations_ - action) % rotations_ : action; }
  std::string spec() const override;

 private:
  bool turns(Action action) const { return action < rotations_; }

  Action rotations_;
  Directions directions_;
  std::vector<RelativeAction> relative_actions_;
};

KingsMoves::KingsMoves(int rotations, bool stay, Directions directions)
    : rotations_(static_cast<Action>(rotations)), directions_(directions) {
  for (int i = 0; i < rotations; ++i) relative_actions_.push_back({2.0 * PI * i / rotations, 1.0});
  if (stay) relative_actions_.push_back({0.0, 0.0});
}

void KingsMoves::findMoves(const PerceptionBatch& batch, MoveBlock* moves, BrakingLimits* /*limits*/) const {
  for (const Perception& seen : batch) {
    for (Action action = 0; action < size(); ++action) {
      const auto [rotation, speed_fraction] = relativeAction(seen, moves, {}, action);
      setMove(moves, action, {unitVector(rotation), speed_fraction, speed_fraction});
    }
    repeatLast(moves, size());
    moves += blocksOf(size());
  }
}

RelativeAction KingsMoves::relativeAction(const Perception& seen, const MoveBlock* /*moves*/,
                                          const BrakingLimits& /*limits*/, Action action) const {
  RelativeAction relative = relative_actions_[action];
  if (directions_ == Directions::ABSOLUTE && turns(action)) relative.rotation -= seen.self.pose.heading;
  return relative;
}

std::string KingsMoves::spec() const {
  return std::string("{type: ") + TYPE + ", rotations: " + std::to_string(rotations_) +
         (size() > rotations_ ? ", stay: true" : "") +
         (directions_ == Directions::ABSOLUTE ? ", directions: absolute}" : "}");
}

std::shared_ptr<const ActionSet> KingsMoves::read(YamlMap& map) {
  map.allow({"type", "rotations", "stay", "directions"});
  const auto rotations = static_cast<int>(map.whole("rotations", 2, 360, 8));
  return std::make_shared<KingsMoves>(rotations, map.flag("stay", false), DIRECTIONS.read(map, Directions::RELATIVE));
}

}  // namespace

ActionSetType kingsMoves() {
  return {KingsMoves::TYPE, "the thesis's moves: a rotation by a multiple of an angle, then a step at full speed",
          KingsMoves::read};
}

}  // namespace crowd
