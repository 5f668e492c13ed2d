#include "social_crowd/learning/contact_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "social_crowd/common/random.h"
#include "social_crowd/learning/wide_contact_times.h"

namespace crowd {
namespace {

Vector2 anyVector(KeyedRandom& random, double longest) {
  return random.uniform(0.0, longest) * unitVector(random.uniform(-PI, PI));
}

/// A velocity of people, one that hardly is one, or none.
Vector2 anyVelocity(KeyedRandom& random) {
  constexpr std::array<double, 8> LONGEST = {1.6, 1.6, 1.6, 0.3, 1e-6, 1e-13, 1e-22, 0.0};
  return anyVector(random, LONGEST[random.below(LONGEST.size())]);
}

/// Discs far and near, some touching or overlapping the agent or in its very place, some as fast as it; then some that
/// fly away.
Discs anyDiscs(KeyedRandom& random, std::size_t count, const Vector2& velocity) {
  constexpr std::array<double, 6> FARTHEST = {6.0, 6.0, 2.0, 300.0, 1e-6, 0.0};
  Discs discs;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2 place = anyVector(random, FARTHEST[random.below(FARTHEST.size())]);
    const double reach = random.below(8) == 0 ? place.norm() : random.uniform(0.0, 0.6);
    discs.put(i, place, random.below(8) == 0 ? velocity : anyVelocity(random), reach);
  }
  discs.leaveOut(count);
  return discs;
}

/// Moves ahead of some disc, along the edge of one, as fast as one, or anywhere; in the other lanes the last again.
Courses anyCourses(KeyedRandom& random, const Discs& discs) {
  Courses courses(1 + random.below(MoveOutlooks::LANES), 0.0F);
  const double speed = random.uniform(0.01, 2.0);
  for (std::size_t i = 0; i < MoveOutlooks::LANES; ++i) {
    const std::size_t disc = random.below(Discs::SIZE);
    const Vector2 place(discs.px[disc], discs.py[disc]);
    const double edge = std::asin(std::sqrt(std::max(0.0, 1.0 - discs.apart[disc] / place.squaredNorm())));
    Vector2 u = anyVelocity(random);
    if (random.below(3) == 0 && place.norm() > 0.0) u = speed * unitVector(bearingOf(place) + edge);
    if (random.below(6) == 0 && discs.vx[disc] < Discs::FLYING) u = u + Vector2(discs.vx[disc], discs.vy[disc]);
    courses.ux[i] = i < courses.count ? static_cast<float>(u.x()) : courses.ux[courses.count - 1];
    courses.uy[i] = i < courses.count ? static_cast<float>(u.y()) : courses.uy[courses.count - 1];
    courses.speed = std::max(courses.speed, std::hypot(courses.ux[i], courses.uy[i]));
  }
  return courses;
}

bool areSame(const Courses& a, const Courses& b) {
  const std::size_t size = a.count * sizeof(float);
  return std::memcmp(a.selfish.data(), b.selfish.data(), size) == 0 &&
         std::memcmp(a.reciprocal.data(), b.reciprocal.data(), size) == 0;
}

TEST(ContactTimes, AreTheSameBitsEveryWay) {
  for (std::uint64_t seed = 1; seed <= 100000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const Vector2 velocity = anyVelocity(random);
    const Vector2 wish = anyVelocity(random);
    const std::size_t count = random.below(Discs::SIZE + 1);
    Discs discs = anyDiscs(random, count, velocity);
    Courses plain = anyCourses(random, discs);
    Courses wide = plain;
    float plain_fastest = 0.0F;
    float wide_fastest = 0.0F;
    for (std::size_t times = 1 + random.below(2); times > 0; --times) {  // more discs than lie side by side
      noteAgentsPlainly(discs, count, velocity, wish, plain, plain_fastest);
      fastestForMany()(discs, count, velocity, wish, wide, wide_fastest);
      discs = anyDiscs(random, count, velocity);
    }
    ASSERT_TRUE(areSame(plain, wide)) << "seed " << seed;
    ASSERT_EQ(plain_fastest, wide_fastest) << "seed " << seed;
  }
}

}  // namespace
}  // namespace crowd
