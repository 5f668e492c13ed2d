#pragma once

#include <benchmark/benchmark.h>

#include <ctime>

namespace crowd {

/// @brief Which time counts: of work by one thread that of its processor, else that of the clock on the wall.
enum class Clock : clockid_t { OF_THREAD = CLOCK_THREAD_CPUTIME_ID, ON_WALL = CLOCK_MONOTONIC };

/// @brief What the clock shows [s].
inline double now(Clock clock) {
  timespec time{};
  clock_gettime(static_cast<clockid_t>(clock), &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// @brief What some work takes [s].
template <typename Work>
double timeOf(Clock clock, const Work& work) {
  const double begin = now(clock);
  work();
  return now(clock) - begin;
}

/// @brief Sets the counter `rate`: how much is done in a second.
inline void setRate(benchmark::State& state, std::size_t done) {
  state.counters["rate"] = benchmark::Counter(static_cast<double>(done), benchmark::Counter::kIsRate);
}

/// @brief Does work and its yardstick in turns, so that whatever else the machine does slows down both alike: where a
/// processor is now faster and now slower, what was measured one after the other cannot be compared.
///
/// For a benchmark with UseManualTime(), whose time is then that of the work. Both return how much they have done. Sets
/// the counters `rate` and `yardstick_rate`, how much of that they do in a second.
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
