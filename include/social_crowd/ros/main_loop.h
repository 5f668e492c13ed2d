#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <utility>

#include "social_crowd/common/errors.h"

namespace crowd {

/// @brief The one thread that owns a node's state: callbacks of its subscriptions run here, and whatever service
/// threads ask for, one at a time. So nothing else needs a lock.
///
/// It goes on until ROS shuts down, its owner has nothing left to do, or another thread closes it.
class MainLoop {
 public:
  /// @brief The same node handle, with all its callbacks served here.
  ros::NodeHandle adopt(ros::NodeHandle node) {
    node.setCallbackQueue(&queue_);
    return node;
  }

  /// @brief Waits for something to do, at most so long, then does all there is.
  void run(const ros::WallDuration& wait) { queue_.callAvailable(wait); }

  /// @brief Ends it, also from another thread: what is under way comes to its end, who asks for more is told so.
  void close() { closed_ = true; }
  bool isClosed() const { return closed_ || !ros::ok(); }

  /// @brief From another thread: runs `task` in the main loop and returns what it returns, or throws what it throws.
  /// @throws Error if the node shuts down before.
  template <typename Result>
  Result ask(std::function<Result()> task) {
    auto job = boost::make_shared<Job<Result>>(std::move(task));
    std::future<Result> result = job->result();
    queue_.addCallback(job);
    while (result.wait_for(PATIENCE) != std::future_status::ready) {
      if (isClosed() && job->cancel()) throw Error("the node is shutting down");
    }
    return result.get();
  }

 private:
  static constexpr std::chrono::milliseconds PATIENCE{100};

  template <typename Result>
  class Job : public ros::CallbackInterface {
   public:
    explicit Job(std::function<Result()> task) : task_(std::move(task)) {}
    std::future<Result> result() { return task_.get_future(); }

    CallResult call() override {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!cancelled_) task_();
      done_ = true;
      return Success;
    }

    /// Whoever asked is gone, so the task must not run any more; false if it has run already.
    bool cancel() {
      const std::lock_guard<std::mutex> lock(mutex_);
      cancelled_ = !done_;
      return cancelled_;
    }

   private:
    std::packaged_task<Result()> task_;
    std::mutex mutex_;
    bool cancelled_ = false;
    bool done_ = false;
  };

  ros::CallbackQueue queue_;
  std::atomic<bool> closed_{false};
};

}  // namespace crowd
