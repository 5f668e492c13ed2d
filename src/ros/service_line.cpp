#include "social_crowd/ros/service_line.h"

namespace crowd {

ServiceLine::~ServiceLine() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closing_ = true;
    client_.shutdown();
  }
  changed_.notify_all();
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
    if (closing_) return;
    const std::function<void()> task = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    task();
    lock.lock();
  }
}

}  // namespace crowd
