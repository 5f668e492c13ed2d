#pragma once

#include <cstdint>
#include <optional>

#include "population/place_picker.h"
#include "population/source_schedule.h"

namespace crowd {

/// @brief A source of agents. Agents that are due appear one after the other, as soon as a place is free.
class AgentSource {
 public:
  /// @param population must outlive it @param source its index @param random of this source
  AgentSource(const PopulationDescription& population, std::size_t source, const KeyedRandom& random)
      : population_(&population),
        source_(&population.sources[source]),
        random_(random),
        schedule_(*source_, random.with(SCHEDULE)) {}

  /// @brief The next agent if it is due and there is a place for it now. Its goals are the description's, drawn; with a
  /// route they are only its own position. The caller adds it to the world before it asks for the next one.
  std::optional<AgentStart> next(const World& world, const PlacePicker& places, const PlacePicker::Reach& can_reach);
  /// @brief Whether all agents have appeared.
  bool isOver() const { return schedule_.isOver(); }
  /// @brief Lets no further agent appear.
  void end() { schedule_.end(); }
  const SourceDescription& description() const { return *source_; }

 private:
  enum Choice : std::uint64_t { SCHEDULE = 0, BODY = 1, START = 2, GOAL = 3 };

  const PopulationDescription* population_;
  const SourceDescription* source_;
  KeyedRandom random_;
  SourceSchedule schedule_;
  std::uint64_t created_ = 0;
};

}  // namespace crowd
