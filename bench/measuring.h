#pragma once

#include <benchmark/benchmark.h>

#include <ctime>

namespace crowd {

/// @brief Clock of a measurement: CPU time of the thread for single-threaded work, otherwise wall time.
enum class Clock : clockid_t { OF_THREAD = CLOCK_THREAD_CPUTIME_ID, ON_WALL = CLOCK_MONOTONIC };

/// @brief Present time of the clock [s].
inline double now(Clock clock) {
  timespec time{};
  clock_gettime(static_cast<clockid_t>(clock), &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// @brief Duration of some work [s].
template <typename Work>
double timeOf(Clock clock, const Work& work) {
  const double begin = now(clock);
  work();
  return now(clock) - begin;
}

/// @brief Sets the counter `rate`: work per second.
inline void setRate(benchmark::State& state, std::size_t done) {
  state.counters["rate"] = benchmark::Counter(static_cast<double>(done), benchmark::Counter::kIsRate);
}

/// @brief Runs work and its yardstick alternately, so that changes of the processor speed and other load affect both
/// equally. Measurements taken one after the other would not be comparable on such a machine.
///
/// For benchmarks with UseManualTime(); the reported time is that of the work. Both callables return the amount of work
/// done. Sets the counters `rate` and `yardstick_rate`, work per second.
template <typename Work, typename Yardstick>
void takeTurns(benchmark::State& state, Clock clock, const Work& work, const Yardstick& yardstick) {
  std::size_t done = 0;
  std::size_t yardstick_done = 0;
  double yardstick_time = 0.0;
  for (auto _ : state) {
    state.SetIterationTime(timeOf(clock, [&] { done += work(); }));
    yardstick_time += timeOf(clock, [&] { yardstick_done += yardstick(); });
  }
  setRate(state, done);
  state.counters["yardstick_rate"] = static_cast<double>(yardstick_done) / yardstick_time;
}

}  // namespace crowd
