#include "learning/actions/kings_moves.h"

#include <algorithm>

namespace crowd {
namespace {

CandidateMove toMove(const RelativeAction& action) {
  return {unitVector(action.rotation), action.speed_fraction, action.speed_fraction};
}

}  // namespace

KingsMoves::KingsMoves(int rotations, bool stay, Directions directions)
    : rotations_(static_cast<Action>(rotations)), directions_(directions) {
  for (int i = 0; i < rotations; ++i) relative_actions_.push_back({2.0 * PI * i / rotations, 1.0});
  if (stay) relative_actions_.push_back({0.0, 0.0});
  moves_.resize(blocksOf(size()));
  for (Action action = 0; action < size(); ++action) {
    setMove(moves_.data(), action, toMove(relative_actions_[action]));
  }
  repeatLast(moves_.data(), size());
}

void KingsMoves::findMoves(const PerceptionBatch& batch, MoveBlock* moves) const {
  for (const Perception& seen : batch) {
    std::copy(moves_.begin(), moves_.end(), moves);
    if (directions_ == Directions::ABSOLUTE) {
      for (Action action = 0; action < size(); ++action) {
        setMove(moves, action, toMove(relativeAction(seen, moves, action)));
      }
      repeatLast(moves, size());
    }
    moves += moves_.size();
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
