// Scalar kernels, which define the results.

#include <algorithm>
#include <cmath>

#include "simd/kernels.h"

namespace crowd::simd {
namespace {

std::size_t collectNearby(const DiscArrays& arrays, DiscRange range, const Circle& circle, std::size_t count,
                          const CollectedDiscs& collected) {
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    const double dx = arrays.xs[i] - circle.x;
    const double dy = arrays.ys[i] - circle.y;
    const double square = dx * dx + dy * dy;
    const double limit = circle.radius + arrays.radii[i];
    // Always written, and kept by incrementing the count: a branch would be mispredicted half of the time.
    collected.discs[count] = i;
    collected.rims[count] = std::sqrt(square) - arrays.radii[i];
    count += static_cast<std::size_t>(square <= limit * limit) &
             static_cast<std::size_t>(arrays.neighbours[i] != circle.except);
  }
  return count;
}

bool isAnyNearby(const DiscArrays& arrays, DiscRange range, const Circle& circle) {
  bool any = false;
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    const double dx = arrays.xs[i] - circle.x;
    const double dy = arrays.ys[i] - circle.y;
    const double limit = circle.radius + arrays.radii[i];
    any |= (limit >= 0.0) & (dx * dx + dy * dy <= limit * limit) & (arrays.neighbours[i] != circle.except);
  }
  return any;
}

std::uint32_t rankAscending(const double* numbers, std::size_t count, std::uint32_t* ranks) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t smaller = 0;
    for (std::size_t j = 0; j < count; ++j) smaller += static_cast<float>(numbers[j]) < static_cast<float>(numbers[i]);
    ranks[i] = smaller;
    sum += smaller;
  }
  return sum;
}

/// All terms are multiplied by the distance, which avoids a square root.
std::uint32_t findNear(const NeighbourArrays& neighbours, const Nearness& nearness) {
  std::uint32_t near = 0;
  for (std::size_t i = 0; i < std::min(neighbours.count, MAX_LOOKED_AT); ++i) {
    const double x = neighbours.xs[i];
    const double y = neighbours.ys[i];
    const double receding =
        x * (nearness.velocity_x + neighbours.vxs[i]) + y * (nearness.velocity_y + neighbours.vys[i]);
    const double square = x * x + y * y;
    const double rest = square + nearness.tick_duration * (receding < 0.0 ? receding : 0.0);
    const double apart = nearness.room + neighbours.radii[i];
    const bool far = rest > 0.0 && rest * rest > apart * apart * square;
    near |= far ? 0U : std::uint32_t{1} << i;
  }
  return near;
}

std::uint32_t findNearStop(const NeighbourArrays& neighbours, const StoppingNearness& nearness) {
  std::uint32_t near = 0;
  for (std::size_t i = 0; i < std::min(neighbours.count, MAX_LOOKED_AT); ++i) {
    const double x = neighbours.xs[i];
    const double y = neighbours.ys[i];
    const double vx = neighbours.vxs[i];
    const double vy = neighbours.vys[i];
    const double distance = std::sqrt(x * x + y * y);
    const double speed = std::sqrt(vx * vx + vy * vy);
    const double own = std::max(0.0, x * nearness.stop_x + y * nearness.stop_y);
    const double its = std::max(0.0, -(x * vx + y * vy) * speed * nearness.per_braking);
    const double apart = distance - nearness.room - nearness.tick_duration * speed - neighbours.radii[i];
    near |= distance * apart - own - its <= 0.0 ? std::uint32_t{1} << i : 0U;
  }
  return near;
}

/// A neighbour in single precision.
struct Disc {
  float x;
  float y;
  float gap;       // square of the distance less that of the sum of both radii, 0 if they overlap [m2]
  float per_root;  // factor in inverseTime(): 1 / gap [1/m2], or AT_ONCE
};

/// Inverse of the time to collision with a disc at a relative velocity [1/s]; NaN if the disc is not reached.
/// @details The smaller root of |p - t v| = r is t = gap / (p.v + sqrt((p.v)^2 - v^2 gap)). It is negative if the disc
/// recedes.
float inverseTime(const Disc& disc, float vx, float vy) {
  const float closing = disc.x * vx + disc.y * vy;
  const float square = vx * vx + vy * vy;
  return (closing + std::sqrt(closing * closing - square * disc.gap)) * disc.per_root;
}

void raise(float value, float& highest) { highest = value > highest ? value : highest; }  // ignores NaN

