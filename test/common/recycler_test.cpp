#include "social_crowd/common/recycler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace crowd {
namespace {

using Pointer = std::shared_ptr<std::vector<int>>;

TEST(Recycler, GivesTheSameAgainOnceItIsFree) {
  Recycler<Pointer> recycler;
  Pointer held = recycler.next();
  held->assign(100, 7);
  const std::vector<int>* const first = held.get();
  EXPECT_NE(recycler.next().get(), first);
  held.reset();
  const Pointer again = recycler.next();
  EXPECT_EQ(again.get(), first);
  EXPECT_EQ(*again, std::vector<int>(100, 7)) << "what was in it stays, and so does its memory";
}

TEST(Recycler, NeverGivesWhatSomebodyHolds) {
  Recycler<Pointer> recycler;
  std::vector<Pointer> held;
  for (int i = 0; i < 100; ++i) {
    held.push_back(recycler.next());
    held.back()->assign(1, i);
  }
  for (int i = 0; i < 100; ++i) EXPECT_EQ(held[static_cast<std::size_t>(i)]->front(), i);
}

TEST(Recycler, TakesBackWhatAnotherThreadHasRead) {
  Recycler<Pointer> recycler;
  for (int i = 0; i < 200; ++i) {
    Pointer filled = recycler.next();
    const std::vector<int>* const place = filled.get();
    filled->assign(1000, i);
    int sum = 0;
    std::thread reader([read = std::move(filled), &sum]() mutable {
      for (const int number : *read) sum += number;
      read.reset();
    });
    Pointer again = recycler.next();
    while (again.get() != place) {
      again.reset();
      again = recycler.next();
    }
    again->assign(1000, -1);  // too early if the thread still reads
    reader.join();
    EXPECT_EQ(sum, 1000 * i);
  }
}

TEST(RecyclerRenew, FillsWhatIsEmpty) {
  Recycler<Pointer> recycler;
  Pointer held;
  recycler.renew(held);
  ASSERT_NE(held, nullptr);
  EXPECT_TRUE(held->empty());
}

TEST(RecyclerRenew, LeavesWhatNobodyElseHolds) {
  Recycler<Pointer> recycler;
  Pointer held;
  recycler.renew(held);
  held->assign(100, 7);
  const std::vector<int>* const first = held.get();
  for (int i = 0; i < 10; ++i) {
    recycler.renew(held);
    ASSERT_EQ(held.get(), first);
  }
  EXPECT_EQ(*held, std::vector<int>(100, 7));
  const Pointer other = held;
  recycler.renew(held);
  const std::vector<int>* const second = held.get();
  EXPECT_NE(second, first);
  recycler.renew(held);
  EXPECT_EQ(held.get(), second);
}

TEST(RecyclerRenew, NeverGivesWhatSomebodyElseHolds) {
  Recycler<Pointer> recycler;
  std::vector<Pointer> others;  // more than are kept for later
  Pointer held;
  for (int i = 0; i < 100; ++i) {
    recycler.renew(held);
    held->assign(1, i);
    others.push_back(held);
  }
  for (int i = 0; i < 100; ++i) EXPECT_EQ(others[static_cast<std::size_t>(i)]->front(), i);
}

TEST(RecyclerRenew, TwoAreEnoughForOneReaderBehind) {
  Recycler<Pointer> recycler;
  std::set<const std::vector<int>*> places;
  Pointer held;
  Pointer read;
  for (int i = 0; i < 100; ++i) {
    recycler.renew(held);
    held->assign(1000, i);
    if (i > 0) {
      ASSERT_EQ(*read, std::vector<int>(1000, i - 1));
    }
    read = held;
    places.insert(held.get());
  }
  EXPECT_EQ(places.size(), 2U);
}

TEST(RecyclerRenew, DoesNotKeepWhatIsHeldNoMore) {
  Recycler<Pointer> recycler;
  Pointer held;
  std::vector<std::weak_ptr<std::vector<int>>> all;
  std::vector<Pointer> others;
  for (int i = 0; i < 20; ++i) {
    recycler.renew(held);
    others.push_back(held);
    all.emplace_back(held);
  }
  others.clear();
  recycler.renew(held);
  const auto alive = [](const std::weak_ptr<std::vector<int>>& one) { return !one.expired(); };
  EXPECT_EQ(std::count_if(all.begin(), all.end(), alive), 8);  // as many as are kept for later
}

TEST(RecyclerRenew, WaitsForAReaderInAnotherThread) {
  Recycler<Pointer> recycler;
  Pointer held;
  for (int i = 0; i < 200; ++i) {
    recycler.renew(held);
    held->assign(1000, i);
    int sum = 0;
    std::thread reader([read = held, &sum]() mutable {
      for (const int number : *read) sum += number;
      read.reset();
    });
    recycler.renew(held);  // the same only if it has been read
    held->assign(1000, -1);
    reader.join();
    ASSERT_EQ(sum, 1000 * i);
  }
}

}  // namespace
}  // namespace crowd
