#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "measuring.h"
#include "social_crowd/errors.h"
#include "training/communicator.h"

namespace crowd {

/// Lets rank 0 work alone while the other ranks of this machine sleep. Waiting in MPI would occupy a processor each.
class SleepingRanks {
 public:
  /// Collective.
  explicit SleepingRanks(Communicator& ranks) : ranks_(ranks) {
    std::string name = "/tmp/sleeping_ranks_XXXXXX";
    if (isFirst()) file_ = ::mkstemp(name.data());
    Communicator::Bytes bytes(name.begin(), name.end());
    ranks_.broadcast(bytes);
    if (!isFirst()) file_ = ::open(std::string(bytes.begin(), bytes.end()).c_str(), O_RDWR | O_CLOEXEC);  // NOLINT
    ranks_.gatherAll({});
    if (isFirst()) ::unlink(name.c_str());
    if (file_ < 0) throw Error("no file in /tmp");
  }
  SleepingRanks(const SleepingRanks&) = delete;
  SleepingRanks& operator=(const SleepingRanks&) = delete;
  SleepingRanks(SleepingRanks&&) = delete;
  SleepingRanks& operator=(SleepingRanks&&) = delete;
  ~SleepingRanks() { ::close(file_); }

  /// Returns the time of some work of rank 0 [s], and 0 on other ranks. Collective.
  template <typename Work>
  double timeAlone(const Work& work) {
    double seconds = 0.0;
    if (isFirst()) ::flock(file_, LOCK_EX);
    ranks_.gatherAll({});
    if (isFirst()) {
      seconds = timeOf(Clock::ON_WALL, work);
    } else {
      ::flock(file_, LOCK_EX);  // sleeps until rank 0 has finished
    }
    ::flock(file_, LOCK_UN);
    ranks_.gatherAll({});
    return seconds;
  }

 private:
  bool isFirst() const { return ranks_.rank() == 0; }

  Communicator& ranks_;
  int file_ = -1;
};

}  // namespace crowd
