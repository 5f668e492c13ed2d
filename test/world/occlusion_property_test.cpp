#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "support/look_everywhere.h"
#include "support/sceneries.h"
#include "world/occlusion.h"

namespace crowd::occlusion_property_test {
namespace {

using sceneries::find;
using sceneries::look;
using sceneries::lookEverywhere;
using sceneries::numberOf;
using sceneries::randomScenery;
using sceneries::Range;
using sceneries::Scenery;
using sceneries::Seen;

/// Half of the angle that a body spans [rad].
double halfWidth(const Neighbour& neighbour) { return std::asin(neighbour.radius / neighbour.position.norm()); }

/// Calls check(scenery, its visible parts) for a number of sceneries without overlaps.
template <typename Check>
void checkSceneries(std::uint64_t count, const Check& check) {
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scenery scenery = randomScenery(seed, true);
    check(scenery, look(scenery));
  }
}

TEST(OcclusionProperty, AgreesWithLinesOfSightInAllDirections) {
  std::size_t hidden = 0;
  std::size_t in_sight = 0;
  double hidden_length = 0.0;
  checkSceneries(500, [&](const Scenery& scenery, const Scenery& seen) {
    const Seen expected = lookEverywhere(scenery);
    for (std::size_t i = 0; i < scenery.neighbours.size(); ++i) {
      EXPECT_EQ(find(seen, i) == nullptr, expected.neighbours[i].empty()) << "body " << i;
      ++(expected.neighbours[i].empty() ? hidden : in_sight);
    }
    double length = 0.0;
    for (const Segment& wall : seen.walls) length += (wall.to - wall.from).norm();
    EXPECT_NEAR(length, expected.wall_length, 1e-4);
    for (const Segment& wall : scenery.walls) hidden_length += (wall.to - wall.from).norm();
    hidden_length -= length;
  });
  EXPECT_GT(hidden, 500U);
  EXPECT_GT(in_sight, 500U);
  EXPECT_GT(hidden_length, 500.0);
}

TEST(OcclusionProperty, DiscsSpanTheVisibleParts) {
  std::size_t whole = 0;
  std::size_t cut = 0;
  checkSceneries(500, [&](const Scenery& scenery, const Scenery& seen) {
    const Seen expected = lookEverywhere(scenery);
    for (const Neighbour& disc : seen.neighbours) {
      const Neighbour& neighbour = scenery.neighbours[numberOf(disc)];
      const std::vector<Range>& ranges = expected.neighbours[numberOf(disc)];
      ASSERT_FALSE(ranges.empty());
      // Where a line of sight meets the chord, from -1 at the right end to 1 at the left end.
      const double slope = std::tan(halfWidth(neighbour));
      const double right = std::tan(ranges.front().from) / slope;
      const double left = std::tan(ranges.back().to) / slope;
      const Vector2 to_the_left = Vector2(-neighbour.position.y(), neighbour.position.x()).normalized();
      EXPECT_NEAR(disc.radius, 0.5 * (left - right) * neighbour.radius, 1e-5);
      EXPECT_LT((disc.position - neighbour.position - 0.5 * (left + right) * neighbour.radius * to_the_left).norm(),
                1e-5);
      EXPECT_EQ(disc.velocity, neighbour.velocity);
      if (right > -1.0 + 1e-5 || left < 1.0 - 1e-5) {
        EXPECT_LT(disc.radius, neighbour.radius);
        ++cut;
      } else if (right < -1.0 + 1e-9 && left > 1.0 - 1e-9) {
        EXPECT_EQ(disc.position, neighbour.position);
        EXPECT_EQ(disc.radius, neighbour.radius);
        ++whole;
      }
    }
  });
  EXPECT_GT(cut, 500U);
  EXPECT_GT(whole, 500U);
}

TEST(OcclusionProperty, DiscsCoverTheBearingsOfTheVisibleParts) {
  // Fractions refer to the chord through the tangent points, but the disc is around the body's centre. The end of the
  // chord has the bearing asin(R/d), the end of the diameter atan(R/d): about (R/d)^3 / 2 less. For R/d up to 0.6 no
  // other fraction has a larger difference; for R/d = 0.2 it is 0.23 degrees.
  std::size_t looked_at = 0;
  checkSceneries(500, [&](const Scenery& scenery, const Scenery& seen) {
    const Seen expected = lookEverywhere(scenery);
    for (const Neighbour& disc : seen.neighbours) {
      const Neighbour& neighbour = scenery.neighbours[numberOf(disc)];
      const double ratio = neighbour.radius / neighbour.position.norm();
      if (ratio > 0.6) continue;
      const double most = std::asin(ratio) - std::atan(ratio) + 1e-6;
      const double middle = wrapAngle(bearingOf(disc.position) - bearingOf(neighbour.position));
      EXPECT_NEAR(middle - halfWidth(disc), expected.neighbours[numberOf(disc)].front().from, most);
      EXPECT_NEAR(middle + halfWidth(disc), expected.neighbours[numberOf(disc)].back().to, most);
      ++looked_at;
    }
  });
  EXPECT_GT(looked_at, 1000U);
}

TEST(OcclusionProperty, DiscsLieWithinTheBodiesInOrderOfTheirRims) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const double radius = seed % 3 == 0 ? 4.0 : sceneries::FAR;
    Scenery scenery = randomScenery(seed, seed % 2 == 0);
    const auto beyond = [&](const Neighbour& neighbour) { return rimDistance(neighbour) > radius; };
    scenery.neighbours.erase(std::find_if(scenery.neighbours.begin(), scenery.neighbours.end(), beyond),
                             scenery.neighbours.end());
    const Scenery seen = look(scenery, radius);
    double last = -sceneries::FAR;
    for (const Neighbour& disc : seen.neighbours) {
      const Neighbour& neighbour = scenery.neighbours[numberOf(disc)];
      EXPECT_GT(disc.radius, 0.0);
      EXPECT_LE((disc.position - neighbour.position).norm() + disc.radius, neighbour.radius + 1e-12);
      EXPECT_LE(last, rimDistance(disc));
      EXPECT_LE(rimDistance(disc), radius);
      last = rimDistance(disc);
    }
  }
}

