#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "geometry/geometry.h"
#include "ros/markers/marker_style.h"
#include "ros/markers/marker_values.h"

namespace crowd::values_test {
namespace {

using visualization_msgs::Marker;

social_crowd::CandidateValue move(double degrees, double fraction, double admissible, double value,
                                  std::uint32_t visits) {
  social_crowd::CandidateValue candidate;
  candidate.direction = toRadians(degrees);
  candidate.speed_fraction = fraction;
  candidate.admissible_fraction = admissible;
  candidate.value = value;
  candidate.visits = visits;
  return candidate;
}

/// An agent at (2, 1) that looks along y: ahead it may walk at half of the speed it wants; the move to its left is the
/// best one; staying is worst.
social_crowd::DecisionValues decision() {
  social_crowd::DecisionValues message;
  message.pose.x = 2.0;
  message.pose.y = 1.0;
  message.pose.theta = PI / 2.0;
  message.actions = {move(0.0, 1.0, 0.5, 5.0, 12), move(90.0, 0.5, 0.5, 10.0, 34'567), move(0.0, 0.0, 0.0, 0.0, 0)};
  message.chosen = 1;
  return message;
}

constexpr double RADIUS = 0.25;
constexpr double INNER = 0.31;  // where wedges begin

struct Point {
  double distance;
  double degrees;  // in the frame of the agent
};

std::vector<Point> pointsOf(const Marker& marker, const marker_style::Colour& colour) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < marker.points.size(); ++i) {
    if (marker.colors[i] != colour) continue;
    const Vector2 v(marker.points[i].x - 2.0, marker.points[i].y - 1.0);
    points.push_back({v.norm(), toDegrees(std::remainder(bearingOf(v) - PI / 2.0, 2.0 * PI))});
  }
  return points;
}

void expectRing(const std::vector<Point>& points, double inner, double outer) {
  ASSERT_FALSE(points.empty());
  const auto nearer = [](const Point& a, const Point& b) { return a.distance < b.distance; };
  EXPECT_NEAR(std::min_element(points.begin(), points.end(), nearer)->distance, inner, 1e-9);
  EXPECT_NEAR(std::max_element(points.begin(), points.end(), nearer)->distance, outer, 1e-9);
}

std::vector<Marker> drawn(const social_crowd::DecisionValues& message) {
  visualization_msgs::MarkerArray array;
  ValuesDrawing().draw(&message, RADIUS, array);
  return array.markers;
}

TEST(Values, WedgesShowDirectionSpeedAndValue) {
  const Marker fills = drawn(decision())[0];
  EXPECT_EQ(fills.ns, "values");
  const marker_style::Colour half = marker_style::ofValue(0.5);
  const std::vector<Point> ahead = pointsOf(fills, half);
  expectRing(ahead, INNER, INNER + 0.5);
  for (const Point& point : ahead) EXPECT_LE(std::abs(point.degrees), 10.1);
  const std::vector<Point> left = pointsOf(fills, marker_style::ofValue(1.0));
  expectRing(left, INNER, INNER + 0.5);
  for (const Point& point : left) EXPECT_NEAR(point.degrees, 90.0, 10.1);
  expectRing(pointsOf(fills, marker_style::ofValue(0.0)), RADIUS, RADIUS + 0.05);  // staying
  // What the separation rule forbids.
  expectRing(pointsOf(fills, marker_style::faded(half, 0.25)), INNER + 0.5, INNER + 1.0);
}

TEST(Values, TheChosenMoveHasAnOutline) {
  const Marker outline = drawn(decision())[1];
  EXPECT_EQ(outline.type, Marker::LINE_LIST);
  const std::vector<Point> points = pointsOf(outline, marker_style::ofChosenMove(false));
  ASSERT_EQ(points.size(), outline.points.size());
  for (const Point& point : points) EXPECT_NEAR(point.degrees, 90.0, 10.1);
  social_crowd::DecisionValues curious = decision();
  curious.exploration = 1;
  EXPECT_FALSE(pointsOf(drawn(curious)[1], marker_style::ofChosenMove(true)).empty());
  EXPECT_NE(marker_style::ofChosenMove(true), marker_style::ofChosenMove(false));
}

TEST(Values, WedgesOfNearDirectionsDoNotOverlap) {
  social_crowd::DecisionValues message = decision();
  message.actions = {move(0.0, 1.0, 1.0, 0.0, 0), move(10.0, 1.0, 1.0, 1.0, 0), move(350.0, 1.0, 1.0, 2.0, 0)};
  const Marker fills = drawn(message)[0];
  for (const Point& point : pointsOf(fills, marker_style::ofValue(0.0))) EXPECT_LT(std::abs(point.degrees), 5.0);
  for (const Point& point : pointsOf(fills, marker_style::ofValue(0.5))) EXPECT_GT(point.degrees, 5.0);
  for (const Point& point : pointsOf(fills, marker_style::ofValue(1.0))) EXPECT_LT(point.degrees, -5.0);
}

TEST(Values, TextsTellTheVisits) {
  const std::vector<Marker> markers = drawn(decision());
  ASSERT_EQ(markers.size(), 5U);
  const std::vector<std::string> texts = {markers[2].text, markers[3].text, markers[4].text};
  EXPECT_EQ(texts, (std::vector<std::string>{"12", "35k", "0"}));
  EXPECT_GT(markers[2].pose.position.y, 1.0 + INNER + 1.0);  // ahead
  EXPECT_LT(markers[3].pose.position.x, 2.0 - INNER - 0.5);  // to the left
  for (std::size_t i = 2; i < 5; ++i) {
    EXPECT_EQ(markers[i].ns, "visits");
    EXPECT_EQ(markers[i].type, Marker::TEXT_VIEW_FACING);
  }
}

TEST(Values, VisitsHaveAtMostFourCharacters) {
  EXPECT_EQ(visitsText(0), "0");
  EXPECT_EQ(visitsText(999), "999");
  EXPECT_EQ(visitsText(1000), "1.0k");
  EXPECT_EQ(visitsText(1249), "1.2k");
  EXPECT_EQ(visitsText(9960), "10k");
  EXPECT_EQ(visitsText(999'499), "999k");
  EXPECT_EQ(visitsText(999'600), "1.0M");
  EXPECT_EQ(visitsText(4'294'967'295U), "4.3G");
}

TEST(Values, OfEqualValueHaveTheColourOfTheBest) {
  social_crowd::DecisionValues message = decision();
  for (auto& action : message.actions) action.value = -3.0;
  const Marker fills = drawn(message)[0];
  EXPECT_FALSE(pointsOf(fills, marker_style::ofValue(1.0)).empty());
  EXPECT_TRUE(pointsOf(fills, marker_style::ofValue(0.0)).empty());
}

TEST(Values, AreDeletedWithTheDecision) {
  ValuesDrawing drawing;
  visualization_msgs::MarkerArray array;
  drawing.draw(nullptr, RADIUS, array);
  EXPECT_TRUE(array.markers.empty());  // nothing was drawn before
  const social_crowd::DecisionValues message = decision();
  drawing.draw(&message, RADIUS, array);
  array.markers.clear();
  drawing.draw(nullptr, RADIUS, array);
  ASSERT_EQ(array.markers.size(), 5U);
  for (const Marker& marker : array.markers) EXPECT_EQ(marker.action, Marker::DELETE);
}

TEST(Values, ThatCannotBeDrawnAreLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<social_crowd::DecisionValues> broken(5, decision());
  broken[0].pose.x = nan;
  broken[1].actions[0].value = nan;
  broken[2].actions[0].speed_fraction = 1e9;
  broken[3].chosen = 3;
  broken[4].actions.clear();
  for (const social_crowd::DecisionValues& message : broken) EXPECT_TRUE(drawn(message).empty());
}

}  // namespace
}  // namespace crowd::values_test
