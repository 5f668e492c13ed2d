#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scenario/person_kind.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief Times that differ by less are equal [s]; allows for the rounding of tick times.
constexpr double TIME_ROUNDING = 1e-9;

/// @brief Where an agent looks while it stands: in a direction, to a point, or to a robot.
struct FacingDescription {
  enum class Kind { DIRECTION, POINT, ROBOT };
  Kind kind = Kind::DIRECTION;
  double direction = 0.0;           ///< [degrees], as in the file
  Vector2 point = Vector2::Zero();  ///< [m], `map`
  std::string robot;                ///< its name
};

/// @brief One entry under `waypoints` of a route: where an agent goes next.
struct WaypointDescription {
  /// PLACE: `place`, and `wait` there. QUEUE: in line at queue number `target`. SINK: out of the world at sink number
  /// `target`. NEAREST_SINK: at the sink with the shortest way. ONE_OF: one of `alternatives`.
  enum class Kind { PLACE, QUEUE, SINK, NEAREST_SINK, ONE_OF };
  int line = 0;  ///< in the file, for messages
  Kind kind = Kind::PLACE;
  Region place;                                   ///< drawn for each agent and each time
  Range wait;                                     ///< [s]
  std::optional<FacingDescription> face;          ///< while it waits
  std::size_t target = 0;                         ///< index of the queue or sink
  std::vector<WaypointDescription> alternatives;  ///< none of them is a ONE_OF
};

/// @brief One entry under `routes`.
struct RouteDescription {
  std::string name;
  int line = 0;         ///< in the file, for messages
  bool repeat = false;  ///< begins again after the last waypoint; else agents leave the world there
  std::vector<WaypointDescription> waypoints;  ///< at least one; sinks only as the last one
};

/// @brief One entry under `sinks`: agents on the way to it leave the world when their centre is in the area.
struct SinkDescription {
  std::string name;
  int line = 0;  ///< in the file, for messages
  Region area;   ///< a point, box or ring
};

/// @brief One entry under `queues`: a line in which agents wait to be served.
struct QueueDescription {
  std::string name;
  int line = 0;                           ///< in the file, for messages
  Vector2 head = Vector2::Zero();         ///< place of the agent that is served [m]
  double direction = 0.0;                 ///< in which the line extends [degrees], as in the file
  double spacing = 0.0;                   ///< between the centres of agents in line [m]
  Range service;                          ///< time at the head [s]
  std::optional<FacingDescription> face;  ///< of the agent at the head

  /// @brief Place number `index` of the line, 0 at the head [m].
  Vector2 place(std::size_t index) const {
    return head + static_cast<double>(index) * spacing * unitVector(toRadians(direction));
  }
};

/// @brief A period of time [s], without its end.
struct Period {
  double begin = 0.0;
  double end = 0.0;
};

/// @brief One entry under `gates`: a wall that is there while the gate is closed.
struct GateDescription {
  std::string name;
  int line = 0;  ///< in the file, for messages
  Segment wall;
  bool open = false;                           ///< at the start, without periods
  std::optional<std::vector<Period>> open_in;  ///< open in these ascending periods, closed otherwise

  /// @brief Whether the gate is open at a time [s] if no service changes that.
  bool isOpen(double time) const;
};

/// @brief One entry under `sources`: agents that appear during an episode.
struct SourceDescription {
  AgentGroup agents;           ///< what they are like; `position` is the area of the source, `count` is not used
  std::optional<double> rate;  ///< agents per second; absent: `times`
  bool regular = false;        ///< intervals are equal; else exponential
  std::vector<double> times;   ///< ascending [s]
  double from = 0.0;           ///< with a rate: the source is active from here on [s]
  double until = std::numeric_limits<double>::infinity();           ///< and before this time [s]
  std::uint64_t count = std::numeric_limits<std::uint64_t>::max();  ///< largest number of agents
};

/// @brief One entry under `attractions`: a place at which a share of the passers-by stops, such as a shop window.
struct AttractionDescription {
  std::string name;
  int line = 0;                           ///< in the file, for messages
  Region area;                            ///< where they stand; a point, box or ring
  double radius = 0.0;                    ///< distance from the area at which people notice it [m]
  double share = 0.0;                     ///< probability that one who notices it stops
  Range wait;                             ///< [s]
  std::optional<FacingDescription> face;  ///< while they wait; absent: the middle of the area
};

/// @brief One entry under `alarms`, or a request: people walk to a sink at once, or only change their speed.
struct AlarmDescription {
  int line = 0;                           ///< in the file, for messages
  double time = 0.0;                      ///< [s]
  std::optional<Region> area;             ///< of the people, and of the sources, that it concerns; absent: all
  std::optional<RouteDescription> route;  ///< to the sink; absent: people keep their goals and routes
  double speed_factor = 1.0;              ///< in place of their `hurry`
  Range reaction_time;                    ///< people stand for it first [s]
  bool keeps_sources = false;             ///< with a route: no source ends
};

/// @brief Everything in a scenario that acts on agents during an episode. Immutable once it is read.
struct PopulationDescription {
  std::vector<RouteDescription> routes;
  std::vector<SourceDescription> sources;
  std::vector<SinkDescription> sinks;
  std::vector<QueueDescription> queues;
  std::vector<GateDescription> gates;
  std::vector<PersonKind> kinds;  ///< of people; those that agents and sources name
  std::vector<AttractionDescription> attractions;
  std::vector<AlarmDescription> alarms;

  /// @brief Whether nothing acts on agents during an episode.
  bool empty() const;
  /// @brief The pauses of a kind, if it has any. @param kind index, or NO_KIND
  std::optional<PauseDescription> pausesOf(std::int32_t kind) const;
};

/// @brief "there is no route 'NAME'", a suggestion, and the known names.
std::string unknownNameText(const std::string& what, const std::string& name, const std::vector<std::string>& known);

/// @brief The key that stands for the sink with the shortest way, unless a sink has this name.
constexpr const char* NEAREST_SINK = "nearest";

/// @brief The waypoint of a sink by its name, or of the nearest one. @throws InputError if there is none
WaypointDescription sinkWaypoint(const std::string& name, const std::vector<SinkDescription>& sinks);

/// @brief The route of people who walk to a sink because of an alarm.
RouteDescription alarmRoute(const WaypointDescription& sink);

/// @brief Index of the description with this name, if there is one.
template <typename Descriptions>
std::optional<std::size_t> findName(const Descriptions& descriptions, const std::string& name) {
  for (std::size_t i = 0; i < descriptions.size(); ++i) {
    if (descriptions[i].name == name) return i;
  }
  return std::nullopt;
}

/// @brief The names of these descriptions.
template <typename Descriptions>
std::vector<std::string> namesOf(const Descriptions& descriptions) {
  std::vector<std::string> names;
  names.reserve(descriptions.size());
  for (const auto& description : descriptions) names.push_back(description.name);
  return names;
}

}  // namespace crowd
