#pragma once

#include <cstdint>

#include "common/random.h"
#include "scenario/population_spec.h"

namespace crowd {

/// @brief The times at which agents of a source are due, one after the other.
///
/// With exponential intervals the arrivals are a Poisson process; with regular ones the first agent is due at `from`.
class SourceSchedule {
 public:
  /// @param source must outlive the schedule @param random of this source
  SourceSchedule(const SourceDescription& source, const KeyedRandom& random);

  /// @brief Time of the next agent [s]; infinity if there is none any more.
  double next() const { return next_; }
  bool isOver() const;
  /// @brief Goes on to the agent after the next one.
  void advance();
  /// @brief Ends it: there is no next agent.
  void end();

 private:
  double timeOf(std::uint64_t number, double before) const;

  const SourceDescription* source_;
  KeyedRandom random_;
  std::uint64_t number_ = 0;  // of the next agent
  double next_;
};

}  // namespace crowd
