#include "navigation/sliding.h"

#include <algorithm>

namespace crowd {

std::optional<Vector2> slideAlong(const Vector2& direction, const std::vector<Vector2>& contacts) {
  constexpr double LEAST = 0.2;  // part of the direction that must be left
  constexpr int ROUNDS = 4;      // two contacts may push the direction to and fro
  Vector2 slid = direction;
  for (int round = 0; round < ROUNDS; ++round) {
    for (const Vector2& contact : contacts) slid -= std::max(0.0, contact.dot(slid)) * contact;
  }
  if (slid == direction || slid.norm() < LEAST) return std::nullopt;
  return slid.normalized();
}

}  // namespace crowd
