#include "social_crowd/common/workers.h"

namespace crowd {

Workers::Workers(unsigned count) {
  if (count > 1) problems_.resize(count);
  for (unsigned worker = 1; worker < count; ++worker) threads_.emplace_back([this, worker] { wait(worker); });
}

Workers::~Workers() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

Workers& Workers::alone() {
  static Workers alone(1);
  return alone;
}

void Workers::share(const Task& task, std::size_t size) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    task_ = task;
    size_ = size;
    working_ = threads_.size();
    ++round_;
  }
  begun_.notify_all();
  doPart(0);
  std::unique_lock<std::mutex> lock(mutex_);
  done_.wait(lock, [this] { return working_ == 0; });
  std::exception_ptr first;
  for (std::exception_ptr& problem : problems_) {
    if (first == nullptr) first = problem;
    problem = nullptr;
  }
  if (first != nullptr) std::rethrow_exception(first);
}

void Workers::wait(unsigned worker) {
  std::size_t done = 0;
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    begun_.wait(lock, [&] { return stop_ || round_ != done; });
    if (stop_) return;
    done = round_;
    lock.unlock();
    doPart(worker);
    lock.lock();
    if (--working_ == 0) done_.notify_one();
  }
}

void Workers::doPart(unsigned worker) {
  try {
    task_.call(task_.what, worker, worker * size_ / count(), (worker + 1) * size_ / count());
  } catch (...) {
    problems_[worker] = std::current_exception();
  }
}

}  // namespace crowd
