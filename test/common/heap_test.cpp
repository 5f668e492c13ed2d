#include "common/heap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/random.h"

namespace crowd {
namespace {

using Element = std::pair<std::uint32_t, std::uint32_t>;  // key, number

bool isBelow(const Element& a, const Element& b) { return a.first > b.first; }

/// Adds and removes elements with few keys; returns those that leave.
template <typename Push, typename Pop>
std::vector<Element> leaving(std::uint64_t seed, const Push& push, const Pop& pop) {
  KeyedRandom random(seed, KeyedRandom::CONTENT, {});
  std::vector<Element> heap;
  std::vector<Element> left;
  for (std::uint32_t number = 0; number < 400; ++number) {
    push(heap, Element{random.below(6), number});
    while (!heap.empty() && random.below(number < 300 ? 3 : 1) == 0) left.push_back(pop(heap));
  }
  return left;
}

std::vector<Element> leavingOurs(std::uint64_t seed) {
  return leaving(
      seed, [](auto& heap, const Element& element) { pushHeap(heap, element, isBelow); },
      [](auto& heap) { return popHeap(heap, isBelow); });
}

TEST(Heap, FirstElementsLeaveFirst) {
  std::vector<Element> heap;
  for (const std::uint32_t key : {5, 3, 8, 1, 9, 2, 7}) pushHeap(heap, {key, 0}, isBelow);
  for (const std::uint32_t key : {1, 2, 3, 5, 7, 8, 9}) EXPECT_EQ(popHeap(heap, isBelow).first, key);
  EXPECT_TRUE(heap.empty());
}

TEST(Heap, EqualElementsLeaveInOneOrder) {
  EXPECT_EQ(leavingOurs(1).size(), 400U);
#ifdef __GLIBCXX__  // whose order it was when results were first recorded
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const std::vector<Element> expected = leaving(
        seed,
        [](auto& heap, const Element& element) {
          heap.push_back(element);
          std::push_heap(heap.begin(), heap.end(), isBelow);
        },
        [](auto& heap) {
          std::pop_heap(heap.begin(), heap.end(), isBelow);
          const Element first = heap.back();
          heap.pop_back();
          return first;
        });
    EXPECT_EQ(leavingOurs(seed), expected);
  }
#endif
}

}  // namespace
}  // namespace crowd