float accumulateTimeToCollision(const NeighbourArrays& neighbours, const Observer& self,
                                const CandidateArrays& candidates) {
  float fastest = 0.0F;
  for (std::size_t i = 0; i < neighbours.count; ++i) {
    const double reach = self.radius + neighbours.radii[i];
    const double gap = (neighbours.xs[i] * neighbours.xs[i] + neighbours.ys[i] * neighbours.ys[i]) - reach * reach;
    Disc disc{static_cast<float>(neighbours.xs[i]), static_cast<float>(neighbours.ys[i]),
              static_cast<float>(gap > 0.0 ? gap : 0.0), AT_ONCE};
    if (disc.gap > 0.0F) disc.per_root = 1.0F / disc.gap;
    const auto vx = static_cast<float>(neighbours.vxs[i]);
    const auto vy = static_cast<float>(neighbours.vys[i]);
    const float approach = disc.x * (self.preferred_x - vx) + disc.y * (self.preferred_y - vy);
    if (approach > 0.0F) raise(approach * approach / (disc.x * disc.x + disc.y * disc.y), fastest);
    // Relative to the mean velocity; the caller halves the time, as reciprocal avoidance has 2u - w - v instead.
    const float mean_vx = 0.5F * (self.velocity_x + vx);
    const float mean_vy = 0.5F * (self.velocity_y + vy);
    for (std::size_t k = 0; k < candidates.count; ++k) {
      raise(inverseTime(disc, candidates.xs[k] - vx, candidates.ys[k] - vy), candidates.constant_velocity[k]);
      if (candidates.reciprocal == nullptr) continue;
      raise(inverseTime(disc, candidates.xs[k] - mean_vx, candidates.ys[k] - mean_vy), candidates.reciprocal[k]);
    }
  }
  return fastest;
}

void findRowNumbers(const ClassDigit* digits, std::size_t digit_count, LastDigit last, std::size_t count,
                    std::uint32_t* rows) {
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t row = 0;
    for (const ClassDigit* digit = digits; digit != digits + digit_count; ++digit) {
      row *= static_cast<std::uint32_t>(digit->limit_count + 1);
      for (std::size_t k = 0; k < digit->limit_count; ++k) row += digit->sign * digit->values[i] >= digit->limits[k];
    }
    rows[i] = row * last.classes + last.digit;
  }
}

void cutStops(const StopLimit& limit, const double* xs, const double* ys, std::size_t count, double* fractions) {
  for (std::size_t i = 0; i < count; ++i) {
    const double closing = limit.normal_x * xs[i] + limit.normal_y * ys[i];
    const double root = std::sqrt(std::max(0.0, limit.lost * limit.lost + limit.square / closing));
    const double left = std::max(0.0, (root - limit.lost) * limit.per_speed);
    const bool too_far = (closing > 0.0) & (fractions[i] > left);
    fractions[i] = too_far ? left : fractions[i];
  }
}

void cutFollowing(const Leader& leader, const double* xs, const double* ys, std::size_t count, double* fractions) {
  for (std::size_t i = 0; i < count; ++i) {
    const double ahead = xs[i] * leader.x + ys[i] * leader.y;
    const double aside = xs[i] * leader.y - ys[i] * leader.x;
    const double cosine = std::max(0.0, ahead) / leader.distance;
    const double most = std::max(leader.now, leader.later_gap / (leader.walked + leader.own_way * cosine));
    const bool limited = (ahead > 0.0) & (std::abs(aside) < leader.half_width) & (fractions[i] > most);
    fractions[i] = limited ? most : fractions[i];
  }
}

void findGaps(double to_x, double to_y, double radius, const RegionArrays& others, const GapArrays& gaps) {
  for (std::size_t i = 0; i < others.count; ++i) {
    const NearestPair nearest =
        nearestPair({0.0, 0.0, to_x, to_y}, {others.from_xs[i], others.from_ys[i], others.to_xs[i], others.to_ys[i]});
    const double x = nearest.second_x - nearest.first_x;
    const double y = nearest.second_y - nearest.first_y;
    const double distance = std::sqrt(x * x + y * y);
    gaps.normal_xs[i] = distance > 0.0 ? x / distance : 0.0;
    gaps.normal_ys[i] = distance > 0.0 ? y / distance : 0.0;
    gaps.widths[i] = distance - radius - others.radii[i];
    gaps.alongs[i] = gaps.normal_xs[i] * nearest.first_x + gaps.normal_ys[i] * nearest.first_y;
  }
}

}  // namespace

const Kernels REFERENCE = {
    "reference",    collectNearby, isAnyNearby,  rankAscending, findNear, findNearStop, accumulateTimeToCollision,
    findRowNumbers, cutStops,      cutFollowing, findGaps};

}  // namespace crowd::simd
