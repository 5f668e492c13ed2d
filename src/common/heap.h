#pragma once

#include <cstddef>
#include <vector>

namespace crowd {

/// Binary heaps of which equal elements leave in the same order with all standard libraries: std::pop_heap() orders
/// them as each library likes, and an order of impacts decides where bodies come to rest.

/// @brief Moves `element` up from `place`, of which the value is overwritten. @param is_below whether the first of two
/// elements is to leave after the second one
template <typename Element, typename IsBelow>
void siftUp(std::vector<Element>& heap, std::size_t place, const Element& element, const IsBelow& is_below) {
  for (; place > 0 && is_below(heap[(place - 1) / 2], element); place = (place - 1) / 2)
    heap[place] = heap[(place - 1) / 2];
  heap[place] = element;
}

/// @brief Adds an element.
template <typename Element, typename IsBelow>
void pushHeap(std::vector<Element>& heap, const Element& element, const IsBelow& is_below) {
  heap.push_back(element);
  siftUp(heap, heap.size() - 1, element, is_below);
}

/// @brief Removes and returns the first element; there must be one.
template <typename Element, typename IsBelow>
Element popHeap(std::vector<Element>& heap, const IsBelow& is_below) {
  const Element first = heap.front();
  const Element last = heap.back();
  heap.pop_back();
  if (heap.empty()) return first;
  // The gap moves down to a leaf, which takes about half the comparisons, as the last element belongs near the bottom.
  std::size_t gap = 0;
  for (std::size_t child = 2; child <= heap.size(); child = 2 * gap + 2) {
    if (child == heap.size() || is_below(heap[child], heap[child - 1])) --child;
    heap[gap] = heap[child];
    gap = child;
  }
  siftUp(heap, gap, last, is_below);
  return first;
}

}  // namespace crowd
