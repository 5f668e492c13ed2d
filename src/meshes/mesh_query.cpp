#include <algorithm>
#include <limits>

#include "meshes/mesh_data.h"
#include "meshes/mesh_ray.h"
#include "meshes/path_search.h"

namespace crowd {

/// The searches on a mesh and their memory.
class NavigationMesh::Query::Search {
 public:
  /// A point on a polygon of the mesh.
  struct Place {
    std::size_t polygon = 0;
    Vector2 metres = Vector2::Zero();
  };

  explicit Search(std::shared_ptr<const Data> data) : data_(std::move(data)), path_search_(*data_) {}

  const Data& data() const { return *data_; }

  std::optional<Place> nearest(const Vector2& p, double within) const {
    if (!p.allFinite() || !(within >= 0.0)) return std::nullopt;
    const Vector2 point = data_->toCells(p);
    std::size_t polygon = 0;
    const auto is_on = [&](double tolerance) {
      return data_->grid().visitNear(point, tolerance, [&](std::size_t candidate) {
        polygon = candidate;
        return isOnPolygon(*data_, candidate, point, tolerance);
      });
    };
    if (is_on(0.0) || is_on(RAY_TOLERANCE)) return Place{polygon, p};
    return nearestOutside(p, point, within);
  }

  Component component(const Place& place) const { return data_->components()[place.polygon]; }

  bool findCorners(const Place& from, const Place& to, double max_length, std::vector<Vector2>& corners) {
    if (!path_search_.find(from.polygon, onPolygon(from), to.polygon, onPolygon(to), max_length / data_->cellSize(),
                           corners)) {
      return false;
    }
    for (Vector2& corner : corners) corner = data_->toMetres(corner);
    corners.back() = to.metres;
    return true;
  }

  bool isStraight(const Place& from, const Vector2& to) const {
    const Vector2 start = data_->toCells(from.metres);
    const Vector2 end = data_->toCells(to);
    double share = followRay(*data_, from.polygon, start, end);
    while (share < 1.0) {
      const double farther = followFrom(share, start, end);
      if (farther <= share) return false;
      share = farther;
    }
    return true;
  }

  /// Finds no ways through the polygons within a disc, until open().
  void close(const FloorPlan::Disc& disc) {
    const Vector2 centre = data_->toCells(disc.centre);
    const double radius = disc.radius / data_->cellSize();
    std::vector<std::size_t> closed;
    data_->grid().visitNear(centre, radius, [&](std::size_t polygon) {
      if (isOnPolygon(*data_, polygon, centre, radius)) closed.push_back(polygon);
      return false;
    });
    path_search_.close(std::move(closed));
  }
  void open() { path_search_.close({}); }

  std::size_t bytes() const { return sizeof(Search) + path_search_.bytes(); }

 private:
  /// The point of a place [cells], on its polygon also if it is beside it by up to RAY_TOLERANCE: from beside the rim,
  /// what lies along the rim is not visible.
  Vector2 onPolygon(const Place& place) const {
    const Vector2 point = data_->toCells(place.metres);
    return isOnPolygon(*data_, place.polygon, point, 0.0) ? point : nearestOnRim(*data_, place.polygon, point);
  }

  /// The place nearest to a point that is on no polygon. @param point the same [cells]
  std::optional<Place> nearestOutside(const Vector2& p, const Vector2& point, double within) const {
    Place place;
    double least = std::numeric_limits<double>::infinity();
    data_->grid().visitNear(point, within / data_->cellSize(), [&](std::size_t polygon) {
      const Vector2 nearest = nearestOnRim(*data_, polygon, point);
      const double distance = (nearest - point).norm();
      if (distance < least) place = {polygon, data_->toMetres(nearest)};
      least = std::min(least, distance);
      return false;
    });
    if (!((place.metres - p).norm() <= within) || least == std::numeric_limits<double>::infinity()) return std::nullopt;
    return place;
  }

  /// How far a line can be followed on all the polygons at one of its points.
  double followFrom(double share, const Vector2& start, const Vector2& end) const {
    const Vector2 point = start + share * (end - start);
    double farthest = share;
    data_->grid().visitNear(point, RAY_TOLERANCE, [&](std::size_t polygon) {
      if (isOnPolygon(*data_, polygon, point, RAY_TOLERANCE)) {
        farthest = std::max(farthest, followRay(*data_, polygon, start, end));
      }
      return false;
    });
    return farthest;
  }

  std::shared_ptr<const Data> data_;
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

std::optional<Path> NavigationMesh::Query::findPath(const Vector2& from, const Vector2& to, double max_length) {
  const auto start = search_->nearest(from, clearance());
  const auto goal = search_->nearest(to, clearance());
  if (!start || !goal || search_->component(*start) != search_->component(*goal)) return std::nullopt;
  Path path;
  if (!search_->findCorners(*start, *goal, max_length, path.corners)) return std::nullopt;
  if (start->metres != from) path.corners.insert(path.corners.begin(), start->metres);
  if (goal->metres != to) path.corners.push_back(to);
  Vector2 last = from;
  for (const Vector2& corner : path.corners) {
    path.length += (corner - last).norm();
    last = corner;
  }
  if (path.length > max_length) return std::nullopt;
  return path;
}

std::optional<Path> NavigationMesh::Query::findWayAround(const FloorPlan::Disc& disc, const Vector2& from,
                                                         const Vector2& to, double max_length) {
  search_->close(disc);
  std::optional<Path> path = findPath(from, to, max_length);
  search_->open();
  return path;
}

bool NavigationMesh::Query::isStraight(const Vector2& from, const Vector2& to) {
  const auto start = search_->nearest(from, clearance());
  if (!start) return false;
  if (search_->isStraight(*start, to)) return true;
  const auto end = search_->nearest(to, clearance());
  return end && end->metres != to && search_->isStraight(*start, end->metres);
}

double NavigationMesh::Query::clearance() const { return search_->data().clearance(); }
std::size_t NavigationMesh::Query::bytes() const { return search_->bytes(); }

}  // namespace crowd
