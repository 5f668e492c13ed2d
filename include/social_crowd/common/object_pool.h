#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace crowd {

/// @brief Hands out objects to fill, preferably those that were handed out before and that nobody holds any more, so
/// that large buffers are not allocated again and again. What is in them from before stays.
/// @tparam Pointer a shared pointer; any thread may hold copies, also when the pool is gone
template <typename Pointer>
class ObjectPool {
 public:
  /// @brief An object that nobody else holds, a new one if there is none. Any thread may call this.
  Pointer next() { return Pointer(free_->take().release(), GiveBack{free_}); }

 private:
  using Object = typename Pointer::element_type;
  static constexpr std::size_t MAX_FREE = 8;  // that are kept for later

  /// Objects that nobody holds.
  class FreeList {
   public:
    FreeList() { objects_.reserve(MAX_FREE); }
    std::unique_ptr<Object> take() {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (objects_.empty()) return std::make_unique<Object>();
      std::unique_ptr<Object> longest_free = std::move(objects_.front());
      objects_.erase(objects_.begin());
      return longest_free;
    }
    void put(std::unique_ptr<Object> object) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (objects_.size() < MAX_FREE) objects_.push_back(std::move(object));
    }

   private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Object>> objects_;
  };

  /// What a pointer does with its object when nobody holds it any more.
  struct GiveBack {
    std::shared_ptr<FreeList> free;
    void operator()(Object* object) const { free->put(std::unique_ptr<Object>(object)); }
  };

  std::shared_ptr<FreeList> free_ = std::make_shared<FreeList>();
};

}  // namespace crowd
