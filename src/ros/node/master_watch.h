#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "ros/node/registrations.h"

namespace crowd {

/// @brief Looks every two seconds whether the ROS master still knows this process. After a new roscore, or after
/// `rosnode cleanup` while the process could not be reached, it does not: then topics and services are registered
/// again, which roscpp does not do, and a warning says so. Connections between nodes do not need the master and go on.
/// One per process, in a thread of its own.
class MasterWatch {
 public:
  /// @brief Returns the one of this process, and starts it if there is none. It ends with the last of the results. ROS
  /// must have been started.
  static std::shared_ptr<MasterWatch> ofProcess();

  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

 private:
  MasterWatch();
  void run();
  void check();
  /// Whether the master does not know this process, or not all of it.
  bool isForgottenBy(const RosApi::Answer& node, int pid);
  void noteSilence();
  void noteAnswer();
  void registerAgain();
  /// Sleeps until the next look, or until the end.
  void pause(double seconds);
  bool isEnding() const;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> ending_{false};
  RosApi master_;
  Registrations registrations_;
  int pid_ = 0;                // of the master that knows this process
  bool is_forgotten_ = false;  // until all is registered
  int silent_checks_ = 0;
  std::thread thread_;  // last member: it uses all others
};

}  // namespace crowd
