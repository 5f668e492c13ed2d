#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace crowd {

/// @brief Pool of reusable objects, so that large buffers are not allocated repeatedly. A reused object keeps its
/// previous content.
/// @tparam Pointer a shared pointer; any thread may hold copies, also after the pool is destroyed
template <typename Pointer>
class ObjectPool {
 public:
  /// @brief Returns an object without other owners: the one that has been free for longest, or a new one. Thread-safe.
  Pointer next() { return Pointer(free_->take().release(), GiveBack{free_}); }

 private:
  using Object = typename Pointer::element_type;
  static constexpr std::size_t MAX_FREE = 8;  // free objects that are kept

  /// Objects without an owner.
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

  /// Deleter of the pointers: returns the object to the free list.
  struct GiveBack {
    std::shared_ptr<FreeList> free;
    void operator()(Object* object) const { free->put(std::unique_ptr<Object>(object)); }
  };

  std::shared_ptr<FreeList> free_ = std::make_shared<FreeList>();
};

}  // namespace crowd
