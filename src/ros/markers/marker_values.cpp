#include "ros/markers/marker_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include "ros/markers/marker_shapes.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"

namespace crowd {
namespace {

using marker_style::Colour;
using marker_style::Layer;
using social_crowd::CandidateValue;
using visualization_msgs::Marker;

constexpr double GAP = 0.06;              // between body and wedges [m]
constexpr double LENGTH = 1.0;            // of the wedge of a move at full speed [m]
constexpr double RING_WIDTH = 0.05;       // of staying [m]
constexpr double FILLED = 0.42;           // half of a wedge, as a part of the angle to the next one
constexpr double MOST_HALF = 0.175;       // half of a wedge [rad]
constexpr double TEXT_HEIGHT = 0.14;      // [m]
constexpr double TEXT_DISTANCE = 0.12;    // from the end of the wedge [m]
constexpr double SECOND_DISTANCE = 0.28;  // that of every second one, so that texts do not overlap [m]
constexpr double FAINT = 0.25;
constexpr double NEARLY = 1e-6;

bool canBeDrawn(const social_crowd::DecisionValues& decision) {
  const auto is_fine = [](const CandidateValue& action) {
    return std::isfinite(action.direction) && std::isfinite(action.value) && action.speed_fraction >= 0.0 &&
           action.speed_fraction <= 1.0 && action.admissible_fraction >= 0.0 &&
           action.admissible_fraction <= action.speed_fraction;
  };
  return std::isfinite(decision.pose.x + decision.pose.y + decision.pose.theta) &&
         decision.chosen < decision.actions.size() &&
         std::all_of(decision.actions.begin(), decision.actions.end(), is_fine);
}

/// The wedges of a decision.
class Wedges {
 public:
  Wedges(const social_crowd::DecisionValues& decision, double radius)
      : decision_(decision), inner_(radius + GAP), half_(halfAngle(decision.actions)) {
    const auto by_value = [](const CandidateValue& a, const CandidateValue& b) { return a.value < b.value; };
    const auto [low, high] = std::minmax_element(decision.actions.begin(), decision.actions.end(), by_value);
    lowest_ = low->value;
    range_ = high->value - lowest_;
  }

  Marker fills() const {
    TriangleMarker marker(marker_style::VALUES, 0, Layer::VALUES);
    std::vector<std::size_t> order(decision_.actions.size());
    std::iota(order.begin(), order.end(), 0U);
    // Short ones over long ones of the same direction.
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return decision_.actions[a].speed_fraction > decision_.actions[b].speed_fraction;
    });
    for (const std::size_t i : order) fill(decision_.actions[i], marker);
    return marker.finish();
  }

  Marker outline() const {
    LineMarker marker(marker_style::VALUES, 1, Layer::CHOSEN_MOVE, marker_style::CHOSEN_WIDTH);
    const CandidateValue& chosen = decision_.actions[decision_.chosen];
    const Colour colour = marker_style::ofChosenMove(decision_.exploration != 0);
    if (isStay(chosen)) {
      for (const double radius : {inner_ - GAP, inner_ - GAP + RING_WIDTH}) {
        marker.addCircle(middle(), radius, unitCircle(marker_style::MAX_CORNERS), colour);
      }
    } else {
      const double outer = outerOf(chosen.speed_fraction);
      const double angle = angleOf(chosen);
      marker.addPolygon({at(inner_, angle - half_), at(outer, angle - half_), at(outer, angle),
                         at(outer, angle + half_), at(inner_, angle + half_)},
                        colour);
    }
    return marker.finish();
  }

  Marker text(std::size_t action) const {
    const CandidateValue& its = decision_.actions[action];
    Marker marker;
    marker.header.frame_id = names::MAP_FRAME;
    marker.ns = marker_style::VISITS;
    marker.id = static_cast<int>(action);
    marker.type = Marker::TEXT_VIEW_FACING;
    marker.text = visitsText(its.visits);
    marker.scale.z = TEXT_HEIGHT;
    const double distance = rankOf(action) % 2 == 0 ? TEXT_DISTANCE : SECOND_DISTANCE;
    marker.pose.position = toPoint(isStay(its) ? middle() : at(outerOf(its.speed_fraction) + distance, angleOf(its)));
    marker.pose.position.z = static_cast<int>(Layer::CONTACTS) * marker_style::LAYER_HEIGHT;
    marker.pose.orientation = toQuaternion(0.0);
    marker.color = marker_style::ofVisits();
    return marker;
  }

