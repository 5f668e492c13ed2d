#include "navigation/passages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace crowd {
namespace {

using Index = ClearanceGrid::Index;

/// Returns the connected component of a grid point among those that belong(point), and takes its points out of it.
template <typename Belongs, typename Take>
std::vector<Index> takeComponent(const ClearanceGrid& grid, Index seed, const Belongs& belongs, const Take& take) {
  std::vector<Index> component{seed};
  take(seed);
  for (std::size_t i = 0; i < component.size(); ++i) {
    grid.forNeighbours(component[i], [&](Index neighbour) {
      if (!belongs(neighbour)) return;
      take(neighbour);
      component.push_back(neighbour);
    });
  }
  return component;
}

/// Splits grid points into connected components.
std::vector<std::vector<Index>> componentsOf(const ClearanceGrid& grid, std::vector<Index> points) {
  std::unordered_set<Index> left(points.begin(), points.end());
  std::sort(points.begin(), points.end());  // so that the order of the components depends on the points only
  std::vector<std::vector<Index>> components;
  for (const Index point : points) {
    if (left.count(point) == 0) continue;
    components.push_back(takeComponent(
        grid, point, [&](Index at) { return left.count(at) > 0; }, [&](Index at) { left.erase(at); }));
  }
  return components;
}

Vector2 meanOf(const ClearanceGrid& grid, const std::vector<Index>& points) {
  Vector2 sum = Vector2::Zero();
  for (const Index point : points) sum += grid.place(point);
  return sum / static_cast<double>(points.size());
}

}  // namespace

Passages::Passages(const FloorPlan& floor, double radius, double max_width, const StopRequest& stop)
    : clearance_(floor, SPACING, 0.5 * max_width + SPACING, stop), labels_(clearance_.size(), NONE) {
  const std::vector<Width> widths = classify(radius, max_width, stop);
  std::vector<bool> seen(clearance_.size(), false);
  for (Index point = 0; point < clearance_.size(); ++point) {
    if (widths[point] != Width::NARROW || seen[point]) continue;
    stop.throwIfMade();
    const auto belongs = [&](Index at) { return widths[at] == Width::NARROW && !seen[at]; };
    addPassage(takeComponent(clearance_, point, belongs, [&](Index at) { seen[at] = true; }), widths);
  }
  measureSteps();
}

/// Two passes over the blocks, forwards and backwards.
void Passages::measureSteps() {
  constexpr int MOST = 255;
  if (passages_.empty()) return;
  block_side_ = BLOCK * clearance_.spacing();
  block_origin_ = clearance_.place(0) - Vector2::Constant(0.5 * clearance_.spacing());
  block_columns_ = clearance_.columns() / BLOCK + 1;
  block_rows_ = clearance_.rows() / BLOCK + 1;
  const auto columns = static_cast<std::int64_t>(block_columns_);
  const auto rows = static_cast<std::int64_t>(block_rows_);
  steps_.assign(static_cast<std::size_t>(columns * rows), MOST);
  for (Index point = 0; point < clearance_.size(); ++point) {
    if (labels_[point] == NONE) continue;
    steps_[point / clearance_.columns() / BLOCK * block_columns_ + point % clearance_.columns() / BLOCK] = 0;
  }
  const auto pass = [&](std::int64_t row, std::int64_t column, std::int64_t before) {
    std::uint8_t& steps = steps_[static_cast<std::size_t>(row * columns + column)];
    const auto look = [&](std::int64_t r, std::int64_t c) {
      if (r < 0 || c < 0 || r >= rows || c >= columns) return;
      steps = static_cast<std::uint8_t>(std::min<int>(steps, steps_[static_cast<std::size_t>(r * columns + c)] + 1));
    };
    look(row, column + before);
    for (std::int64_t aside = -1; aside <= 1; ++aside) look(row + before, column + aside);
  };
  for (std::int64_t row = 0; row < rows; ++row) {
    for (std::int64_t column = 0; column < columns; ++column) pass(row, column, -1);
  }
  for (std::int64_t row = rows - 1; row >= 0; --row) {
    for (std::int64_t column = columns - 1; column >= 0; --column) pass(row, column, 1);
  }
}

std::vector<Passages::Width> Passages::classify(double radius, double max_width, const StopRequest& stop) const {
  std::vector<Width> widths(clearance_.size(), Width::BLOCKED);
  for (Index point = 0; point < clearance_.size(); ++point) {
    if (clearance_[point] >= radius) widths[point] = Width::WIDE;
  }
  for (Index point = 0; point < clearance_.size(); ++point) {
    if (clearance_[point] < radius || clearance_[point] >= 0.5 * max_width || !isThroat(point)) continue;
    stop.throwIfMade();
    clearance_.forPointsWithin(clearance_[point], point, [&](Index at) {
      if (widths[at] == Width::WIDE) widths[at] = Width::NARROW;
    });
  }
  return widths;
}

