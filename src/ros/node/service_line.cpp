#include "ros/node/service_line.h"

#include <chrono>

namespace crowd {

ServiceLine::~ServiceLine() {
  std::unique_lock<std::mutex> lock(mutex_);
  closing_ = true;
  changed_.notify_all();
  // A persistent client connects again if its call begins after shutdown(), so this is repeated until the call has
  // ended.
  while (!done_) {
    client_.shutdown();
    changed_.wait_for(lock, std::chrono::milliseconds(50));
  }
  lock.unlock();
  thread_.join();
}

bool ServiceLine::disconnect() {
  const std::lock_guard<std::mutex> lock(mutex_);
  client_ = ros::ServiceClient();
  return !closing_;
}

void ServiceLine::post(std::function<void()> task) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  changed_.notify_all();
}

void ServiceLine::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return closing_ || !tasks_.empty(); });
    if (closing_) break;
    const std::function<void()> task = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    task();
    lock.lock();
  }
  done_ = true;
  changed_.notify_all();
}

}  // namespace crowd
