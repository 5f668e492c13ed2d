#pragma once

#include <ros/ros.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace crowd {

/// @brief Calls services one after the other in a thread of its own, so that its owner is never blocked. The destructor
/// ends a call that is in progress.
class ServiceLine {
 public:
  ServiceLine() : thread_([this] { run(); }) {}
  ~ServiceLine();
  ServiceLine(const ServiceLine&) = delete;
  ServiceLine& operator=(const ServiceLine&) = delete;

  /// @brief Calls a service whose response has `success` and `message`, after the calls that were added before.
  /// @param report called in the thread with the response; if the service cannot be called, `success` is false
  template <typename Service>
  void add(const std::string& name, const typename Service::Request& request,
           std::function<void(const typename Service::Response&)> report) {
    post([this, name, request, report = std::move(report)] {
      typename Service::Response response;
      ros::ServiceClient client = connect<Service>(name);
      if (!client || !client.call(request, response)) {
        response.success = false;
        response.message = "service " + name + " did not answer";
      }
      if (disconnect()) report(response);
    });
  }

 private:
  /// Connects to a service. The connection is kept, so that the destructor can end the call.
  template <typename Service>
  ros::ServiceClient connect(const std::string& name) {
    ros::ServiceClient client = ros::service::createClient<Service>(name, true);
    const std::lock_guard<std::mutex> lock(mutex_);
    if (closing_) return {};
    client_ = client;
    return client;
  }
  /// @return whether the owner still waits for reports
  bool disconnect();
  void post(std::function<void()> task);
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;
  ros::ServiceClient client_;  // of the call in progress
  bool closing_ = false;
  bool done_ = false;   // the thread takes no more tasks
  std::thread thread_;  // last member: it uses all others
};

}  // namespace crowd
