#include "ros/markers/marker_style.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace crowd::marker_style {
namespace {

constexpr double GOLDEN_RATIO = 0.61803398874989485;
constexpr double FIRST_SHADE = 0.69;  // of agent 0: blue

/// Hues of agents at even steps. They are denser where hues are easier to distinguish; red is reserved for contacts.
constexpr std::array<double, 9> HUES = {0.05, 0.085, 0.13, 0.29, 0.45, 0.56, 0.64, 0.76, 0.91};

/// Distinguishes agents with nearly the same hue, whose numbers differ by 5, 8 or 13 because of the golden ratio.
struct Tone {
  double saturation;
  double value;
};
constexpr std::array<Tone, 3> TONES = {{{0.75, 0.9}, {0.85, 0.68}, {0.5, 0.8}}};
constexpr std::uint32_t TONE_RUN = 5;  // number of consecutive agents with the same tone

constexpr double LIGHT = 1.35;    // of shirts: RViz draws meshes darker than lists
constexpr double FLOOR = 0.98;    // grey value
constexpr double PALENESS = 0.4;  // 0: not at all, 1: white

Colour make(double red, double green, double blue, double alpha = 1.0) {
  Colour colour;
  colour.r = static_cast<float>(red);
  colour.g = static_cast<float>(green);
  colour.b = static_cast<float>(blue);
  colour.a = static_cast<float>(alpha);
  return colour;
}

/// Picks one of several values for an agent, independently of its colour and of other choices.
template <typename Values>
const auto& pick(const Values& values, std::uint32_t agent, std::uint32_t choice) {
  return values[(agent + choice) * 2'654'435'761U / 65'536U % values.size()];  // Knuth's multiplicative hash
}

Colour withAlpha(Colour colour, double alpha) {
  colour.a = static_cast<float>(alpha);
  return colour;
}

/// One channel of the colour circle: a trapezoid function of the distance from the hue of the channel.
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

/// @param share position along HUES, from 0 to below 1
double hueAt(double share) {
  const double steps = share * static_cast<double>(HUES.size() - 1);
  const auto before = static_cast<std::size_t>(steps);
  return HUES[before] + (HUES[before + 1] - HUES[before]) * (steps - static_cast<double>(before));
}

/// Yellow and green look brighter than blue of the same value and would be hard to see on a light ground.
double dim(double hue) { return 1.0 - 0.22 * channel(hue, 1.0 / 3.0); }

}  // namespace

std::size_t cornersFor(std::size_t bodies) {
  return std::clamp(CORNER_BUDGET / std::max<std::size_t>(bodies, 1), MIN_CORNERS, MAX_CORNERS);
}

Colour ofAgent(std::uint32_t agent) {
  const double turns = FIRST_SHADE + GOLDEN_RATIO * agent;
  const double hue = hueAt(turns - std::floor(turns));
  const Tone& tone = TONES[agent / TONE_RUN % TONES.size()];
  return fromHue(hue, tone.saturation, tone.value * dim(hue));
}

Colour paler(const Colour& colour) {
  const auto shade = [](double value) { return value + (1.0 - value) * PALENESS; };
  return make(shade(colour.r), shade(colour.g), shade(colour.b), colour.a);
}

Colour faded(const Colour& colour, double strength) {
  const auto mix = [strength](double value) { return FLOOR + (value - FLOOR) * strength; };
  return make(mix(colour.r), mix(colour.g), mix(colour.b), colour.a);
}

Colour ofRadius(std::size_t distance_class, std::size_t classes) {
  return distance_class < classes ? make(0.85, 0.2, 0.15) : make(0.95, 0.62, 0.1);
}

Colour ofSector(std::size_t distance_class, std::size_t classes) {
  return withAlpha(ofRadius(distance_class, classes), distance_class < classes ? 0.4 : 0.35);
}

Colour ofFigure(FigurePart part, Figure figure, std::uint32_t agent) {
  static const std::array<Colour, 3> SKIN = {make(0.87, 0.69, 0.58), make(0.74, 0.54, 0.41), make(0.45, 0.31, 0.23)};
  static const std::array<Colour, 4> DARK = {make(0.28, 0.24, 0.22), make(0.47, 0.34, 0.24), make(0.34, 0.37, 0.46),
                                             make(0.55, 0.54, 0.54)};
  switch (part) {
    case FigurePart::HEAD:
      return pick(SKIN, agent, 1);
    case FigurePart::DARK:
      return figure == Figure::OLD ? make(0.72, 0.72, 0.74) : pick(DARK, agent, 2);
    case FigurePart::BELONGINGS:
      return make(0.16, 0.17, 0.2);
    case FigurePart::SHIRT:
      break;
  }
  const Colour shirt = ofAgent(agent);
  const auto lit = [](double value) { return std::min(1.0, LIGHT * value); };
  return make(lit(shirt.r), lit(shirt.g), lit(shirt.b));
}

double figureHeight(Figure figure, std::uint32_t agent) {
  static constexpr std::array<double, 5> HEIGHTS = {0.92, 0.96, 1.0, 1.03, 1.06};
  static constexpr double CHILD_HEIGHT = 0.6;
  return (figure == Figure::CHILD ? CHILD_HEIGHT : 1.0) * pick(HEIGHTS, agent, 3);
}

Colour underFigure(std::uint32_t agent) { return withAlpha(ofAgent(agent), 0.45); }

Colour ofValue(double share) {
  using Shade = std::array<double, 3>;
  // Five shades of matplotlib's viridis.
  static constexpr std::array<Shade, 5> SHADES = {{{0.267, 0.005, 0.329},
                                                   {0.231, 0.322, 0.546},
                                                   {0.128, 0.567, 0.551},
                                                   {0.369, 0.789, 0.383},
                                                   {0.993, 0.906, 0.144}}};
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(SHADES.size() - 1);
  const std::size_t before = std::min(static_cast<std::size_t>(place), SHADES.size() - 2);
  const double part = place - static_cast<double>(before);
  const auto mix = [&](std::size_t channel) {
    return SHADES[before][channel] + part * (SHADES[before + 1][channel] - SHADES[before][channel]);
  };
  return make(mix(0), mix(1), mix(2));
}

Colour ofChosenMove(bool exploration) { return exploration ? make(0.85, 0.15, 0.6) : make(0.05, 0.05, 0.05); }
Colour ofVisits() { return make(0.1, 0.1, 0.12); }
Colour ofContact() { return make(0.9, 0.0, 0.05); }
Colour ofGroup() { return make(0.45, 0.5, 0.6); }
Colour ofRobot() { return make(0.2, 0.14, 0.42); }
Colour ofHeading() { return make(1.0, 1.0, 1.0); }
Colour ofObstacle() { return make(0.42, 0.44, 0.47); }
Colour ofRecorded() { return make(0.12, 0.13, 0.16); }
Colour ofWall() { return make(0.25, 0.27, 0.3); }

Colour ofCell(bool occupied) { return occupied ? make(0.5, 0.5, 0.5) : make(0.87, 0.89, 0.88); }

}  // namespace crowd::marker_style
