#include "simulation/evaluation/state_record.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/perceptions.h"

namespace crowd::state_record_test {
namespace {

/// The thesis's state set of that type; action 2 is the best one in every row.
Learner learnerOf(const std::string& state_set, Row rows) {
  QTable table(rows, 8);
  for (Row row = 0; row < rows; ++row) table.set(row, 2, 1.0, 1);
  const std::string cost = state_set == "occupancy" ? "10" : "80";
  return {parseModel("{state_set: {type: " + state_set +
                     "}, action_set: {type: kings_moves}, reward: {goal: cosine_cubed, obstacle_cost: " + cost + "}}"),
          Learner::Options(), table};
}

/// At tick 4 an agent whose goal lies ahead, and a disc of radius 0.3 that is 0.7 m ahead.
PerceptionsBuilder agentBeforeADisc() {
  return PerceptionsBuilder(3, 4).agent(6, {5.0, 0.0}).neighbour({0.7, 0.0}, 0.3);
}

TEST(StateRecord, WritesStatesOfSet2) {
  std::string rows;
  appendStateRows(1, agentBeforeADisc().all(), learnerOf("occupancy", 52489), rows);
  // Class 1 ahead, class 2 on either side: 3^7 + 2 * 3^6 + 2 = 2187 + 1458 + 2.
  EXPECT_EQ(rows, "1,4,6,0,0,0,3647,2,-22.5:22.5:1 22.5:67.5:2 292.5:337.5:2\n");
}

TEST(StateRecord, WritesStatesOfSet1) {
  std::string rows;
  appendStateRows(1, agentBeforeADisc().all(), learnerOf("nearest_obstacle", 137), rows);
  // (3.3): goal sector 0, obstacle sector 0, class 1: (8 - 1) + 0 + 0 + 1.
  EXPECT_EQ(rows, "1,4,6,0,0,0,8,2,0:15:1\n");
}

TEST(StateRecord, WritesNoSectorsWithoutObstacles) {
  std::string rows;
  appendStateRows(0, PerceptionsBuilder(0, 0).agent(0, {-5.0, 0.0}).all(), learnerOf("nearest_obstacle", 137), rows);
  EXPECT_EQ(rows, "0,0,0,0,0,0,4,2,\n");
}

TEST(StateRecord, HeaderNamesEveryField) {
  std::string rows;
  appendStateRows(1, agentBeforeADisc().all(), learnerOf("occupancy", 52489), rows);
  const std::string header = STATE_RECORD_HEADER;
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(rows.begin(), rows.end(), ','));
}

}  // namespace
}  // namespace crowd::state_record_test
