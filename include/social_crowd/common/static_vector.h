#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <type_traits>

namespace crowd {

/// @brief Vector with a fixed capacity and inline storage; elements are constructed in place.
template <typename T, std::size_t CAPACITY>
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): zeroing unused elements takes time
class StaticVector {
  static_assert(std::is_trivially_destructible<T>::value, "destructors of elements are not called");

 public:
  std::size_t size() const { return size_; }
  bool isFull() const { return size_ == CAPACITY; }
  void clear() { size_ = 0; }
  /// @brief Appends T{parts...}; the vector must not be full.
  template <typename... Parts>
  void add(const Parts&... parts) {
    new (&places_[size_++]) T{parts...};
  }

  /// @brief Removes the last element unless `keep`, without a branch.
  void keepLastIf(bool keep) { size_ -= keep ? 0 : 1; }

  const T* data() const { return reinterpret_cast<const T*>(places_.data()); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  const T& operator[](std::size_t i) const { return data()[i]; }

 private:
  std::array<std::aligned_storage_t<sizeof(T), alignof(T)>, CAPACITY> places_;  // only the first `size_` are valid
  std::size_t size_ = 0;
};

}  // namespace crowd
