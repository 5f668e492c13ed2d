#pragma once

#include <vector>

#include "world/occlusion.h"
#include "world/perception.h"

namespace crowd {

/// @brief Reduces perceptions that were made with a wider vision to those of a smaller one, so that a learner decides
/// and learns the same in a mixed crowd as alone. Not thread-safe.
class PerceptionLimiter {
 public:
  /// @param vision of the result
  explicit PerceptionLimiter(const Vision& vision) : vision_(vision) {}
  const Vision& vision() const { return vision_; }

  /// @brief Returns the perceptions as the world would make them with the vision of this object.
  /// @param perceptions valid, see requireValid()
  /// @param made_with vision of `perceptions`; it must cover that of this object
  /// @return `perceptions` itself if both visions are equal, else an object that is valid until the next call
  const Perceptions& limit(const Perceptions& perceptions, const Vision& made_with);

 private:
  void limitWalls(const Perception& wide);

  Vision vision_;
  Perceptions limited_;
  std::vector<Neighbour> neighbours_;  // buffer, of one agent
  Occlusion occlusion_;
};

}  // namespace crowd
