#pragma once

#include <utility>
#include <vector>

#include "robots/metrics/observed_scene.h"

namespace crowd {

/// @brief By how much predicted overlaps of a robot with people decreased in a tick, by whose change of velocity [m].
struct ResolvedConflicts {
  double by_robot = 0.0;
  double by_people = 0.0;
};

/// @brief A velocity in the tick before, and in this one [m/s], `map`.
struct VelocityChange {
  Vector2 before;
  Vector2 now;
};

/// @brief Divides the decrease of the predicted overlap of two bodies between their changes of velocity (ours, after
/// the metric "responsibility" of Probst and Wenzel 2025). The predicted overlap is that of the discs at their least
/// distance within the next CONFLICT_TIME, if both keep their velocities; each gets its mean share over both orders of
/// the changes (Shapley value), at least 0. Nothing if the overlap did not decrease, or a velocity is not known.
/// @param offset from the robot to the person [m] @param reach sum of the radii [m]
ResolvedConflicts resolvedConflict(const Vector2& offset, const VelocityChange& robot, const VelocityChange& person,
                                   double reach);

/// @brief Conflicts of robots with all people of a scene.
class Conflicts {
 public:
  static constexpr double CONFLICT_TIME = 5.0;  ///< for which overlaps are predicted [s]

  /// @brief Notes the velocities of people. Call it once for each tick.
  void observe(const ObservedScene& scene);
  /// @brief What was resolved in the tick that ended with this scene. People in contact with the robot do not count,
  /// and those who were not there in the two ticks before: their velocities may be those of an impact, or not known.
  ResolvedConflicts resolved(const ObservedScene& scene, RobotId id, const VelocityChange& velocity) const;

 private:
  using Velocities = std::vector<std::pair<AgentId, Vector2>>;  // by id; NaN: not known [m/s]

  /// That of a person in the tick before; null if the person was not there.
  const Vector2* velocityBefore(AgentId id) const;

  Velocities before_;
  Velocities now_;
};

}  // namespace crowd
