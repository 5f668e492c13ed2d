#include "social_crowd/learning/contact_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

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
Courses anyCourses(KeyedRandom& random, const Discs& discs, const Vector2& velocity) {
  Courses courses;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  courses.count = 1 + random.below(MoveOutlooks::LANES);
  courses.speed = 0.0F;
  courses.velocity = velocity;
  courses.wish = anyVelocity(random);
  courses.touchNothing();
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
         std::memcmp(a.reciprocal.data(), b.reciprocal.data(), size) == 0 && a.fastest == b.fastest;
}

TEST(ContactTimes, AreTheSameBitsEveryWay) {
  std::vector<Courses> plain(MAX_ENCOUNTERS);
  std::vector<Courses> wide(MAX_ENCOUNTERS);
  std::vector<Encounter> plainly(MAX_ENCOUNTERS);
  std::vector<Encounter> widely(MAX_ENCOUNTERS);
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const std::size_t encounters = 1 + random.below(MAX_ENCOUNTERS);
    std::size_t who = 0;
    for (std::size_t i = 0; i < encounters; ++i) {
      const Vector2 velocity = anyVelocity(random);
      const std::size_t count = random.below(Discs::SIZE + 1);
      const Discs discs = anyDiscs(random, count, velocity);
      // Now and then more discs than lie side by side.
      if (i == 0 || random.below(4) != 0) who = i;
      if (who == i) plain[i] = wide[i] = anyCourses(random, discs, velocity);
      plainly[i] = {discs, count, &plain[who]};
      widely[i] = {discs, count, &wide[who]};
    }
    noteAgentsPlainly({plainly.data(), encounters});
    fastestNoteAgents()({widely.data(), encounters});
    for (std::size_t i = 0; i < encounters; ++i) {
      ASSERT_TRUE(areSame(*plainly[i].courses, *widely[i].courses)) << "seed " << seed << ", encounter " << i;
    }
  }
}

}  // namespace
}  // namespace crowd
