#pragma once

#include <cstddef>
#include <cstdint>

namespace crowd {

/// @brief Number of a row of the Q-table, from 0.
using Row = std::uint32_t;

/// @brief Number of an action within its action set, from 0.
using Action = std::uint32_t;

/// @brief The rows that a perception maps to, one per action. `stride` 0: the same row for every action.
struct Rows {
  const Row* first = nullptr;
  std::size_t stride = 0;
  Row operator[](Action action) const { return first[action * stride]; }
  /// @brief Whether all actions stand in one and the same row.
  bool isOne() const { return stride == 0; }
};

}  // namespace crowd
