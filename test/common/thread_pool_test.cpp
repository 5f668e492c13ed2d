#include "common/thread_pool.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <string>

namespace crowd::thread_pool_test {
namespace {

TEST(ThreadPool, ProcessesEachItemOnceForAnyNumberOfThreads) {
  for (const unsigned count : {0U, 1U, 2U, 7U}) {
    SCOPED_TRACE(count);
    ThreadPool thread_pool(count);
    EXPECT_EQ(thread_pool.count(), count == 0 ? 1U : count);
    for (const std::size_t size : {0U, 1U, 5U, 1000U}) {
      std::vector<int> done(size, 0);
      for (int round = 0; round < 50; ++round) {
        thread_pool.run(size, [&](unsigned, std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) ++done[i];
        });
      }
      EXPECT_EQ(done, std::vector<int>(size, 50));
    }
  }
}

TEST(ThreadPool, DividesItemsIntoNearlyEqualPartsWithoutGaps) {
  ThreadPool thread_pool(3);
  std::mutex mutex;
  std::map<std::size_t, std::size_t> parts;
  thread_pool.run(1000, [&](unsigned worker, std::size_t begin, std::size_t end) {
    EXPECT_LT(worker, 3U);
    const std::lock_guard<std::mutex> lock(mutex);
    EXPECT_TRUE(parts.emplace(begin, end).second);
  });
  EXPECT_GT(parts.size(), 3U);
  std::size_t last = 0;
  for (const auto& [begin, end] : parts) {
    EXPECT_EQ(begin, last);
    EXPECT_GE(end - begin, 1000 / parts.size());
    EXPECT_LE(end - begin, 1000 / parts.size() + 1);
    last = end;
  }
  EXPECT_EQ(last, 1000U);
}

TEST(ThreadPool, ProcessesFewItemsOnTheCallingThread) {
  ThreadPool thread_pool(3);
  int calls = 0;
  const auto count = [&](unsigned worker, std::size_t begin, std::size_t end) {
    EXPECT_EQ(worker, 0U);
    EXPECT_EQ(begin, 0U);
    EXPECT_EQ(end, 240U);
    ++calls;
  };
  thread_pool.run(240, count, 240);
  EXPECT_EQ(calls, 1);
}

TEST(ThreadPool, OtherThreadsProcessTheRestWhileOneIsBlocked) {
  ThreadPool thread_pool(2);
  for (int round = 0; round < 20; ++round) {
    std::mutex mutex;
    std::condition_variable changed;
    std::size_t done = 0;
    bool others_came_first = false;
    thread_pool.run(100, [&](unsigned, std::size_t begin, std::size_t end) {
      std::unique_lock<std::mutex> lock(mutex);
      // The first part ends after all others.
      if (begin == 0) {
        others_came_first = changed.wait_for(lock, std::chrono::minutes(1), [&] { return done == 100 - end; });
      }
      done += end - begin;
      changed.notify_all();
    });
    ASSERT_TRUE(others_came_first) << "round " << round;
    ASSERT_EQ(done, 100U);
  }
}

TEST(ThreadPool, RethrowsTheFirstErrorAndStaysUsable) {
  ThreadPool thread_pool(4);
  const auto fail = [](unsigned, std::size_t begin, std::size_t) {
    if (begin >= 2) throw std::runtime_error("part " + std::to_string(begin));
  };
  for (int round = 0; round < 50; ++round) {
    try {
      thread_pool.run(4, fail);
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()), "part 2");
    }
    std::vector<int> done(4, 0);
    thread_pool.run(4, [&](unsigned, std::size_t begin, std::size_t) { done[begin] = 1; });
    EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 4);
  }
}

}  // namespace
}  // namespace crowd::thread_pool_test
