#pragma once

#include <cstdint>
#include <optional>

#include "population/place_picker.h"
#include "population/source_schedule.h"
#include "scenario/group_placement.h"

namespace crowd {

/// @brief A source of agents. Agents that are due appear one after the other, as soon as a place is free.
class AgentSource {
 public:
  /// @param population must outlive it @param source its index @param random of this source
  AgentSource(const PopulationDescription& population, std::size_t source, const KeyedRandom& random)
      : population_(&population),
        source_(&population.sources[source]),
        random_(random),
        schedule_(*source_, random.with(SCHEDULE)),
        parties_(source_->agents.groups, random.with(PARTY)) {}

  /// @brief The next agent if it is due and there is a place for it now; those who follow it are due at once. Its goals
  /// are the description's, drawn; with a route or a leader they are only its own position. The caller adds it to the
  /// world before it asks for the next one.
  std::optional<AgentStart> next(const World& world, const PlacePicker& places, const PlacePicker::Reach& can_reach);
  /// @brief Whether all agents have appeared.
  bool isOver() const { return schedule_.isOver(); }
  /// @brief Lets no further agent appear.
  void end() { schedule_.end(); }
  const SourceDescription& description() const { return *source_; }

 private:
  enum Choice : std::uint64_t { SCHEDULE = 0, BODY = 1, START = 2, GOAL = 3, PARTY = 4, KIND = 5, REACTION = 6 };

  void drawGoals(AgentStart& start, const KeyedRandom& random, const World& world, const PlacePicker& places,
                 const PlacePicker::Reach& can_reach) const;
  std::optional<Vector2> drawPlace(double radius, const World& world, const PlacePicker& places) const;

  const PopulationDescription* population_;
  const SourceDescription* source_;
  KeyedRandom random_;
  SourceSchedule schedule_;
  Parties parties_;
  std::uint64_t created_ = 0;
};

}  // namespace crowd
