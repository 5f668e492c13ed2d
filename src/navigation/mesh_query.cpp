#include <recastnavigation/DetourNavMeshQuery.h>

#include <algorithm>
#include <array>
#include <new>

#include "navigation/mesh_data.h"
#include "navigation/mesh_ray.h"
#include "navigation/path_search.h"

namespace crowd {
namespace {

/// A point in Detour's coordinates.
struct DetourPoint {
  explicit DetourPoint(const Vector2& cells)
      : coordinates{static_cast<float>(cells.x()), 0.0F, static_cast<float>(cells.y())} {}
  DetourPoint() : DetourPoint(Vector2::Zero()) {}
  const float* data() const { return coordinates; }
  float* data() { return coordinates; }
  Vector2 cells() const { return {coordinates[0], coordinates[2]}; }
  float coordinates[3];
};

/// Differences of coordinates that are rounding [cells].
constexpr double ROUNDING = 0.02;

}  // namespace

/// Detour's search and its memory.
class NavigationMesh::Query::Search {
 public:
  /// A point on a polygon of the mesh.
  struct Place {
    dtPolyRef polygon = 0;
    DetourPoint point;
    Vector2 metres = Vector2::Zero();
  };

  explicit Search(std::shared_ptr<const Data> data) : data_(std::move(data)), path_search_(*data_) {
    constexpr int UNUSED_NODES = 4;  // of Detour's own search
    if (data_->detour() != nullptr && dtStatusFailed(detour_.init(data_->detour(), UNUSED_NODES))) {
      throw std::bad_alloc();
    }
  }

  const Data& data() const { return *data_; }

  std::optional<Place> nearest(const Vector2& p, double within) {
    if (data_->detour() == nullptr || !p.allFinite() || !(within >= 0.0)) return std::nullopt;
    const DetourPoint centre(data_->toCells(p));
    // Most points are on the mesh: only what is close to them is searched at first.
    Place place = nearestInSquare(centre, ROUNDING);
    if (isInside(place, centre)) {
      place.metres = p;
      return place;
    }
    place = nearestInSquare(centre, within / data_->cellSize() + ROUNDING);
    if (place.polygon == 0) return std::nullopt;
    place.metres = isInside(place, centre) ? p : data_->toMetres(place.point.cells());
    if ((place.metres - p).norm() > within) return std::nullopt;
    return place;
  }

  Component component(const Place& place) const { return data_->components()[index(place.polygon)]; }

  bool findCorners(const Place& from, const Place& to, std::vector<Vector2>& corners) {
    if (!path_search_.find(index(from.polygon), data_->toCells(from.metres), index(to.polygon),
                           data_->toCells(to.metres), corners)) {
      return false;
    }
    for (Vector2& corner : corners) corner = data_->toMetres(corner);
    corners.back() = to.metres;
    return true;
  }

  bool isStraight(const Place& from, const Place& to) const {
    const Vector2 start = data_->toCells(from.metres);
    const Vector2 end = data_->toCells(to.metres);
    double share = followRay(*data_, index(from.polygon), start, end);
    while (share < 1.0) {
      const double farther = followFrom(share, start, end);
      if (farther <= share) return false;
      share = farther;
    }
    return true;
  }

  std::size_t bytes() const { return sizeof(Search) + path_search_.bytes(); }

 private:
  /// The place nearest to a point among the polygons within a square around it; without a polygon if there are none.
  /// @param reach half of its side [cells]
  Place nearestInSquare(const DetourPoint& centre, double reach) const {
    const float extents[3] = {static_cast<float>(reach), 1.0F, static_cast<float>(reach)};
    Place place;
    detour_.findNearestPoly(centre.data(), extents, &filter_, &place.polygon, place.point.data());
    return place;
  }

  static bool isInside(const Place& place, const DetourPoint& point) {
    return place.polygon != 0 && (place.point.cells() - point.cells()).norm() <= ROUNDING;
  }

  /// How far a line can be followed on all the polygons at one of its points.
  double followFrom(double share, const Vector2& start, const Vector2& end) const {
    constexpr int MAX_POLYGONS = 16;
    std::array<dtPolyRef, MAX_POLYGONS> polygons{};
    int count = 0;
    const Vector2 point = start + share * (end - start);
    const float extents[3] = {static_cast<float>(RAY_TOLERANCE), 1.0F, static_cast<float>(RAY_TOLERANCE)};
    detour_.queryPolygons(DetourPoint(point).data(), extents, &filter_, polygons.data(), &count, MAX_POLYGONS);
    for (int i = 0; i < count; ++i) {
      const std::size_t polygon = index(polygons[static_cast<std::size_t>(i)]);
      if (isOnPolygon(*data_, polygon, point)) share = std::max(share, followRay(*data_, polygon, start, end));
    }
    return share;
  }

  std::size_t index(dtPolyRef polygon) const { return data_->detour()->decodePolyIdPoly(polygon); }

  std::shared_ptr<const Data> data_;
  dtNavMeshQuery detour_;
  dtQueryFilter filter_;
  PathSearch path_search_;
};

NavigationMesh::Query::Query(const NavigationMesh& mesh) : search_(std::make_unique<Search>(mesh.data_)) {}
NavigationMesh::Query::~Query() = default;
NavigationMesh::Query::Query(Query&&) noexcept = default;
NavigationMesh::Query& NavigationMesh::Query::operator=(Query&&) noexcept = default;

std::optional<Vector2> NavigationMesh::Query::nearestPoint(const Vector2& p, double within) {
  const auto place = search_->nearest(p, within);
  if (!place) return std::nullopt;
  return place->metres;
}

bool NavigationMesh::Query::contains(const Vector2& p) { return search_->nearest(p, 0.0).has_value(); }

std::optional<NavigationMesh::Component> NavigationMesh::Query::component(const Vector2& p) {
  const auto place = search_->nearest(p, clearance());
  if (!place) return std::nullopt;
  return search_->component(*place);
}

std::optional<Path> NavigationMesh::Query::findPath(const Vector2& from, const Vector2& to) {
  const auto start = search_->nearest(from, clearance());
  const auto goal = search_->nearest(to, clearance());
  if (!start || !goal || search_->component(*start) != search_->component(*goal)) return std::nullopt;
  Path path;
  if (!search_->findCorners(*start, *goal, path.corners)) return std::nullopt;
  if (start->metres != from) path.corners.insert(path.corners.begin(), start->metres);
  if (goal->metres != to) path.corners.push_back(to);
  Vector2 last = from;
  for (const Vector2& corner : path.corners) {
    path.length += (corner - last).norm();
    last = corner;
  }
  return path;
}

bool NavigationMesh::Query::isStraight(const Vector2& from, const Vector2& to) {
  const auto start = search_->nearest(from, 0.5 * clearance());
  const auto end = search_->nearest(to, 0.5 * clearance());
  return start && end && search_->isStraight(*start, *end);
}

double NavigationMesh::Query::clearance() const { return search_->data().clearance(); }
std::size_t NavigationMesh::Query::bytes() const { return search_->bytes(); }

}  // namespace crowd
