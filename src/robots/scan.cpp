#include "robots/scan.h"

#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

constexpr float NO_RETURN = std::numeric_limits<float>::infinity();
constexpr double FULL_CIRCLE_TOLERANCE = 1e-9;  // [rad]

float toRange(double distance, const ScanSpec& spec) {
  if (distance < spec.min_range) return -NO_RETURN;
  return distance <= spec.max_range ? static_cast<float>(distance) : NO_RETURN;
}

}  // namespace

std::uint64_t scanTicks(const ScanSpec& spec, double tick_duration) {
  return static_cast<std::uint64_t>(std::max(1.0, std::round(spec.period / tick_duration)));
}

double angleIncrement(const ScanSpec& spec) {
  const double width = spec.last_angle - spec.first_angle;
  const double rays = spec.rays;
  if (width >= 2.0 * PI - FULL_CIRCLE_TOLERANCE) return 2.0 * PI / rays;
  return spec.rays > 1 ? width / (rays - 1.0) : 2.0 * PI;
}

void writeRanges(const Scan& scan, const ScanSpec& spec, const KeyedRandom& key, std::vector<float>& ranges) {
  ranges.resize(scan.distances.size());
  const bool is_random = spec.noise > 0.0 || spec.dropout > 0.0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    double distance = scan.distances[i];
    bool drops_out = false;
    if (is_random) {
      KeyedRandom random = key.with(i);
      distance += spec.noise * random.normal();
      drops_out = random.uniform() < spec.dropout;
    }
    ranges[i] = drops_out ? std::numeric_limits<float>::quiet_NaN() : toRange(distance, spec);
  }
}

void markVisible(const Scan& scan, std::vector<bool>& seen) {
  for (const BodyNumber body : scan.hits) {
    if (body < seen.size()) seen[body] = true;
  }
}

}  // namespace crowd