 private:
  static bool isStay(const CandidateValue& action) { return action.speed_fraction <= 0.0; }

  /// Half the angle of a wedge, such that different directions do not overlap.
  static double halfAngle(const std::vector<CandidateValue>& actions) {
    double smallest = MOST_HALF / FILLED;
    for (const CandidateValue& a : actions) {
      for (const CandidateValue& b : actions) {
        const double between = std::abs(std::remainder(a.direction - b.direction, 2.0 * PI));
        if (!isStay(a) && !isStay(b) && between > NEARLY) smallest = std::min(smallest, between);
      }
    }
    return FILLED * smallest;
  }

  void fill(const CandidateValue& action, TriangleMarker& marker) const {
    const Colour colour = marker_style::ofValue(range_ > 0.0 ? (action.value - lowest_) / range_ : 1.0);
    if (isStay(action)) {
      const double body = inner_ - GAP;
      return marker.addRing(middle(), body, body + RING_WIDTH, unitCircle(marker_style::MAX_CORNERS), colour);
    }
    const double angle = angleOf(action);
    const double reached = action.admissible_fraction > 0.0 ? outerOf(action.admissible_fraction) : inner_;
    const double outer = outerOf(action.speed_fraction);
    if (reached > inner_) marker.addRingPart(middle(), inner_, reached, angle - half_, angle + half_, colour);
    if (outer > reached + NEARLY) {
      marker.addRingPart(middle(), reached, outer, angle - half_, angle + half_, marker_style::faded(colour, FAINT));
    }
  }

  /// Number of moves of this speed whose direction comes before that of an action.
  std::size_t rankOf(std::size_t action) const {
    const CandidateValue& own = decision_.actions[action];
    return static_cast<std::size_t>(
        std::count_if(decision_.actions.begin(), decision_.actions.end(), [&](const CandidateValue& other) {
          return other.speed_fraction == own.speed_fraction &&
                 std::remainder(other.direction, 2.0 * PI) < std::remainder(own.direction, 2.0 * PI);
        }));
  }

  Vector2 middle() const { return {decision_.pose.x, decision_.pose.y}; }
  double angleOf(const CandidateValue& action) const { return decision_.pose.theta + action.direction; }
  double outerOf(double fraction) const { return inner_ + LENGTH * fraction; }
  Vector2 at(double distance, double angle) const { return middle() + distance * unitVector(angle); }

  const social_crowd::DecisionValues& decision_;
  double inner_;  // [m]
  double half_;   // [rad]
  double lowest_ = 0.0;
  double range_ = 0.0;
};

Marker removed(const char* kind, std::size_t id) {
  Marker marker;
  marker.header.frame_id = names::MAP_FRAME;
  marker.ns = kind;
  marker.id = static_cast<int>(id);
  marker.action = Marker::DELETE;
  return marker;
}

}  // namespace

std::string visitsText(std::uint32_t visits) {
  static constexpr std::array<const char*, 4> UNITS = {"", "k", "M", "G"};
  double number = visits;
  std::size_t unit = 0;
  for (; number >= 999.5; ++unit) number /= 1000.0;
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), unit > 0 && number < 9.95 ? "%.1f%s" : "%.0f%s", number, UNITS[unit]);
  return text.data();
}

void ValuesDrawing::draw(const social_crowd::DecisionValues* decision, double radius,
                         visualization_msgs::MarkerArray& array) {
  const bool shown = decision != nullptr && canBeDrawn(*decision);
  const std::size_t texts = shown ? decision->actions.size() : 0;
  if (shown) {
    const Wedges wedges(*decision, radius);
    array.markers.push_back(wedges.fills());
    array.markers.push_back(wedges.outline());
    for (std::size_t action = 0; action < texts; ++action) array.markers.push_back(wedges.text(action));
  } else if (most_texts_ > 0) {
    for (const std::size_t id : {0U, 1U}) array.markers.push_back(removed(marker_style::VALUES, id));
  }
  for (std::size_t i = texts; i < most_texts_; ++i) array.markers.push_back(removed(marker_style::VISITS, i));
  most_texts_ = std::max(most_texts_, texts);
}

}  // namespace crowd
