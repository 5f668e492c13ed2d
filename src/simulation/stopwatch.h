#pragma once

#include <ctime>

namespace crowd {

/// Adds the time of a scope to a sum [s].
class Stopwatch {
 public:
  Stopwatch(clockid_t clock, double& sum) : clock_(clock), sum_(sum), begin_(now(clock)) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  Stopwatch(Stopwatch&&) = delete;
  Stopwatch& operator=(Stopwatch&&) = delete;
  ~Stopwatch() { sum_ += now(clock_) - begin_; }

 private:
  static double now(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  clockid_t clock_;
  double& sum_;
  double begin_;
};

}  // namespace crowd
