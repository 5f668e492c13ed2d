#pragma once

#include <deque>
#include <vector>

#include "scenario/population_spec.h"
#include "world/world.h"

namespace crowd {

/// @brief The alarms of an episode: those of its scenario, which are raised at their times, and those of requests.
class Alarms {
 public:
  explicit Alarms(const std::vector<AlarmDescription>& alarms);

  /// @brief Whether there is one to be raised.
  bool arePending() const { return !pending_.empty(); }
  /// @brief The alarms that are due now, and that are not pending any more, by their numbers. @param now [s]
  std::vector<std::size_t> takeDue(double now);
  /// @brief Adds one that is not pending. @return its number
  std::size_t add(AlarmDescription alarm);
  /// @brief An alarm by its number; valid as long as this object.
  const AlarmDescription& operator[](std::size_t number) const { return all_[number]; }

 private:
  std::deque<AlarmDescription> all_;  // stay where they are
  std::vector<std::size_t> pending_;  // by ascending times
};

/// @brief The agents on their way that an alarm concerns, by ascending id.
std::vector<AgentId> agentsOf(const AlarmDescription& alarm, const World& world);

/// @brief Whether an alarm ends a source: people are to leave the area that the middle of the source is in.
bool endsSource(const AlarmDescription& alarm, const SourceDescription& source);

}  // namespace crowd
