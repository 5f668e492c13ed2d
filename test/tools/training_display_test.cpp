#include "tools/terminal/training_display.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "training/record.h"

namespace crowd::training_display_test {
namespace {

/// An episode of agents of which the first ones arrive, and the last ones are on routes that repeat.
EpisodeResult episode(std::size_t count, std::size_t arrived, std::size_t endless) {
  std::vector<AgentResult> agents(count);
  for (std::size_t i = 0; i < arrived; ++i) agents[i].arrived = true;
  for (std::size_t i = count - endless; i < count; ++i) agents[i].endless = true;
  EpisodeResult result;
  result.agents = std::move(agents);
  return result;
}

TEST(RecentRates, AreMeansOfTheSharesInTheLog) {
  RecentRates rates;
  EXPECT_EQ(rates.text(), "success   0.0 %  contact   0.0 %");
  EpisodeResult half = episode(4, 1, 2);  // one of two is to arrive and does not
  half.agents.add(0).touched = true;
  EXPECT_EQ(successShare(half), 0.5);
  EXPECT_EQ(contactShare(half), 0.25);
  rates.add(half);
  EXPECT_EQ(rates.text(), "success  50.0 %  contact  25.0 %");
  rates.add(episode(3, 0, 3));  // none is expected to arrive
  EXPECT_EQ(rates.text(), "success  75.0 %  contact  12.5 %");
  rates.add(episode(0, 0, 0));  // without agents there is no share
  EXPECT_EQ(rates.text(), "success  75.0 %  contact  12.5 %");
}

}  // namespace
}  // namespace crowd::training_display_test
