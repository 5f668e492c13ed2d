#pragma once

#include <optional>
#include <utility>

#include "navigation/way_lengths.h"
#include "population/place_picker.h"
#include "scenario/population_spec.h"
#include "world/world.h"

namespace crowd {

/// @brief The ways from agents to places that the population chooses among. Without way-finding, and on floors that are
/// too large for it, these are straight lines.
class PlaceWays {
 public:
  explicit PlaceWays(const Scene& scene) {
    if (scene.way_finding) ways_.emplace(scene);
  }

  /// @brief Whether a way leads from one place to another. The object must outlive it.
  PlacePicker::Reach reachIn(const World& world);
  /// @brief A sink, by its index, and a place in it [m].
  struct Exit {
    std::size_t sink = 0;
    Vector2 place = Vector2::Zero();
  };
  /// @brief The sink with the shortest way. @param from where an agent of a radius is [m]; the place if there are none
  Exit nearestSink(const std::vector<SinkDescription>& sinks, const PlacePicker& places, const Vector2& from,
                   double radius, const World& world);

 private:
  WayLengths::Way wayTo(const Vector2& place, const Vector2& from, double radius, const World& world);

  std::optional<WayLengths> ways_;  // with way-finding
};

}  // namespace crowd
