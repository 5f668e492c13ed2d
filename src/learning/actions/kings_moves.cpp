#include "learning/actions/kings_moves.h"

namespace crowd {

KingsMoves::KingsMoves(int rotations, bool stay, Directions directions)
    : rotations_(static_cast<Action>(rotations)), directions_(directions) {
  for (int i = 0; i < rotations; ++i) relative_actions_.push_back({2.0 * PI * i / rotations, 1.0});
  if (stay) relative_actions_.push_back({0.0, 0.0});
}

void KingsMoves::findMoves(const PerceptionBatch& batch, MoveBlock* moves) const {
  for (const Perception& seen : batch) {
    for (Action action = 0; action < size(); ++action) {
      const auto [rotation, speed_fraction] = relativeAction(seen, moves, action);
      setMove(moves, action, {unitVector(rotation), speed_fraction, speed_fraction});
    }
    repeatLast(moves, size());
    moves += blocksOf(size());
  }
}

RelativeAction KingsMoves::relativeAction(const Perception& seen, const MoveBlock* /*moves*/, Action action) const {
  RelativeAction relative = relative_actions_[action];
  if (directions_ == Directions::ABSOLUTE && turns(action)) relative.rotation -= seen.self.pose.heading;
  return relative;
}

std::string KingsMoves::spec() const {
  return std::string("{type: ") + TYPE + ", rotations: " + std::to_string(rotations_) +
         (size() > rotations_ ? ", stay: true" : "") +
         (directions_ == Directions::ABSOLUTE ? ", directions: absolute}" : "}");
}

std::shared_ptr<const ActionSet> readKingsMoves(YamlMap& map) {
  map.allow({"type", "rotations", "stay", "directions"});
  const auto rotations = static_cast<int>(map.whole("rotations", 2, 360, KingsMoves::DEFAULT_ROTATIONS));
  return std::make_shared<KingsMoves>(rotations, map.flag("stay", false), DIRECTIONS.read(map, Directions::RELATIVE));
}

}  // namespace crowd
