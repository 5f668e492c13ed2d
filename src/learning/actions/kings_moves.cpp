#include "social_crowd/learning/actions/kings_moves.h"

namespace crowd {

KingsMoves::KingsMoves(int rotations, bool stay) : rotations_(static_cast<Action>(rotations)) {
  for (int i = 0; i < rotations; ++i) moves_.push_back({2.0 * PI * i / rotations, 1.0});
  if (stay) moves_.push_back({0.0, 0.0});
}

std::string KingsMoves::spec() const {
  return std::string("{type: ") + TYPE + ", rotations: " + std::to_string(rotations_) +
         (size() > rotations_ ? ", stay: true}" : "}");
}

}  // namespace crowd