/// Whether the clearance falls towards two sides and does not fall in the two directions between them: a saddle of the
/// clearance, as in a door, or a level ridge, as in a corridor.
bool Passages::isThroat(Index point) const {
  constexpr std::array<std::array<int, 2>, 16> CIRCLE{{{3, 0},
                                                       {3, 1},
                                                       {2, 2},
                                                       {1, 3},
                                                       {0, 3},
                                                       {-1, 3},
                                                       {-2, 2},
                                                       {-3, 1},
                                                       {-3, 0},
                                                       {-3, -1},
                                                       {-2, -2},
                                                       {-1, -3},
                                                       {0, -3},
                                                       {1, -3},
                                                       {2, -2},
                                                       {3, -1}}};
  constexpr double LEVEL = 0.01;  // [m]
  int changes = 0;
  const auto falls_at = [&](const std::array<int, 2>& offset) {
    const Index at = clearance_.offset(point, offset[0], offset[1]);
    return at != ClearanceGrid::OUTSIDE && clearance_[at] < clearance_[point] - LEVEL;
  };
  bool before = falls_at(CIRCLE.back());
  for (const std::array<int, 2>& offset : CIRCLE) {
    const bool falls = falls_at(offset);
    changes += falls != before ? 1 : 0;
    before = falls;
  }
  return changes >= 4;
}

void Passages::addPassage(const std::vector<Index>& narrow, const std::vector<Width>& widths) {
  std::vector<Index> rim;  // wide points beside the passage
  for (const Index point : narrow) {
    clearance_.forNeighbours(point, [&](Index at) {
      if (widths[at] == Width::WIDE) rim.push_back(at);
    });
  }
  const std::vector<std::vector<Index>> mouths = componentsOf(clearance_, std::move(rim));
  if (mouths.size() < 2 || passages_.size() == NONE) return;
  Passage passage;
  for (const std::vector<Index>& mouth : mouths) passage.mouths.push_back(mouthAt(mouth, narrow));
  passage.width = widthBetween(mouths, narrow);
  for (const Index point : narrow) labels_[point] = static_cast<std::uint16_t>(passages_.size());
  passages_.push_back(std::move(passage));
}

/// Returns the width of the narrowest point on the widest way from any mouth to another [m]. Joins the points of the
/// passage to the mouths, the widest points first, until two mouths are joined.
double Passages::widthBetween(const std::vector<std::vector<Index>>& mouths, std::vector<Index> narrow) const {
  std::unordered_map<Index, std::size_t> group_of;  // of the points joined so far
  std::vector<std::size_t> parents(mouths.size());
  std::iota(parents.begin(), parents.end(), 0);
  const auto root_of = [&](std::size_t group) {
    while (parents[group] != group) group = parents[group];
    return group;
  };
  for (std::size_t mouth = 0; mouth < mouths.size(); ++mouth) {
    for (const Index point : mouths[mouth]) group_of[point] = mouth;
  }
  std::stable_sort(narrow.begin(), narrow.end(), [&](Index a, Index b) { return clearance_[a] > clearance_[b]; });
  for (const Index point : narrow) {
    std::size_t group = parents.size();
    parents.push_back(group);
    group_of[point] = group;
    bool joins_mouths = false;
    clearance_.forNeighbours(point, [&](Index at) {
      const auto found = group_of.find(at);
      if (found == group_of.end()) return;
      const std::size_t other = root_of(found->second);
      if (other == group) return;
      // Groups that contain a mouth have its number, the lowest in them.
      joins_mouths = joins_mouths || (other < mouths.size() && group < mouths.size());
      parents[std::max(other, group)] = std::min(other, group);
      group = std::min(other, group);
    });
    if (joins_mouths) return 2.0 * clearance_[point];
  }
  return 0.0;
}

Mouth Passages::mouthAt(const std::vector<Index>& rim, const std::vector<Index>& narrow) const {
  constexpr double NEAR = 0.5;  // [m]; the passage may bend further inside
  Mouth mouth;
  mouth.centre = meanOf(clearance_, rim);
  std::vector<Index> near;
  for (const Index point : narrow) {
    if ((clearance_.place(point) - mouth.centre).norm() < NEAR) near.push_back(point);
  }
  const Vector2 outward = mouth.centre - meanOf(clearance_, near.empty() ? narrow : near);
  if (outward.norm() > 0.0) mouth.outward = outward.normalized();
  return mouth;
}

}  // namespace crowd