/// The visible parts for one position of the moving body.
struct Look {
  Scenery seen;
  Seen ranges;

  explicit Look(Scenery scenery) : ranges(lookEverywhere(scenery)) {
    sceneries::sortByRim(scenery);
    seen = look(scenery);
  }
};

/// Numbers of comparisons by kind.
struct Count {
  std::size_t compared = 0;
  std::size_t come_and_gone = 0;
  std::size_t glimpses = 0;
};

void expectChangesBelow(double most, std::size_t number, const Look& before, const Look& now, Count& count) {
  const Neighbour* const then = find(before.seen, number);
  const Neighbour* const disc = find(now.seen, number);
  ++count.compared;
  if (then != nullptr && disc != nullptr) {
    // The disc spans all visible parts of a body, so it may jump when the number of parts changes.
    if (before.ranges.neighbours[number].size() != now.ranges.neighbours[number].size()) {
      ++count.glimpses;
      return;
    }
    EXPECT_LT((disc->position - then->position).norm(), most) << "body " << number;
    EXPECT_NEAR(disc->radius, then->radius, most) << "body " << number;
  } else if (then != nullptr || disc != nullptr) {
    EXPECT_LT((then == nullptr ? disc : then)->radius, most) << "body " << number;
    ++count.come_and_gone;
  }
}

TEST(OcclusionProperty, SmallMotionsOfBodiesChangeDiscsOnlySlightly) {
  // A line of sight that touches a body 1 m or more away turns by no more than the body moves. On a disc within 9.5 m
  // it moves by at most 9.5 / cos(asin(0.5)) = 11 times as much, and the disc moves with its body.
  constexpr double STEP = 2e-3;
  constexpr double MOST = 12.0 * STEP;
  Count count;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scenery scenery = randomScenery(seed, true, 1.0);
    if (scenery.neighbours.empty()) continue;
    Neighbour& moving_obstacle = scenery.neighbours[seed % scenery.neighbours.size()];
    std::optional<Look> before;
    for (int tick = 0; tick < 1000; ++tick) {
      SCOPED_TRACE("tick " + std::to_string(tick));
      moving_obstacle.position += STEP * unitVector(static_cast<double>(seed));
      const bool in_the_way = rimDistance(moving_obstacle) < 1.0 ||
                              sceneries::overlapsAny(moving_obstacle, scenery, numberOf(moving_obstacle));
      if (in_the_way || moving_obstacle.position.norm() > 9.5) {
        before.reset();
        continue;
      }
      const Look now(scenery);
      for (std::size_t i = 0; before && i < scenery.neighbours.size(); ++i) {
        expectChangesBelow(MOST, i, *before, now, count);
      }
      before = now;
    }
  }
  EXPECT_GT(count.compared, 1000000U);
  EXPECT_GT(count.come_and_gone, 50U);
  EXPECT_LT(count.glimpses, count.come_and_gone);
}

TEST(OcclusionProperty, RemovingABodyOrWallHidesNoOther) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scenery scenery = randomScenery(seed, seed % 2 == 0);
    const Scenery seen = look(scenery);
    for (std::size_t i = 0; i < scenery.neighbours.size() + scenery.walls.size(); ++i) {
      Scenery less = scenery;
      if (i < less.neighbours.size()) {
        less.neighbours.erase(less.neighbours.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        less.walls.erase(less.walls.begin() + static_cast<std::ptrdiff_t>(i - less.neighbours.size()));
      }
      const Scenery seen_then = look(less);
      for (const Neighbour& neighbour : seen.neighbours) {
        if (numberOf(neighbour) == i) continue;
        const Neighbour* const then = find(seen_then, numberOf(neighbour));
        ASSERT_NE(then, nullptr) << "without " << i;
        EXPECT_GE(then->radius, neighbour.radius - 1e-8) << "without " << i;
      }
    }
  }
}

TEST(OcclusionProperty, NearestBodyIsAlwaysVisible) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scenery scenery = randomScenery(seed, true);
    scenery.walls.clear();
    if (scenery.neighbours.empty()) continue;
    EXPECT_NE(find(look(scenery), 0), nullptr);
  }
}

TEST(OcclusionProperty, HiddenBodiesHideNothing) {
  std::size_t hidden = 0;
  checkSceneries(200, [&](const Scenery& scenery, const Scenery& seen) {
    Scenery less = scenery;
    less.neighbours.erase(
        std::remove_if(less.neighbours.begin(), less.neighbours.end(),
                       [&](const Neighbour& neighbour) { return find(seen, numberOf(neighbour)) == nullptr; }),
        less.neighbours.end());
    hidden += scenery.neighbours.size() - less.neighbours.size();
    const Scenery seen_then = look(less);
    ASSERT_EQ(seen_then.neighbours.size(), seen.neighbours.size());
    for (std::size_t i = 0; i < seen.neighbours.size(); ++i) {
      EXPECT_EQ(numberOf(seen_then.neighbours[i]), numberOf(seen.neighbours[i]));
      EXPECT_LT((seen_then.neighbours[i].position - seen.neighbours[i].position).norm(), 1e-8);
      EXPECT_NEAR(seen_then.neighbours[i].radius, seen.neighbours[i].radius, 1e-8);
    }
  });
  EXPECT_GT(hidden, 500U);
}

}  // namespace
}  // namespace crowd::occlusion_property_test
