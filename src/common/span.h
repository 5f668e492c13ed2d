#pragma once

#include <cstddef>

namespace crowd {

/// @brief Read-only view of a part of an array; valid as long as the array is.
template <typename T>
class Span {
 public:
  Span(const T* first, std::size_t count) : first_(first), count_(count) {}
  const T* begin() const { return first_; }
  const T* end() const { return first_ + count_; }
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const T& operator[](std::size_t i) const { return first_[i]; }

 private:
  const T* first_;
  std::size_t count_;
};

}  // namespace crowd
