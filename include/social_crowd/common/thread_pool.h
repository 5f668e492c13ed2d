#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace crowd {

/// @brief A few threads that share out a piece of work, and wait in between. Who waits watches a moment for what may
/// come at once before it sleeps, unless there are more of them than the machine runs at a time.
class ThreadPool {
 public:
  /// @param count how many work side by side, the caller of run() among them; 0 counts as 1
  explicit ThreadPool(unsigned count);
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ThreadPool(ThreadPool&&) = delete;
  ThreadPool& operator=(ThreadPool&&) = delete;
  ~ThreadPool();

  /// @brief Nobody beside the caller of run(). Keeps nothing, so that any number of threads may work with it.
  static ThreadPool& callerOnly();

  unsigned count() const { return static_cast<unsigned>(threads_.size()) + 1; }

  /// @brief Whether run() would leave all to its caller.
  bool runsInCaller(std::size_t size, std::size_t few = 0) const { return size <= few || threads_.empty(); }

  /// @brief Cuts 0 .. size-1 into parts that differ by one at most, more than there are workers, and returns when all
  /// are done. Whoever has time takes the next part, so that nobody waits for one who is held up. Rethrows what a part
  /// has thrown, of several the first one; who has thrown takes no other. To be called by one thread at a time;
  /// allocates nothing.
  /// @param work called as work(worker, begin, end) for each part [begin, end), with the number of who takes it
  /// @param few up to so many are done by the caller alone, in one part, sooner than the others wake up
  template <typename Work>
  void run(std::size_t size, const Work& work, std::size_t few = 0) {
    if (runsInCaller(size, few)) {
      work(0U, std::size_t{0}, size);
    } else {
      share({[](const void* what, unsigned worker, std::size_t begin, std::size_t end) {
               (*static_cast<const Work*>(what))(worker, begin, end);
             },
             &work},
            size);
    }
  }

 private:
  /// Some callable, like std::function, but never on the heap.
  struct Task {
    void (*call)(const void*, unsigned, std::size_t, std::size_t) = nullptr;
    const void* what = nullptr;
  };
  static constexpr std::size_t PARTS_EACH = 64;

  /// What a part has thrown.
  struct Problem {
    std::size_t part = 0;
    std::exception_ptr thrown;
  };
  void share(const Task& task, std::size_t size);
  /// Waits a moment for what `happened` tells, gladly letting others run.
  template <typename Happened>
  void watch(const Happened& happened) const;
  void wait(unsigned worker);
  void doParts(unsigned worker);

  bool watches_;
  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable begun_;
  std::condition_variable done_;
  // Written under the mutex while nobody works.
  Task task_;
  std::size_t size_ = 0;
  std::size_t parts_ = 0;
  std::atomic<std::size_t> next_part_{0};
  std::vector<Problem> problems_;  // of each worker
  // All written under the mutex.
  std::atomic<std::size_t> round_{0};
  bool open_ = false;                    // whether who wakes up is still to help
  std::atomic<std::size_t> helpers_{0};  // who woke up in time and is not yet done
  bool stop_ = false;
};

}  // namespace crowd
