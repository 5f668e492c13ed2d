#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace crowd {

/// @brief Fixed set of threads that execute parallel loops. Idle workers spin briefly, then block; they block at once
/// if there are more workers than hardware threads.
class ThreadPool {
 public:
  /// @param count number of workers including the thread that calls run(); 0 counts as 1
  explicit ThreadPool(unsigned count);
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ThreadPool(ThreadPool&&) = delete;
  ThreadPool& operator=(ThreadPool&&) = delete;
  ~ThreadPool();

  /// @brief A pool without threads of its own: run() works in the calling thread. Stateless; any number of threads may
  /// use it at the same time.
  static ThreadPool& callerOnly();

  /// @brief Number of workers for a wish, of which 0 means one for each processor.
  static unsigned countFor(unsigned wanted);

  /// @brief Number of short items (about a microsecond each) up to which one thread takes less time than waking others.
  static constexpr std::size_t FEW_SHORT_ITEMS = 128;

  /// @brief Number of workers, the caller of run() included.
  unsigned count() const { return static_cast<unsigned>(threads_.size()) + 1; }

  /// @brief Whether run() would execute everything in the calling thread; parameters as for run().
  bool runsInCaller(std::size_t size, std::size_t few = 0) const { return size <= few || threads_.empty(); }

  /// @brief Splits 0 .. size - 1 into parts whose sizes differ by at most one, executes them on all workers, and
  /// returns when all are done. Scheduling is dynamic, with several parts per worker, so that a delayed worker does not
  /// delay the others. Rethrows the exception of the lowest part that threw; a worker that threw takes no further
  /// parts. One thread may call it at a time. Allocates no memory.
  /// @param work called as work(worker, begin, end) for each part [begin, end), with the number of the worker
  /// @param few up to this size the caller executes everything in one part, because waking threads would take longer
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
  /// Reference to a callable; unlike std::function it never allocates.
  struct Task {
    void (*call)(const void*, unsigned, std::size_t, std::size_t) = nullptr;
    const void* what = nullptr;
  };
  static constexpr std::size_t PARTS_EACH = 64;

  /// An exception that a part has thrown.
  struct Problem {
    std::size_t part = 0;
    std::exception_ptr thrown;
  };
  void share(const Task& task, std::size_t size);
  /// Spins for a short time, yielding the processor, until `is_done` returns true.
  template <typename IsDone>
  void spin(const IsDone& is_done) const;
  void wait(unsigned worker);
  void doParts(unsigned worker);

  bool spins_;
  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable begun_;
  std::condition_variable done_;
  // Written under the mutex while no worker is active.
  Task task_;
  std::size_t size_ = 0;
  std::size_t parts_ = 0;
  std::atomic<std::size_t> next_part_{0};
  std::vector<Problem> problems_;  // by worker
  // All written under the mutex.
  std::atomic<std::size_t> round_{0};
  bool open_ = false;                    // workers that wake up may still join the round
  std::atomic<std::size_t> helpers_{0};  // workers that joined the round and are not done
  bool stop_ = false;
};

}  // namespace crowd
