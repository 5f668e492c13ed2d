#include "learning/actions/kings_moves.h"

#include <algorithm>

namespace crowd {

KingsMoves::KingsMoves(int rotations, bool stay) : rotations_(static_cast<Action>(rotations)) {
  for (int i = 0; i < rotations; ++i) relative_actions_.push_back({2.0 * PI * i / rotations, 1.0});
  if (stay) relative_actions_.push_back({0.0, 0.0});
  moves_.resize(blocksOf(size()));
  for (Action action = 0; action < size(); ++action) {
    const auto [rotation, speed_fraction] = relative_actions_[action];
    setMove(moves_.data(), action, {unitVector(rotation), speed_fraction, speed_fraction});
  }
  repeatLast(moves_.data(), size());
}

void KingsMoves::findMoves(const PerceptionBatch& batch, MoveBlock* moves) const {
  for (std::size_t k = 0; k < batch.size(); ++k) moves = std::copy(moves_.begin(), moves_.end(), moves);
}

std::string KingsMoves::spec() const {
  return std::string("{type: ") + TYPE + ", rotations: " + std::to_string(rotations_) +
         (size() > rotations_ ? ", stay: true}" : "}");
}

std::shared_ptr<const ActionSet> readKingsMoves(YamlMap& map) {
  map.allow({"type", "rotations", "stay"});
  const auto rotations = static_cast<int>(map.whole("rotations", 2, 360, KingsMoves::DEFAULT_ROTATIONS));
  return std::make_shared<KingsMoves>(rotations, map.flag("stay", false));
}

}  // namespace crowd
