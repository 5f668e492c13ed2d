#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <utility>

#include "social_crowd/errors.h"

namespace crowd {

/// @brief The thread that owns the state of a node. Callbacks of subscriptions and tasks of service threads run in it
/// one after the other, so that the state needs no lock. It ends when ROS shuts down or close() is called.
class MainLoop {
 public:
  /// @brief Returns the node handle with the callback queue of this loop.
  ros::NodeHandle adopt(ros::NodeHandle node) {
    node.setCallbackQueue(&queue_);
    return node;
  }

  /// @brief Waits for callbacks, at most `wait`, and calls all that are available.
  void run(const ros::WallDuration& wait) { queue_.callAvailable(wait); }

  /// @brief Ends the loop: the present callback is completed, later calls of ask() throw. Thread-safe.
  void close() { closed_ = true; }
  bool isClosed() const { return closed_ || !ros::ok(); }

  /// @brief Runs `task` in the main loop and returns its result or throws its exception. Must be called in another
  /// thread. @throws Error if the node shuts down first
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

    /// Prevents the task from running later; false if it has already run.
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
