#include "social_crowd/common/workers.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <string>

namespace crowd {
namespace {

TEST(Workers, DoEverythingOnceWhateverTheirNumber) {
  for (const unsigned count : {0U, 1U, 2U, 7U}) {
    SCOPED_TRACE(count);
    Workers workers(count);
    EXPECT_EQ(workers.count(), count == 0 ? 1U : count);
    for (const std::size_t size : {0U, 1U, 5U, 1000U}) {
      std::vector<int> done(size, 0);
      for (int round = 0; round < 50; ++round) {
        workers.run(size, [&](unsigned, std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) ++done[i];
        });
      }
      EXPECT_EQ(done, std::vector<int>(size, 50));
    }
  }
}

TEST(Workers, PartsAreEqualAndInOrder) {
  Workers workers(3);
  std::vector<std::size_t> ends(3);
  workers.run(9, [&](unsigned worker, std::size_t begin, std::size_t end) {
    EXPECT_EQ(begin, 3U * worker);
    ends[worker] = end;
  });
  EXPECT_EQ(ends, (std::vector<std::size_t>{3, 6, 9}));
}

TEST(Workers, HandOverTheFirstProblemAndGoOn) {
  Workers workers(4);
  const auto fail = [](unsigned worker, std::size_t, std::size_t) {
    if (worker >= 2) throw std::runtime_error("worker " + std::to_string(worker));
  };
  try {
    workers.run(4, fail);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "worker 2");
  }
  std::vector<int> done(4, 0);
  workers.run(4, [&](unsigned worker, std::size_t, std::size_t) { done[worker] = 1; });
  EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 4);
}

}  // namespace
}  // namespace crowd
