#include "social_crowd/learning/agent_places.h"

#include <gtest/gtest.h>

namespace crowd {
namespace {

TEST(AgentPlaces, AreGivenInTheOrderOfMeeting) {
  AgentPlaces places;
  const std::vector<AgentId> agents = {7, 0, UINT32_MAX, 1U << 20U, (1U << 20U) - 1, 3};
  for (std::uint32_t i = 0; i < agents.size(); ++i) EXPECT_EQ(places.add(agents[i]), i);
  for (std::uint32_t i = 0; i < agents.size(); ++i) EXPECT_EQ(places.find(agents[i]), i);
  EXPECT_EQ(places.agents(), agents);
}

TEST(AgentPlaces, AreNoneForWhoWasNotMet) {
  AgentPlaces places;
  places.add(5);
  places.add(UINT32_MAX);
  for (const AgentId stranger : {0U, 4U, 6U, UINT32_MAX - 1}) EXPECT_EQ(places.find(stranger), AgentPlaces::NONE);
  EXPECT_EQ(places.find(5), 0U);
  EXPECT_EQ(places.find(UINT32_MAX), 1U);
  EXPECT_EQ(places.agents().size(), 2U);
}

}  // namespace
}  // namespace crowd
