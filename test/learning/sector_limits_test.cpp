#include "social_crowd/learning/sector_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "social_crowd/common/random.h"

namespace crowd {
namespace {

/// The sectors that some angle between the two tangents lies in, found by walking from the one to the other.
SectorSet sectorsBetweenTangents(const EvenSectors& sectors, const Vector2& centre, double radius) {
  constexpr int STEPS = 1000;
  const double half_span = std::asin(radius / centre.norm());
  SectorSet reached = 0;
  for (int i = -STEPS; i <= STEPS; ++i) {
    reached |= 1U << static_cast<unsigned>(sectors.indexOf(bearingOf(centre) + half_span * i / STEPS));
  }
  return reached;
}

/// Calls check(sectors, limits) for each number of sectors that there may be, and each way to look at their limits.
template <typename Check>
void forEachNumber(const Check& check) {
  for (int count = 2; count <= SectorLimits::MOST; ++count) {
    SCOPED_TRACE(std::to_string(count) + " sectors");
    const EvenSectors sectors(count);
    for (const CompareLimits compare : {compareLimitsAnywhere, fastestCompareLimits()}) {
      check(sectors, SectorLimits(sectors, compare));
    }
  }
}

double angleToNearestLimit(double angle, const EvenSectors& sectors) {
  return std::abs(std::remainder(angle - sectors.rightLimit(0), sectors.width()));
}

TEST(SectorLimits, TellTheSectorsBetweenTheTangentsOfADisc) {
  KeyedRandom random(1, KeyedRandom::PLACEMENT, {});
  forEachNumber([&](const EvenSectors& sectors, const SectorLimits& limits) {
    for (int i = 0; i < 400; ++i) {
      const Vector2 centre(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0));
      const double radius = centre.norm() * random.uniform(1e-3, 0.999);
      ASSERT_EQ(limits.reachedBy(centre, radius), sectorsBetweenTangents(sectors, centre, radius)) << "draw " << i;
    }
  });
}

TEST(SectorLimits, TellTheSectorOfAPoint) {
  KeyedRandom random(2, KeyedRandom::PLACEMENT, {});
  forEachNumber([&](const EvenSectors& sectors, const SectorLimits& limits) {
    for (int i = 0; i < 2000; ++i) {
      const Vector2 point(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0));
      ASSERT_EQ(limits.reachedBy(point, 0.0), 1U << static_cast<unsigned>(sectors.indexOf(bearingOf(point))))
          << "draw " << i;
    }
  });
}

TEST(SectorLimits, LeaveItToAnglesWhereARimEndsAtALimit) {
  forEachNumber([&](const EvenSectors& sectors, const SectorLimits& limits) {
    const int count = sectors.count();
    for (int sector = 0; sector < count; ++sector) {
      for (const double half_span : {0.01, 0.3, 1.2, PI / 2 - 1e-8}) {
        for (const double side : {-1.0, 1.0}) {
          const Vector2 centre = 1.7 * unitVector(sectors.rightLimit(sector) + side * half_span);
          ASSERT_EQ(limits.reachedBy(centre, 1.7 * std::sin(half_span)), 0U) << "limit " << sector;
        }
      }
      const Vector2 on_limit = 1.7 * unitVector(sectors.rightLimit(sector));
      ASSERT_EQ(limits.reachedBy(on_limit, 0.0), 0U) << "limit " << sector;
      // A disc round that limit lies in the sectors on either side of it, and nothing is to be decided.
      const SectorSet both =
          1U << static_cast<unsigned>(sector) | 1U << static_cast<unsigned>((sector + count - 1) % count);
      ASSERT_EQ(limits.reachedBy(on_limit, 0.01), both) << "limit " << sector;
    }
    EXPECT_EQ(limits.reachedBy(Vector2::Zero(), 0.0), 0U);
  });
}

TEST(SectorLimits, AreClearAHairAwayFromALimit) {
  const EvenSectors sectors(8);
  const SectorLimits limits(sectors);
  constexpr double RADIUS = 0.5;
  constexpr double HALF_SPAN = 0.25268025514207865;  // asin(0.5 / 2)
  for (const double hair : {-1e-6, 1e-6}) {
    // Its left tangent ends a hair before or behind the limit between sectors 0 and 1.
    const Vector2 centre = 2.0 * unitVector(sectors.rightLimit(1) - HALF_SPAN + hair);
    ASSERT_GT(angleToNearestLimit(bearingOf(centre) + HALF_SPAN, sectors), 1e-7);
    EXPECT_EQ(limits.reachedBy(centre, RADIUS), hair < 0.0 ? 0b01U : 0b11U);
  }
}

}  // namespace
}  // namespace crowd
