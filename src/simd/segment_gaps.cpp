#include "simd/segment_gaps.h"

#include <array>
#include <limits>

namespace crowd::simd {
namespace {

/// A segment as a point and a way from there; the reciprocal of a length of 0 is 0.
struct Way {
  explicit Way(const PlaneSegment& segment)
      : from_x(segment.from_x),
        from_y(segment.from_y),
        x(segment.to_x - segment.from_x),
        y(segment.to_y - segment.from_y) {
    const double square = x * x + y * y;
    per_square = square > 0.0 ? 1.0 / square : 0.0;
  }
  /// Cross product of the way and that from its start to a place.
  double sideOf(double place_x, double place_y) const { return x * (place_y - from_y) - y * (place_x - from_x); }
  /// Whether the ends of another segment are on different sides of the line of this one.
  bool separatesEnds(const PlaneSegment& other) const {
    return sideOf(other.from_x, other.from_y) * sideOf(other.to_x, other.to_y) < 0.0;
  }
  /// Which share of the way leads to the point nearest to a place.
  double shareTo(double place_x, double place_y) const {
    return std::clamp(((place_x - from_x) * x + (place_y - from_y) * y) * per_square, 0.0, 1.0);
  }

  double from_x;
  double from_y;
  double x;
  double y;
  double per_square;
};

NearestPair toSecond(double place_x, double place_y, const Way& second) {
  const double share = second.shareTo(place_x, place_y);
  return {place_x, place_y, second.from_x + share * second.x, second.from_y + share * second.y};
}

NearestPair toFirst(const Way& first, double place_x, double place_y) {
  const double share = first.shareTo(place_x, place_y);
  return {first.from_x + share * first.x, first.from_y + share * first.y, place_x, place_y};
}

}  // namespace

NearestPair nearestPair(const PlaneSegment& first, const PlaneSegment& second) {
  const Way one(first);
  const Way other(second);
  if (one.separatesEnds(second) && other.separatesEnds(first)) {
    const double denominator = one.x * other.y - one.y * other.x;
    if (denominator != 0.0) {
      const double ahead = (other.from_x - one.from_x) * other.y - (other.from_y - one.from_y) * other.x;
      const double share = std::clamp(ahead / denominator, 0.0, 1.0);
      const double x = one.from_x + share * one.x;
      const double y = one.from_y + share * one.y;
      return {x, y, x, y};
    }
  }
  const std::array<NearestPair, 4> ends = {
      toSecond(first.from_x, first.from_y, other), toSecond(first.to_x, first.to_y, other),
      toFirst(one, second.from_x, second.from_y), toFirst(one, second.to_x, second.to_y)};
  std::size_t nearest = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double x = ends[i].second_x - ends[i].first_x;
    const double y = ends[i].second_y - ends[i].first_y;
    const double square = x * x + y * y;
    nearest = square < smallest ? i : nearest;
    smallest = std::min(square, smallest);
  }
  return ends[nearest];
}

}  // namespace crowd::simd
