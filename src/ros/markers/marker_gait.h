#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Which picture of a walking cycle each person shows: by the distance walked, so that feet do not slide.
///
/// A person stands if it has not moved for STILL_STATES states. A movement against the heading runs the cycle
/// backwards. A step of more than JUMP is a teleport, which does not count.
///
/// Used by MarkerScene in the thread of crowd_markers.
class WalkingCycles {
 public:
  static constexpr int FRAMES = 8;            ///< pictures of a cycle, numbered from 0
  static constexpr int STANDING = FRAMES;     ///< number of the picture of a person who stands
  static constexpr double STRIDE = 1.4;       ///< distance walked in a cycle of two steps [m]
  static constexpr double LEAST_MOVE = 5e-3;  ///< a shorter movement between two states is none [m]
  static constexpr double JUMP = 1.0;         ///< [m]
  static constexpr int STILL_STATES = 3;

  /// @brief Takes the pose of a person in the next state; the first one decides where its cycle begins.
  void walk(std::uint32_t person, const Pose& pose);
  /// @brief Returns 0 to FRAMES - 1, or STANDING. A person who was never seen stands.
  int frameOf(std::uint32_t person) const;
  std::size_t size() const { return persons_.size(); }
  /// @brief Forgets all other persons.
  void keepOnly(const std::set<std::uint32_t>& persons);
  /// @brief Forgets all persons.
  void clear() { persons_.clear(); }

 private:
  struct Walker {
    Vector2 position;
    double cycles;  // walked so far; persons begin at different parts of a cycle
    int still;      // number of the last states without movement
  };
  std::map<std::uint32_t, Walker> persons_;
};

}  // namespace crowd
