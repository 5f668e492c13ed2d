#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

namespace crowd {

/// @brief Hands out objects to fill, one of those again that nobody else holds any more, so that large buffers are not
/// allocated again and again. What is in them from before stays.
/// @tparam Pointer a shared pointer that tells its use_count(); whoever holds a copy may be in another thread
template <typename Pointer>
class Recycler {
 public:
  /// @brief Another object in place of the one that is held, or that one again, if nobody else holds it.
  void renew(Pointer& held) {
    constexpr long BY_BOTH = 2;
    if (!spares_.empty() && held == spares_.front() && held.use_count() == BY_BOTH) {
      std::atomic_thread_fence(std::memory_order_acquire);  // as in next()
      return;
    }
    held.reset();
    held = next();
  }

  /// @brief An object that nobody else holds, a new one if there is none.
  Pointer next() {
    for (const Pointer& spare : spares_) {
      if (spare.use_count() > 1) continue;
      // All that its last holder did, in whichever thread, comes before what is done now.
      std::atomic_thread_fence(std::memory_order_acquire);
      return spare;
    }
    Pointer fresh(new typename Pointer::element_type());
    if (spares_.size() < MOST) spares_.push_back(fresh);
    return fresh;
  }

 private:
  static constexpr std::size_t MOST = 8;  // who holds more than these is not in a hurry

  std::vector<Pointer> spares_;
};

}  // namespace crowd
