#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <type_traits>

namespace crowd {

/// @brief A list of no more than MOST things, which stand in itself and are made where they stay.
template <typename T, std::size_t MOST>
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): to zero what is not yet there takes time
class StaticVector {
  static_assert(std::is_trivially_destructible<T>::value, "nobody takes down what is left out");

 public:
  std::size_t size() const { return size_; }
  bool isFull() const { return size_ == MOST; }
  void clear() { size_ = 0; }
  /// @brief Adds a thing; the list must not be full.
  template <typename... Parts>
  void add(const Parts&... parts) {
    new (&places_[size_++]) T{parts...};
  }

  /// @brief Takes the last one away again if it is not to stay; no branch depends on that.
  void keepLastIf(bool keep) { size_ -= keep ? 0 : 1; }

  const T* data() const { return reinterpret_cast<const T*>(places_.data()); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  const T& operator[](std::size_t i) const { return data()[i]; }

 private:
  std::array<std::aligned_storage_t<sizeof(T), alignof(T)>, MOST> places_;  // only the first `size_` mean anything
  std::size_t size_ = 0;
};

}  // namespace crowd
