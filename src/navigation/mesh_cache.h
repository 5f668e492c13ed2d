#pragma once

#include <memory>

#include "meshes/navigation_mesh.h"
#include "navigation/floor_ruler.h"

namespace crowd {

/// @brief The meshes of a floor for agents of one size.
struct NavigationData {
  NavigationMesh comfortable;  ///< keeps a margin from walls
  NavigationMesh tight;        ///< for passages that are too narrow for that
};

/// @brief Margin between agents and walls on their way where there is room [m].
constexpr double COMFORTABLE_MARGIN = 0.1;
/// @brief The same in narrow passages [m].
constexpr double TIGHT_MARGIN = 0.02;

/// @brief The meshes of a floor. The last few are kept, since episodes of one scenario share their floor and gates
/// alternate between two. Thread-safe.
/// @param radius of the agents [m]
/// @throws InputError and Stopped as NavigationMesh
std::shared_ptr<const NavigationData> navigationData(const FloorPlan& floor, double radius,
                                                     const StopRequest& stop = {});

/// @brief The ruler of a floor for agents up to a radius, which finds narrow places. Kept as meshes are. Thread-safe.
/// @throws Stopped if `stop` is made
std::shared_ptr<const FloorRuler> floorRuler(const FloorPlan& floor, double radius, const StopRequest& stop = {});

}  // namespace crowd
