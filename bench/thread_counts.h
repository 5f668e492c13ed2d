#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <thread>

namespace crowd {

/// @brief Gives a sweep its points: 1, 2, 4, ... threads, up to two for each processor, 16 at most.
inline void useThreads(benchmark::internal::Benchmark* sweep) {
  const unsigned most = std::min(16U, 2 * std::max(1U, std::thread::hardware_concurrency()));
  for (unsigned threads = 1; threads <= most; threads *= 2) sweep->Arg(threads);
}

}  // namespace crowd
