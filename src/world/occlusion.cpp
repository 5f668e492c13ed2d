#include "world/occlusion.h"

#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

/// Fractions of a chord or distance up to this value are attributed to rounding.
constexpr double HAIR = 1e-9;

}  // namespace

Occlusion::Screen Occlusion::screenOf(const Neighbour& neighbour) {
  const double distance_squared = neighbour.position.squaredNorm();
  const double tangent_squared = distance_squared - neighbour.radius * neighbour.radius;
  if (tangent_squared <= HAIR * distance_squared) return {};
  const Vector2 middle = (tangent_squared / distance_squared) * neighbour.position;
  const double half = neighbour.radius * std::sqrt(tangent_squared) / distance_squared;
  const Vector2 to_the_left(-half * neighbour.position.y(), half * neighbour.position.x());
  return {middle - to_the_left, middle + to_the_left, true};
}

Occlusion::Screen Occlusion::screenOf(const Segment& wall) {
  const double width = cross(wall.from, wall.to);
  if (std::abs(width) <= HAIR * wall.from.norm() * wall.to.norm()) return {};
  return width > 0.0 ? Screen{wall.from, wall.to, true} : Screen{wall.to, wall.from, true};
}

Neighbour Occlusion::spanned(const Neighbour& neighbour, const Screen& chord, const Part& part) {
  const Vector2 to_the_left = (chord.left - chord.right).normalized();
  Neighbour disc = neighbour;
  disc.position += (part.from + part.to - 1.0) * neighbour.radius * to_the_left;
  disc.radius *= part.to - part.from;
  return disc;
}

void Occlusion::addHiddenPart(const Screen& seen, const Screen& other) {
  if (!other.hides) return;
  // Find the directions that both cover. Both chords span less than half a turn, so there is at most one such range.
  Part part;
  if (seen.covers(other.right)) {
    part.from = seen.shareAt(other.right);
  } else if (!other.covers(seen.right)) {
    return;
  }
  if (seen.covers(other.left)) part.to = seen.shareAt(other.left);
  if (part.to - part.from <= HAIR) return;
  // Within that range the other is in front everywhere or, if the chords cross, at one end.
  const double front_right = other.inFrontOf(seen.at(part.from));
  const double front_left = other.inFrontOf(seen.at(part.to));
  if (front_right <= HAIR && front_left <= HAIR) return;
  const double crossing = part.from + (part.to - part.from) * front_right / (front_right - front_left);
  if (front_right <= HAIR) part.from = std::max(part.from, crossing);
  if (front_left <= HAIR) part.to = std::min(part.to, crossing);
  hidden_.push_back(part);
}

const std::vector<Occlusion::Part>& Occlusion::visibleParts(const Screen& seen, std::size_t own) {
  hidden_.clear();
  visible_.clear();
  for (std::size_t i = 0; i < screens_.size() && seen.hides; ++i) {
    if (i != own) addHiddenPart(seen, screens_[i]);
    if (!hidden_.empty() && hidden_.back().isAll()) return visible_;
  }
  std::sort(hidden_.begin(), hidden_.end(), [](const Part& a, const Part& b) { return a.from < b.from; });
  double seen_to = 0.0;
  for (const Part& part : hidden_) {
    if (part.from > seen_to + HAIR) visible_.push_back({seen_to, part.from});
    seen_to = std::max(seen_to, part.to);
  }
  if (seen_to < 1.0 - HAIR) visible_.push_back({seen_to, 1.0});
  return visible_;
}

void Occlusion::apply(std::vector<Neighbour>& neighbours, std::size_t first_neighbour, std::vector<Segment>& walls,
                      std::size_t first_wall, double radius) {
  screens_.clear();
  for (std::size_t i = first_wall; i < walls.size(); ++i) screens_.push_back(screenOf(walls[i]));
  const std::size_t wall_count = screens_.size();
  screenNeighbours(neighbours, first_neighbour);
  cutNeighbours(neighbours, first_neighbour, wall_count, radius);
  cutWalls(walls, first_wall, radius);
}

void Occlusion::screenNeighbours(std::vector<Neighbour>& neighbours, std::size_t first) {
  std::size_t kept = first;
  for (std::size_t i = first; i < neighbours.size(); ++i) {
    const Screen screen = screenOf(neighbours[i]);
    if (visibleParts(screen, screens_.size()).empty()) continue;
    screens_.push_back(screen);
    neighbours[kept++] = neighbours[i];
  }
  neighbours.resize(kept);
}

void Occlusion::cutNeighbours(std::vector<Neighbour>& neighbours, std::size_t first, std::size_t first_screen,
                              double radius) {
  // From the back: the visible part of a body is never nearer than the body, so that it is only inserted among bodies
  // that are already sorted.
  std::size_t kept = neighbours.size();
  for (std::size_t i = neighbours.size(); i-- > first;) {
    const std::size_t own = first_screen + i - first;
    if (visibleParts(screens_[own], own).empty()) continue;
    const Part hull = {visible_.front().from, visible_.back().to};
    if (hull.isAll()) {
      neighbours[--kept] = neighbours[i];
      continue;
    }
    const Neighbour seen = spanned(neighbours[i], screens_[own], hull);
    const double rim = rimDistance(seen);
    if (rim > radius) continue;
    std::size_t next = kept--;
    for (; next < neighbours.size() && rimDistance(neighbours[next]) < rim; ++next)
      neighbours[next - 1] = neighbours[next];
    neighbours[next - 1] = seen;
  }
  const auto begin = neighbours.begin();
  neighbours.erase(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(kept));
}

void Occlusion::cutWalls(std::vector<Segment>& walls, std::size_t first, double radius) {
  cut_.clear();
  for (std::size_t i = first; i < walls.size(); ++i) {
    const Screen& screen = screens_[i - first];
    visibleParts(screen, i - first);
    if (hidden_.empty()) {
      cut_.push_back(walls[i]);
      continue;
    }
    const bool runs_left = screen.right == walls[i].from;
    for (const Part& part : visible_) {
      const Segment seen = {screen.at(runs_left ? part.from : part.to), screen.at(runs_left ? part.to : part.from)};
      if (distanceTo(seen, Vector2::Zero()) <= radius) cut_.push_back(seen);
    }
  }
  walls.resize(first);
  walls.insert(walls.end(), cut_.begin(), cut_.end());
}

}  // namespace crowd
