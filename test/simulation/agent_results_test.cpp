#include "simulation/agent_results.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace crowd::agent_results_test {
namespace {

constexpr std::size_t AGENTS = 5000;  // more than are held in memory

AgentResult resultOf(std::size_t agent) {
  AgentResult result;
  result.arrived = agent % 2 == 0;
  result.collided = agent % 3 == 0;
  result.ticks = agent;
  result.start_x = 0.1 * static_cast<double>(agent);
  result.start_y = -1.0;
  result.path_per_gain = 1.0 / static_cast<double>(agent + 3);
  return result;
}

void expectResult(const AgentResult& result, std::size_t agent) {
  const AgentResult expected = resultOf(agent);
  ASSERT_EQ(result.arrived, expected.arrived) << agent;
  ASSERT_EQ(result.collided, expected.collided) << agent;
  ASSERT_EQ(result.ticks, expected.ticks) << agent;
  ASSERT_EQ(result.start_x, expected.start_x) << agent;
  ASSERT_EQ(result.start_y, expected.start_y) << agent;
  ASSERT_EQ(result.path_per_gain, expected.path_per_gain) << agent;
}

/// Agents 0 and 1 stay; the others leave in pairs, the second one first.
AgentResults resultsOfMany() {
  AgentResults results;
  for (std::size_t agent = 2; agent < AGENTS; agent += 2) {
    for (const std::size_t leaves : {agent + 1, agent}) {
      results.add(static_cast<AgentId>(leaves)) = resultOf(leaves);
      results.storeIfMany();
    }
  }
  return results;
}

TEST(AgentResults, AreThoseThatWereAdded) {
  AgentResults results = resultsOfMany();
  for (const AgentId agent : {0U, 1U}) results.add(agent) = resultOf(agent);
  ASSERT_EQ(results.size(), AGENTS);
  std::size_t agent = 0;
  for (const AgentResult& result : results) expectResult(result, agent++);
  EXPECT_EQ(agent, AGENTS);
  expectResult(results.at(AGENTS - 1), AGENTS - 1);
  EXPECT_THROW(results.at(AGENTS), std::out_of_range);
}

/// A result of an agent that is on its way does not change when the agent leaves.
TEST(AgentResults, CopiesStayAsTheyAre) {
  AgentResults results = resultsOfMany();
  AgentResults early = results;
  early.add(0).ticks = 77;
  early.add(1).ticks = 78;
  for (std::size_t agent = 0; agent < 2 * AGENTS; ++agent) {
    if (agent < 2 || agent >= AGENTS) results.add(static_cast<AgentId>(agent)) = resultOf(agent);
    results.storeIfMany();
  }
  EXPECT_EQ(early.size(), AGENTS);
  EXPECT_EQ(early[0].ticks, 77U);
  EXPECT_EQ(early[1].ticks, 78U);
  for (std::size_t agent = 2; agent < AGENTS; ++agent) expectResult(early[agent], agent);
  for (std::size_t agent = 0; agent < 2 * AGENTS; ++agent) expectResult(results[agent], agent);
}

TEST(AgentResults, OfAList) {
  AgentResults results{resultOf(0), resultOf(1)};
  EXPECT_EQ(results.size(), 2U);
  expectResult(results[1], 1);
  EXPECT_TRUE(AgentResults().empty());
}

}  // namespace
}  // namespace crowd::agent_results_test
