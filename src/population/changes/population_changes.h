#pragma once

#include <vector>

#include "scenario/population_spec.h"
#include "scenario/scene.h"

namespace crowd {

/// @brief The population of a scene with another source, as the last one. A source that could not be read from a
/// scenario file is refused.
/// @param source with a route: that of the scene with this index
/// @param walls those that are there now
/// @throws InputError that begins with the key of the scenario file
PopulationDescription withSource(const Scene& scene, const SourceDescription& source,
                                 const std::vector<Segment>& walls);

/// @brief The same with another gate. @throws InputError also if there is a gate of this name
PopulationDescription withGate(const Scene& scene, const GateDescription& gate);

/// @brief The same with another alarm.
PopulationDescription withAlarm(const Scene& scene, const AlarmDescription& alarm);

}  // namespace crowd
