#pragma once

#include <cstddef>

#include "meshes/mesh_data.h"

namespace crowd {

/// Rays may leave the mesh by as much, so that they can run along its edges and through its corners [cells].
constexpr double RAY_TOLERANCE = 0.02;

/// Whether a point is on a polygon, or outside by at most a tolerance. [cells]
bool isOnPolygon(const NavigationMesh::Data& mesh, std::size_t polygon, const Vector2& point, double tolerance);

/// The point of a polygon's rim nearest to a point. [cells]
Vector2 nearestOnRim(const NavigationMesh::Data& mesh, std::size_t polygon, const Vector2& point);

/// The share of the straight line between two points [cells] at which it leaves the mesh; 1 if it does not.
///
/// Follows one row of polygons. At a corner where it leaves the mesh, the line may continue on other polygons.
/// @param polygon on which the part of the line starts that is followed
double followRay(const NavigationMesh::Data& mesh, std::size_t polygon, const Vector2& from, const Vector2& to);

}  // namespace crowd
