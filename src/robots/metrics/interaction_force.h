#pragma once

#include "geometry/geometry.h"

namespace crowd {

/// @brief The body on which a social force acts, or which causes it.
struct ForceBody {
  Vector2 position = Vector2::Zero();  ///< [m]
  Vector2 velocity = Vector2::Zero();  ///< [m/s]
};

/// @brief The interaction force by which one body avoids another one [m/s^2]: f(d, theta) of Moussaid et al. 2009, eq.
/// (3) to (6), with the parameters of lightsfm, which HuNavSim uses (docs/metrics.md, "Forces"). Zero for bodies at the
/// same place.
Vector2 interactionForce(const ForceBody& on, const ForceBody& from);

/// @brief The amount of the force by which a wall or an obstacle repels a body [m/s^2], as in lightsfm.
/// @param clearance between their rims [m]; infinite: there is none
double obstacleForce(double clearance);

}  // namespace crowd
