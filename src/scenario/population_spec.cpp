#include "scenario/population_spec.h"

#include <algorithm>

#include "common/text/quotes.h"
#include "common/text/suggestions.h"
#include "social_crowd/errors.h"

namespace crowd {

bool GateDescription::isOpen(double time) const {
  if (!open_in) return open;
  return std::any_of(open_in->begin(), open_in->end(),
                     [time](const Period& period) { return time >= period.begin && time < period.end; });
}

bool PopulationDescription::empty() const {
  const auto pauses = [](const PersonKind& kind) { return kind.pauses.has_value(); };
  return routes.empty() && sources.empty() && sinks.empty() && queues.empty() && gates.empty() && attractions.empty() &&
         alarms.empty() && std::none_of(kinds.begin(), kinds.end(), pauses);
}

std::optional<PauseDescription> PopulationDescription::pausesOf(std::int32_t kind) const {
  return kind == NO_KIND ? std::nullopt : kinds[static_cast<std::size_t>(kind)].pauses;
}

std::string unknownNameText(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
  std::string text = "there is no " + what + " " + inQuotes(name);
  if (HiddenQuotes::areActive()) return text;  // the known names are in the file, too
  if (known.empty()) return text + "; the scenario has no " + what + "s";
  const std::string hint = didYouMean(name, known);
  return text + (hint.empty() ? "; known are " : hint + " Known are ") + joinNames(known);
}

WaypointDescription sinkWaypoint(const std::string& name, const std::vector<SinkDescription>& sinks) {
  WaypointDescription waypoint;
  const std::optional<std::size_t> found = findName(sinks, name);
  if (!found && name != NEAREST_SINK) throw InputError(unknownNameText("sink", name, namesOf(sinks)));
  if (sinks.empty()) throw InputError("the scenario has no sinks");
  waypoint.kind = found ? WaypointDescription::Kind::SINK : WaypointDescription::Kind::NEAREST_SINK;
  waypoint.target = found.value_or(0);
  return waypoint;
}

RouteDescription alarmRoute(const WaypointDescription& sink) {
  RouteDescription route;
  route.name = "alarm";
  route.waypoints = {sink};
  return route;
}

}  // namespace crowd
