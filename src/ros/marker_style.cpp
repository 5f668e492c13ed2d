#include "social_crowd/ros/marker_style.h"

#include <algorithm>
#include <cmath>

namespace crowd::marker_style {
namespace {

constexpr double GOLDEN_RATIO = 0.61803398874989485;
constexpr double FIRST_HUE = 0.58;  // of agent 0: blue
// Hues within so much of red are left to contacts, in shares of the circle.
constexpr double RED_MARGIN = 0.045;

constexpr double SATURATION = 0.72;
constexpr double PALENESS = 0.35;  // of paths

Colour make(double red, double green, double blue, double alpha = 1.0) {
  Colour colour;
  colour.r = static_cast<float>(red);
  colour.g = static_cast<float>(green);
  colour.b = static_cast<float>(blue);
  colour.a = static_cast<float>(alpha);
  return colour;
}

Colour withAlpha(Colour colour, double alpha) {
  colour.a = static_cast<float>(alpha);
  return colour;
}

Colour towardsWhite(const Colour& colour, double share) {
  return make(colour.r + (1.0 - colour.r) * share, colour.g + (1.0 - colour.g) * share,
              colour.b + (1.0 - colour.b) * share);
}

/// One channel of the colour circle: a trapezoid of the distance from the channel's own hue.
double channel(double hue, double own_hue) {
  double distance = std::abs(hue - own_hue);
  distance = std::min(distance, 1.0 - distance);
  return std::clamp(2.0 - 6.0 * distance, 0.0, 1.0);
}

/// @param hue 0 red, 1/3 green, 2/3 blue
Colour fromHue(double hue, double saturation, double value) {
  const auto shade = [&](double own_hue) { return value * (1.0 - saturation * (1.0 - channel(hue, own_hue))); };
  return make(shade(0.0), shade(1.0 / 3.0), shade(2.0 / 3.0));
}

/// Yellow and green look brighter than blue of the same value; on a light ground they would get lost.
double valueOf(double hue) { return 0.88 - 0.2 * channel(hue, 1.0 / 3.0); }

}  // namespace

std::size_t cornersFor(std::size_t bodies) {
  return std::clamp(CORNER_BUDGET / std::max<std::size_t>(bodies, 1), MIN_CORNERS, MAX_CORNERS);
}

Colour ofAgent(std::uint32_t agent) {
  const double turns = FIRST_HUE + GOLDEN_RATIO * agent;
  const double hue = RED_MARGIN + (turns - std::floor(turns)) * (1.0 - 2.0 * RED_MARGIN);
  return fromHue(hue, SATURATION, valueOf(hue));
}

Colour ofPath(std::uint32_t agent) { return towardsWhite(ofAgent(agent), PALENESS); }

Colour ofSector(int distance_class) {
  return withAlpha(ofRadius(distance_class), distance_class <= 1 ? 0.4 : 0.35);
}

Colour ofRadius(int distance_class) {
  if (distance_class <= 1) return make(0.85, 0.2, 0.15);
  return distance_class == 2 ? make(0.95, 0.62, 0.1) : make(0.55, 0.55, 0.6);
}

Colour ofContact() { return make(0.9, 0.0, 0.05); }
Colour ofHeading() { return make(1.0, 1.0, 1.0); }
Colour ofObstacle() { return make(0.42, 0.44, 0.47); }
Colour ofWall() { return make(0.25, 0.27, 0.3); }

}  // namespace crowd::marker_style
