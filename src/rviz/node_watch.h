#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace crowd {

/// @brief Looks once per second whether nodes can be called, in a thread of its own, because a look may take long.
class NodeWatch {
 public:
  /// @param report called in the thread with the full name of a service, and whether it can be called
  explicit NodeWatch(std::function<void(const std::string& service, bool reachable)> report);
  ~NodeWatch();
  NodeWatch(const NodeWatch&) = delete;
  NodeWatch& operator=(const NodeWatch&) = delete;

  /// @brief Sets the services by which nodes are recognised; new ones are looked for at once. Thread-safe.
  void watch(const std::vector<std::string>& services);

 private:
  void run();

  std::function<void(const std::string&, bool)> report_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> services_;
  bool has_new_ = false;
  bool closing_ = false;
  std::thread thread_;  // last member: it uses all others
};

}  // namespace crowd
