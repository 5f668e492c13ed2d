#include <gtest/gtest.h>

#include "ros/markers/marker_drawings.h"
#include "ros/markers/marker_recorded.h"
#include "ros/markers/marker_style.h"

namespace crowd::recorded_drawing_test {
namespace {

using social_crowd::AgentStates;
using visualization_msgs::Marker;

/// An obstacle and, if there is a velocity, a recorded person at (2, 3).
AgentStates statesWith(const std::vector<Vector2>& velocities) {
  AgentStates states;
  states.obstacles.resize(1 + velocities.size());
  states.obstacles[0].radius = 0.5;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    social_crowd::ObstacleState& person = states.obstacles[i + 1];
    person.obstacle = 1;
    person.recorded = 1;
    person.radius = 0.25;
    person.position.x = 2.0;
    person.position.y = 3.0;
    person.velocity.x = velocities[i].x();
    person.velocity.y = velocities[i].y();
  }
  return states;
}

std::vector<Marker> draw(RecordedDrawing& drawing, const AgentStates& states, bool figures) {
  visualization_msgs::MarkerArray array;
  drawing.take(states);
  drawing.draw(figures, true, array);
  return array.markers;
}

TEST(RecordedDrawing, DrawsNothingWithoutRecordedPeople) {
  RecordedDrawing drawing;
  EXPECT_TRUE(draw(drawing, statesWith({}), true).empty());
}

TEST(RecordedDrawing, PeopleAreNoObstaclesAndHaveAColourOfTheirOwn) {
  RecordedDrawing drawing;
  const AgentStates states = statesWith({{0.0, 1.0}});
  EXPECT_EQ(drawObstacles(states).points.size(), drawObstacles(statesWith({})).points.size());
  const std::vector<Marker> markers = draw(drawing, states, false);
  ASSERT_EQ(markers.size(), 2U);  // disc and arrow
  for (const Marker& marker : markers) {
    EXPECT_EQ(marker.ns, marker_style::RECORDED);
    EXPECT_EQ(marker.action, Marker::ADD);
    EXPECT_FALSE(marker.points.empty());
  }
  EXPECT_NE(markers[0].id, markers[1].id);
}

TEST(RecordedDrawing, FiguresFaceWhereTheyWalkOrWalkedLast) {
  RecordedDrawing drawing;
  for (const Vector2& velocity : {Vector2(0.0, 1.0), Vector2(0.01, 0.0)}) {
    const std::vector<Marker> markers = draw(drawing, statesWith({velocity}), true);
    ASSERT_EQ(markers.size(), 5U);
    EXPECT_EQ(markers[2].ns, marker_style::RECORDED_FIGURES);
    EXPECT_NEAR(markers[2].pose.orientation.z, std::sqrt(0.5), 1e-12);  // north
    EXPECT_EQ(markers[2].pose.position.x, 2.0);
  }
  // Who has left is deleted.
  const std::vector<Marker> markers = draw(drawing, statesWith({}), true);
  ASSERT_EQ(markers.size(), 5U);
  for (const Marker& marker : markers) EXPECT_EQ(marker.action, Marker::DELETE) << marker.ns;
  EXPECT_TRUE(draw(drawing, statesWith({}), true).empty());
}

}  // namespace
}  // namespace crowd::recorded_drawing_test
