#include "rviz/node_watch.h"

#include <ros/service.h>

#include <chrono>
#include <utility>

namespace crowd {
namespace {

constexpr std::chrono::seconds WATCH_PERIOD(1);
constexpr bool PRINTS_FAILURE = false;
constexpr int ATTEMPTS = 2;  // a lookup at the master can fail once although the node is there

bool isReachable(const std::string& service) {
  for (int attempt = 0; attempt < ATTEMPTS; ++attempt) {
    if (ros::service::exists(service, PRINTS_FAILURE)) return true;
  }
  return false;
}

}  // namespace

NodeWatch::NodeWatch(std::function<void(const std::string& service, bool reachable)> report)
    : report_(std::move(report)), thread_([this] { run(); }) {}

NodeWatch::~NodeWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void NodeWatch::watch(const std::vector<std::string>& services) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (services == services_) return;
    services_ = services;
    has_new_ = true;
  }
  changed_.notify_all();
}

void NodeWatch::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!closing_) {
    has_new_ = false;
    const std::vector<std::string> services = services_;
    lock.unlock();
    for (const std::string& service : services) report_(service, isReachable(service));
    lock.lock();
    changed_.wait_for(lock, WATCH_PERIOD, [&] { return closing_ || has_new_; });
  }
}

}  // namespace crowd
