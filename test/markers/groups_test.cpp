// Lines between people who walk together.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ros/markers/marker_groups.h"
#include "ros/markers/marker_style.h"

namespace crowd::groups_drawing_test {
namespace {

using visualization_msgs::Marker;

social_crowd::AgentState person(std::uint32_t agent, std::uint32_t group, double x, double y = 0.0) {
  social_crowd::AgentState state;
  state.agent = agent;
  state.group = group;
  state.pose.x = x;
  state.pose.y = y;
  state.radius = 0.2;
  return state;
}

Marker draw(const std::vector<social_crowd::AgentState>& people) {
  social_crowd::AgentStates states;
  states.agents = people;
  return drawGroups(states);
}

/// Sum of the lengths of the lines [m].
double lengthOf(const Marker& marker) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < marker.points.size(); i += 2) {
    length += std::hypot(marker.points[i + 1].x - marker.points[i].x, marker.points[i + 1].y - marker.points[i].y);
  }
  return length;
}

TEST(GroupsDrawing, PeopleAloneHaveNoLines) {
  EXPECT_EQ(draw({person(0, 0, 0.0), person(1, 0, 1.0), person(2, 3, 2.0)}).action, Marker::DELETE);
}

TEST(GroupsDrawing, MatesAreJoinedByTheShortestLines) {
  // From left to right at 0, 1, 2 and 4 m, in another order, and a group beside them.
  const Marker marker = draw({person(0, 1, 4.0), person(1, 1, 0.0), person(2, 1, 2.0), person(3, 1, 1.0),
                              person(4, 5, 0.0, 7.0), person(5, 5, 0.0, 7.5)});
  EXPECT_EQ(marker.ns, marker_style::GROUPS);
  EXPECT_EQ(marker.action, Marker::ADD);
  EXPECT_EQ(marker.points.size(), 2U * 4U);
  EXPECT_NEAR(lengthOf(marker), 4.0 + 0.5, 1e-12);
}

TEST(GroupsDrawing, WhoHasLeftIsNotJoined) {
  std::vector<social_crowd::AgentState> people = {person(0, 1, 0.0), person(1, 1, 1.0), person(2, 1, 2.0)};
  people[1].status = social_crowd::AgentState::ARRIVED;
  const Marker marker = draw(people);
  EXPECT_EQ(marker.points.size(), 2U);
  EXPECT_NEAR(lengthOf(marker), 2.0, 1e-12);
}

}  // namespace
}  // namespace crowd::groups_drawing_test
