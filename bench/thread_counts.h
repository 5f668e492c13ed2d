#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <thread>

namespace crowd {

/// @brief Sets the points of a sweep: 1, 2, 4, ... threads, up to two per processor, at most 16.
inline void useThreads(benchmark::internal::Benchmark* sweep) {
  const unsigned max_threads = std::min(16U, 2 * std::max(1U, std::thread::hardware_concurrency()));
  for (unsigned threads = 1; threads <= max_threads; threads *= 2) sweep->Arg(threads);
}

}  // namespace crowd
