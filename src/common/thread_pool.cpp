#include "common/thread_pool.h"

#include <algorithm>
#include <chrono>

namespace crowd {
namespace {

// About the serial time between two parallel loops in a tick of a large crowd; 20 and 400 were no better.
constexpr std::chrono::microseconds SPIN_TIME{100};

}  // namespace

ThreadPool::ThreadPool(unsigned count) : spins_(count <= std::thread::hardware_concurrency()) {
  if (count > 1) problems_.resize(count);
  for (unsigned worker = 1; worker < count; ++worker) threads_.emplace_back([this, worker] { wait(worker); });
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

unsigned ThreadPool::countFor(unsigned wanted) {
  return wanted > 0 ? wanted : std::max(1U, std::thread::hardware_concurrency());
}

ThreadPool& ThreadPool::callerOnly() {
  static ThreadPool alone(1);
  return alone;
}

template <typename IsDone>
void ThreadPool::spin(const IsDone& is_done) const {
  if (!spins_) return;
  const auto end = std::chrono::steady_clock::now() + SPIN_TIME;
  while (!is_done() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
}

void ThreadPool::share(const Task& task, std::size_t size) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    task_ = task;
    size_ = size;
    parts_ = std::min(size, PARTS_EACH * count());
    next_part_ = 0;
    for (Problem& problem : problems_) problem = {};
    open_ = true;
    ++round_;
  }
  begun_.notify_all();
  doParts(0);
  spin([this] { return helpers_ == 0; });
  std::unique_lock<std::mutex> lock(mutex_);
  open_ = false;
  done_.wait(lock, [this] { return helpers_ == 0; });
  const Problem* first = nullptr;
  for (const Problem& problem : problems_) {
    if (problem.thrown != nullptr && (first == nullptr || problem.part < first->part)) first = &problem;
  }
  if (first != nullptr) std::rethrow_exception(first->thrown);
}

void ThreadPool::wait(unsigned worker) {
  std::size_t done = 0;
  for (;;) {
    spin([&] { return round_ != done; });
    std::unique_lock<std::mutex> lock(mutex_);
    begun_.wait(lock, [&] { return stop_ || (open_ && round_ != done); });
    if (stop_) return;
    done = round_;
    ++helpers_;
    lock.unlock();
    doParts(worker);
    lock.lock();
    if (--helpers_ == 0) done_.notify_one();
  }
}

void ThreadPool::doParts(unsigned worker) {
  std::size_t part = 0;
  try {
    for (part = next_part_++; part < parts_; part = next_part_++) {
      task_.call(task_.what, worker, part * size_ / parts_, (part + 1) * size_ / parts_);
    }
  } catch (...) {
    problems_[worker] = {part, std::current_exception()};
  }
}

}  // namespace crowd
