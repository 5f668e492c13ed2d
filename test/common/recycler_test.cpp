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

TEST(Recycler, TwoAreEnoughForOneReaderBehind) {
  Recycler<Pointer> recycler;
  std::set<const std::vector<int>*> places;
  Pointer read;
  for (int i = 0; i < 100; ++i) {
    Pointer filled = recycler.next();
    filled->assign(1000, i);
    if (i > 0) {
      ASSERT_EQ(*read, std::vector<int>(1000, i - 1));
    }
    places.insert(filled.get());
    read = std::move(filled);
  }
  EXPECT_EQ(places.size(), 2U);
}

/// Counts those of its kind.
class Counted {
 public:
  Counted() { ++count; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  ~Counted() { --count; }
  static int count;
};
int Counted::count = 0;

TEST(Recycler, KeepsAFewOnlyOfManyThatWereHeld) {
  Recycler<std::shared_ptr<Counted>> recycler;
  std::vector<std::shared_ptr<Counted>> held;
  for (int i = 0; i < 20; ++i) held.push_back(recycler.next());
  EXPECT_EQ(Counted::count, 20);
  held.clear();
  EXPECT_EQ(Counted::count, 8);
}

TEST(Recycler, WhatIsHeldOutlivesIt) {
  auto recycler = std::make_unique<Recycler<std::shared_ptr<Counted>>>();
  std::shared_ptr<Counted> held = recycler->next();
  recycler->next().reset();
  recycler.reset();
  EXPECT_EQ(Counted::count, 1);
  held.reset();
  EXPECT_EQ(Counted::count, 0);
}

}  // namespace
}  // namespace crowd
