#include "training/record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

namespace crowd::record_test {
namespace {

/// Different numbers that are exact in binary.
AgentResult walked() {
  AgentResult agent;
  agent.arrived = true;
  agent.collided = true;
  agent.blocked_moves = 3;
  agent.ticks = 8;
  agent.path_length = 4.0;
  agent.path_ratio = 1.25;
  agent.time_ratio = 1.5;
  agent.turn_per_metre = 0.75;
  agent.distance_gained = 3.5;
  agent.gain_per_tick = 0.4375;
  agent.path_per_gain = 1.125;
  return agent;
}

std::string rowsOf(const std::string& scenario, std::vector<AgentResult> agents) {
  EpisodeResult result;
  result.scenario = scenario;
  result.agents = std::move(agents);
  std::string rows;
  appendRecordRows(41, result, rows);
  return rows;
}

TEST(Record, HasOneRowPerAgent) {
  AgentResult lost;
  lost.touched = true;
  lost.ticks = 20;
  lost.path_per_gain = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(rowsOf("pair", {walked(), lost}),
            "41,pair,0,1,0,1,3,8,4,1.25,1.5,0.75,3.5,0.4375,1.125\n"
            "41,pair,1,0,1,0,0,20,0,0,0,0,0,0,nan\n");
}

TEST(Record, HeaderNamesEveryField) {
  const std::string header = recordHeader();
  const std::string row = rowsOf("pair", {walked()});
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(row.begin(), row.end(), ','));
  EXPECT_EQ(header.back(), '\n');
}

TEST(Record, OmitsRemovedAgents) {
  AgentResult removed = walked();
  removed.removed = true;
  EXPECT_EQ(rowsOf("pair", {removed, walked()}), "41,pair,1,1,0,1,3,8,4,1.25,1.5,0.75,3.5,0.4375,1.125\n");
}

TEST(Record, QuotesNamesWithCommas) {
  EXPECT_EQ(rowsOf("a \"wide\", long door", {walked()}),
            "41,\"a \"\"wide\"\", long door\",0,1,0,1,3,8,4,1.25,1.5,0.75,3.5,0.4375,1.125\n");
}

TEST(Log, HasOneRowPerEpisode) {
  AgentResult removed = walked();
  removed.removed = true;
  AgentResult lost;
  lost.touched = true;
  LearnedEpisode learned;
  learned.scenario = "a, b";
  learned.agents = {walked(), lost, removed, lost, walked()};
  learned.decisions = 56;
  learned.reward = -0.1;
  learned.epsilon = 0.25;
  learned.visited_rows = 12;
  std::string rows;
  appendLogRow(7, learned, rows);
  EXPECT_EQ(rows, "7,\"a, b\",4,0.5,0.5,0.5,-0.1,12,0.25,56\n");
  const std::string header = LOG_HEADER;
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), 9);
}

TEST(Log, OfAgentsThatAreNotExpectedToArrive) {
  AgentResult endless;
  endless.endless = true;
  LearnedEpisode learned;
  learned.scenario = "s";
  learned.agents = {endless};
  std::string rows;
  appendLogRow(0, learned, rows);
  learned.agents = {};
  learned.reward = std::numeric_limits<double>::quiet_NaN();
  appendLogRow(1, learned, rows);
  EXPECT_EQ(rows, "0,s,1,1,0,0,0,0,0,0\n1,s,0,nan,nan,nan,nan,0,0,0\n");
}

}  // namespace
}  // namespace crowd::record_test
