#include "common/object_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace crowd::object_pool_test {
namespace {

using Pointer = std::shared_ptr<std::vector<int>>;

TEST(ObjectPool, ReusesAReleasedObject) {
  ObjectPool<Pointer> pool;
  Pointer held = pool.next();
  held->assign(100, 7);
  const std::vector<int>* const first = held.get();
  const Pointer other = pool.next();
  EXPECT_NE(other.get(), first);
  held.reset();
  const Pointer again = pool.next();
  EXPECT_EQ(again.get(), first);
  EXPECT_EQ(*again, std::vector<int>(100, 7)) << "what was in it stays, and so does its memory";
}

TEST(ObjectPool, DoesNotReuseAHeldObject) {
  ObjectPool<Pointer> pool;
  std::vector<Pointer> held;
  for (int i = 0; i < 100; ++i) {
    held.push_back(pool.next());
    held.back()->assign(1, i);
  }
  for (int i = 0; i < 100; ++i) EXPECT_EQ(held[static_cast<std::size_t>(i)]->front(), i);
}

TEST(ObjectPool, ReusesAnObjectReleasedByAnotherThread) {
  ObjectPool<Pointer> pool;
  for (int i = 0; i < 200; ++i) {
    Pointer filled = pool.next();
    const std::vector<int>* const place = filled.get();
    filled->assign(1000, i);
    int sum = 0;
    std::thread reader([read = std::move(filled), &sum]() mutable {
      for (const int number : *read) sum += number;
      read.reset();
    });
    Pointer again = pool.next();
    while (again.get() != place) {
      again.reset();
      std::this_thread::yield();
      again = pool.next();
    }
    again->assign(1000, -1);  // an error if the thread still reads
    reader.join();
    EXPECT_EQ(sum, 1000 * i);
  }
}

TEST(ObjectPool, NeedsTwoObjectsForAReaderOneStepBehind) {
  ObjectPool<Pointer> pool;
  std::set<const std::vector<int>*> places;
  Pointer read;
  for (int i = 0; i < 100; ++i) {
    Pointer filled = pool.next();
    filled->assign(1000, i);
    if (i > 0) {
      ASSERT_EQ(*read, std::vector<int>(1000, i - 1));
    }
    places.insert(filled.get());
    read = std::move(filled);
  }
  EXPECT_EQ(places.size(), 2U);
}

/// Counts its instances.
class Counted {
 public:
  Counted() { ++count; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  ~Counted() { --count; }
  static int count;
};
int Counted::count = 0;

TEST(ObjectPool, KeepsAtMostEightReleasedObjects) {
  ObjectPool<std::shared_ptr<Counted>> pool;
  std::vector<std::shared_ptr<Counted>> held;
  for (int i = 0; i < 20; ++i) held.push_back(pool.next());
  EXPECT_EQ(Counted::count, 20);
  held.clear();
  EXPECT_EQ(Counted::count, 8);
}

TEST(ObjectPool, HeldObjectsOutliveThePool) {
  auto pool = std::make_unique<ObjectPool<std::shared_ptr<Counted>>>();
  std::shared_ptr<Counted> held = pool->next();
  pool->next().reset();
  pool.reset();
  EXPECT_GE(Counted::count, 1);
  held.reset();
  EXPECT_EQ(Counted::count, 0);
}

}  // namespace
}  // namespace crowd::object_pool_test
