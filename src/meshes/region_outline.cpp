#include "meshes/region_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace crowd {
namespace {

/// Maximum distance of a corner from the edge that cuts it off [cells]. Steps of a straight wall are less than 1 deep.
constexpr double MAX_CUT = 1.0;
/// Number of corners that are tried after the last one that could follow.
constexpr std::size_t LOOKAHEAD = 16;

/// Twice the area of a triangle: positive if c lies to the left of the line from a to b.
std::int64_t turn(const Corner& a, const Corner& b, const Corner& c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

bool isBetween(const Corner& a, const Corner& b, const Corner& c) {
  return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y &&
         c.y <= std::max(a.y, b.y);
}

/// Whether two segments have a point in common.
bool meet(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const auto sign = [](std::int64_t number) { return (number > 0) - (number < 0); };
  const int c_side = sign(turn(a, b, c));
  const int d_side = sign(turn(a, b, d));
  const int a_side = sign(turn(c, d, a));
  const int b_side = sign(turn(c, d, b));
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && isBetween(a, b, c)) || (d_side == 0 && isBetween(a, b, d)) ||
         (a_side == 0 && isBetween(c, d, a)) || (b_side == 0 && isBetween(c, d, b));
}

/// Directions of travel, counterclockwise: east, north, west, south.
constexpr std::array<int, 4> DX{1, 0, -1, 0};
constexpr std::array<int, 4> DY{0, 1, 0, -1};
/// The cell to the left ahead of a corner, relative to it; the one to the right is that of the direction before.
constexpr std::array<int, 4> LEFT_COLUMN{0, -1, -1, 0};
constexpr std::array<int, 4> LEFT_ROW{0, 0, -1, -1};

/// The direction after a turn to the right.
std::size_t right(std::size_t direction) { return (direction + 3) % 4; }

}  // namespace

const std::vector<Corner>& RegionOutliner::outline(FloorRegions::Cell first) {
  trace(first);
  simplify();
  if (!isSimple()) {
    outline_.clear();
    for (const Step& step : steps_) outline_.push_back(step.corner);
  }
  return outline_;
}

void RegionOutliner::trace(FloorRegions::Cell first) {
  const FloorRegions::Label label = regions_.at(first.column, first.row);
  const auto left_of = [&](const Corner& at, std::size_t direction) {
    return regions_.at(at.x + LEFT_COLUMN[direction], at.y + LEFT_ROW[direction]);
  };
  const Corner start{first.column, first.row};
  steps_.clear();
  Corner at = start;
  std::size_t direction = 0;
  std::size_t last_direction = 3;
  FloorRegions::Label last_neighbour = FloorRegions::BLOCKED;
  do {
    // One edge of a cell, with the region to the left.
    const FloorRegions::Label neighbour = left_of(at, right(direction));
    if (direction != last_direction || neighbour != last_neighbour) steps_.push_back({at, last_neighbour, neighbour});
    last_direction = direction;
    last_neighbour = neighbour;
    at = {at.x + DX[direction], at.y + DY[direction]};
    if (left_of(at, direction) != label) {
      direction = (direction + 1) % 4;
    } else if (left_of(at, right(direction)) == label) {
      direction = right(direction);
    }
  } while (!(at == start && direction == 0));
  steps_.front().before = last_neighbour;
}

void RegionOutliner::simplify() {
  // Starts at a corner that is kept in any case.
  const auto shared = std::find_if(steps_.begin(), steps_.end(), [](const Step& step) { return step.isShared(); });
  if (shared != steps_.end()) std::rotate(steps_.begin(), shared, steps_.end());
  outline_.clear();
  for (std::size_t i = 0; i < steps_.size(); i = farthest(i)) outline_.push_back(steps_[i].corner);
}

/// Index of the last corner that can follow the given one: the corners between them are cut off.
std::size_t RegionOutliner::farthest(std::size_t from) const {
  std::size_t best = from + 1;
  if (steps_[from].behind != FloorRegions::BLOCKED) return best;
  const Corner& a = steps_[from].corner;
  for (std::size_t to = from + 2; to <= steps_.size() && !steps_[to - 1].isShared(); ++to) {
    const Corner& b = steps_[to % steps_.size()].corner;
    const double longest = MAX_CUT * std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    const bool cuts = std::all_of(steps_.begin() + static_cast<std::ptrdiff_t>(from) + 1,
                                  steps_.begin() + static_cast<std::ptrdiff_t>(to), [&](const Step& step) {
                                    const std::int64_t side = turn(a, b, step.corner);
                                    return side <= 0 && static_cast<double>(-side) <= longest;
                                  });
    if (cuts) best = to;
    if (to > best + LOOKAHEAD) break;
  }
  return best;
}

bool RegionOutliner::isSimple() const {
  const std::size_t count = outline_.size();
  if (count < 3) return false;
  const auto corner = [&](std::size_t i) -> const Corner& { return outline_[i % count]; };
  for (std::size_t i = 0; i < count; ++i) {
    // The next edge must not turn back, the others must not be touched.
    if (turn(corner(i), corner(i + 1), corner(i + 2)) == 0 && !isBetween(corner(i), corner(i + 2), corner(i + 1))) {
      return false;
    }
    for (std::size_t j = i + 2; j < count && j + 1 < i + count; ++j) {
      if (meet(corner(i), corner(i + 1), corner(j), corner(j + 1))) return false;
    }
  }
  return true;
}

}  // namespace crowd
