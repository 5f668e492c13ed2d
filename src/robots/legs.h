#pragma once

#include <vector>

#include "robots/scanner.h"
#include "world/world.h"

namespace crowd {

/// @brief Appends the legs of a walking person: two discs of 0.06 m, 0.2 m apart, that swing by 0.15 m once per 1.3 m.
/// Both stay within the body.
/// @param pose of the body in `map` @param walked length of its way so far [m] @param radius of the body [m]
void addLegs(const Pose& pose, double walked, double radius, BodyNumber body, std::vector<ScanTarget>& targets);

/// @brief Lengths of the ways of the agents of a world, for the phases of their legs.
class Gait {
 public:
  /// @brief Adds the ways of the last tick. Called once after each tick.
  void observe(const World& world);
  /// @brief Length of the way since the first call of observe() [m].
  double walked(AgentId agent) const {
    const double* const walked = walked_.find(agent);
    return walked != nullptr ? *walked : 0.0;
  }

 private:
  AgentMap<double> walked_;
};

}  // namespace crowd
