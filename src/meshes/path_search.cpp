#include "meshes/path_search.h"

#include <algorithm>
#include <limits>

namespace crowd {
namespace {

/// Distances below this are rounding [cells].
constexpr double PATH_ROUNDING = 1e-6;

/// Distance of a point to the left of a line.
double leftOf(const Vector2& from, const Vector2& through, const Vector2& point) {
  const Vector2 way = through - from;
  return cross(way, point - from) / way.norm();
}

}  // namespace

PathSearch::PathSearch(const NavigationMesh::Data& mesh)
    : mesh_(mesh), best_(mesh.isTurningPoint().size(), std::numeric_limits<double>::infinity()) {}

bool PathSearch::find(std::size_t from_polygon, const Vector2& from, std::size_t to_polygon, const Vector2& to,
                      double max_length, std::vector<Vector2>& corners) {
  goal_polygon_ = to_polygon;
  goal_ = to;
  max_length_ = max_length;
  begin(from_polygon, from);
  Node node;
  do {
    if (open_.empty()) return false;
    std::pop_heap(open_.begin(), open_.end(), IsWorse());
    node = open_.back();
    open_.pop_back();
    if (node.polygon != NONE && !isOutdated(roots_[node.root])) expand(node);
  } while (node.polygon != NONE);
  corners.assign(1, to);
  for (Index root = node.root; root != 0; root = roots_[root].parent) corners.push_back(roots_[root].position);
  std::reverse(corners.begin(), corners.end());
  return true;
}

void PathSearch::begin(std::size_t polygon, const Vector2& from) {
  for (const Index vertex : touched_) best_[vertex] = std::numeric_limits<double>::infinity();
  touched_.clear();
  open_.clear();
  number_ = 0;
  roots_.assign(1, Root{from, 0.0, NONE, NONE});
  if (polygon == goal_polygon_) {
    addGoal(0);
    return;
  }
  const dtPoly& shape = mesh_.tile().polys[polygon];
  for (Index edge = 0; edge < shape.vertCount; ++edge) {
    addInterval(0, static_cast<Index>(polygon), edge, point(shape.verts[(edge + 1) % shape.vertCount]),
                point(shape.verts[edge]));
  }
}

void PathSearch::expand(const Node& node) {
  const Vector2 root = roots_[node.root].position;
  const Vector2 way = node.left.position - node.right.position;
  const double width = way.norm();
  if (cross(way, root - node.right.position) > PATH_ROUNDING * width) {
    expandVisible(node);
    return;
  }
  // The root is on the line through the interval, not before it. From a point of the interval, the whole polygon is
  // visible.
  const double along = way.dot(root - node.right.position) / width;
  Index turned = node.root;
  if (along < -PATH_ROUNDING) turned = turnAt(node.right, node.root);
  if (along > width + PATH_ROUNDING) turned = turnAt(node.left, node.root);
  if (turned == NONE) return;
  if (node.polygon == goal_polygon_) {
    addGoal(turned);
    return;
  }
  setChain(node.polygon, node.edge);
  addSides(turned, node.polygon, chainBegin(), chainEnd());
}

void PathSearch::expandVisible(const Node& node) {
  if (node.polygon == goal_polygon_) {
    reachGoal(node);
    return;
  }
  setChain(node.polygon, node.edge);
  const Vector2 root = roots_[node.root].position;
  const Cut first = firstCut(root, node.right.position);
  const Cut last = lastCut(root, node.left.position);
  addSides(node.root, node.polygon, first, last);
  const Index at_right = turnAt(node.right, node.root);
  if (at_right != NONE) addSides(at_right, node.polygon, chainBegin(), first);
  const Index at_left = turnAt(node.left, node.root);
  if (at_left != NONE) addSides(at_left, node.polygon, last, chainEnd());
}

void PathSearch::reachGoal(const Node& node) {
  const Vector2 root = roots_[node.root].position;
  Index last = node.root;
  if (leftOf(root, node.right.position, goal_) < -PATH_ROUNDING) {
    last = turnAt(node.right, node.root);
  } else if (leftOf(root, node.left.position, goal_) > PATH_ROUNDING) {
    last = turnAt(node.left, node.root);
  }
  if (last != NONE) addGoal(last);
}

void PathSearch::setChain(Index polygon, Index entry_edge) {
  const dtPoly& shape = mesh_.tile().polys[polygon];
  chain_.clear();
  sides_.clear();
  // Polygons are clockwise, so the right end of the entry is the start of its edge.
  for (Index i = 0; i < shape.vertCount; ++i) {
    const Index number = (entry_edge + shape.vertCount - i) % shape.vertCount;
    chain_.push_back(point(shape.verts[number]));
    if (i > 0) sides_.push_back(number);
  }
}

PathSearch::Cut PathSearch::firstCut(const Vector2& root, const Vector2& through) const {
  std::size_t last = 0;
  double distance = leftOf(root, through, chain_[0].position);
  double next = distance;
  for (std::size_t i = 1; i < chain_.size(); ++i) {
    next = leftOf(root, through, chain_[i].position);
    if (next > PATH_ROUNDING) break;
    last = i;
    distance = next;
  }
  if (last + 1 == chain_.size() || distance >= -PATH_ROUNDING) return {last, chain_[last]};
  const double share = distance / (distance - next);
  return {last, {chain_[last].position + share * (chain_[last + 1].position - chain_[last].position), NONE}};
}

PathSearch::Cut PathSearch::lastCut(const Vector2& root, const Vector2& through) const {
  std::size_t first = chain_.size() - 1;
  double distance = leftOf(root, through, chain_[first].position);
  double next = distance;
  for (std::size_t i = first; i-- > 0;) {
    next = leftOf(root, through, chain_[i].position);
    if (next < -PATH_ROUNDING) break;
    first = i;
    distance = next;
  }
  if (first == 0 || distance <= PATH_ROUNDING) return {first, chain_[first]};
  const double share = distance / (distance - next);
  return {first - 1, {chain_[first].position + share * (chain_[first - 1].position - chain_[first].position), NONE}};
}

void PathSearch::addSides(Index root, Index polygon, const Cut& first, const Cut& last) {
  for (std::size_t side = first.side; side <= last.side && side < sides_.size(); ++side) {
    const Point& right = side == first.side ? first.point : chain_[side];
    const Point& left = side == last.side ? last.point : chain_[side + 1];
    addInterval(root, polygon, sides_[side], right, left);
  }
}

void PathSearch::addInterval(Index root, Index polygon, Index edge, const Point& right, const Point& left) {
  const dtMeshTile& tile = mesh_.tile();
  if (tile.polys[polygon].neis[edge] == 0 || !mesh_.exits().doesLead(polygon, edge, goal_polygon_)) return;
  if ((left.position - right.position).squaredNorm() < PATH_ROUNDING * PATH_ROUNDING) return;
  const Index behind = tile.polys[polygon].neis[edge] - Index{1};
  const bool is_closed = std::find(closed_.begin(), closed_.end(), behind) != closed_.end();
  if (is_closed && behind != goal_polygon_) return;
  const dtPoly& shape = tile.polys[behind];
  Index entry = 0;
  while (shape.neis[entry] != polygon + 1) ++entry;
  add({roots_[root].length + estimate(roots_[root].position, right, left), 0, root, behind, entry, right, left});
}

void PathSearch::addGoal(Index root) {
  add({roots_[root].length + (goal_ - roots_[root].position).norm(), 0, root, NONE, 0, {}, {}});
}

void PathSearch::add(Node node) {
  if (node.estimate > max_length_) return;
  node.number = number_++;
  open_.push_back(node);
  std::push_heap(open_.begin(), open_.end(), IsWorse());
}

bool PathSearch::isOutdated(const Root& root) const {
  return root.vertex != NONE && root.length > best_[root.vertex] + PATH_ROUNDING;
}

PathSearch::Index PathSearch::turnAt(const Point& corner, Index root) {
  if (corner.vertex == NONE || mesh_.isTurningPoint()[corner.vertex] == 0) return NONE;
  const double length = roots_[root].length + (corner.position - roots_[root].position).norm();
  double& best = best_[corner.vertex];
  if (length > best + PATH_ROUNDING) return NONE;
  if (best == std::numeric_limits<double>::infinity()) touched_.push_back(corner.vertex);
  best = std::min(best, length);
  roots_.push_back({corner.position, length, root, corner.vertex});
  return static_cast<Index>(roots_.size() - 1);
}

double PathSearch::estimate(const Vector2& root, const Point& right, const Point& left) const {
  const Vector2 way = left.position - right.position;
  const double goal_side = cross(way, goal_ - right.position);
  const double root_side = cross(way, root - right.position);
  Vector2 goal = goal_;
  if (goal_side * root_side > 0.0) {
    // On the same side as the root: its mirror image behind the interval is as far.
    goal -= 2.0 * goal_side / way.squaredNorm() * Vector2(-way.y(), way.x());
  }
  const Vector2 to_goal = goal - root;
  if (cross(to_goal, right.position - root) > 0.0) {
    return (right.position - root).norm() + (goal - right.position).norm();
  }
  if (cross(to_goal, left.position - root) < 0.0) {
    return (left.position - root).norm() + (goal - left.position).norm();
  }
  return to_goal.norm();
}

PathSearch::Point PathSearch::point(Index vertex) const {
  const float* coordinates = mesh_.tile().verts + std::size_t{3} * vertex;
  return {{coordinates[0], coordinates[2]}, vertex};
}

std::size_t PathSearch::bytes() const {
  return sizeof(*this) + roots_.capacity() * sizeof(Root) + open_.capacity() * sizeof(Node) +
         best_.capacity() * sizeof(double) + touched_.capacity() * sizeof(Index);
}

}  // namespace crowd
