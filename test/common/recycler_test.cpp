#include "social_crowd/common/recycler.h"

#include <gtest/gtest.h>

#include <memory>
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

}  // namespace
}  // namespace crowd
