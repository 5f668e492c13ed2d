#pragma once

#include <cstddef>
#include <cstdint>

namespace crowd {

/// @brief Index of a row of the Q-table, from 0.
using Row = std::uint32_t;

/// @brief Index of an action in its action set, from 0.
using Action = std::uint32_t;

/// @brief View of the rows that a perception maps to, one per action. `stride` 0: the same row for every action. Valid
/// as long as the array that `first` points to.
struct Rows {
  const Row* first = nullptr;
  std::size_t stride = 0;
  Row operator[](Action action) const { return first[action * stride]; }
  /// @brief Whether all actions have the same row.
  bool isOne() const { return stride == 0; }
};

}  // namespace crowd
