#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "common/random.h"
#include "maps/occupancy_map.h"
#include "scenario/population_spec.h"
#include "scenario/scenario.h"
#include "world/world.h"

namespace crowd {

/// @brief Chooses places for agents during an episode: goals and start positions. Depends only on world and random
/// numbers.
class PlacePicker {
 public:
  /// @brief Whether a way leads from one place to another [m] for an agent of a radius [m].
  using Reach = std::function<bool(const Vector2& from, const Vector2& to, double radius)>;

  explicit PlacePicker(const Scene& scene);

  /// @brief Whether a disc [m] overlaps neither walls nor obstacles at rest, and its centre is in a free cell of the
  /// map.
  bool fits(const Vector2& place, double radius, const World& world) const;
  /// @brief Draws a goal in a region: a place where the agent fits, where it has not arrived yet, and that it can
  /// reach. If MAX_TRIES draws find none, the first one where it fits; if there is none either, the last draw.
  /// @param from where the agent is [m] @param radius of the agent [m]
  Vector2 drawGoal(const Region& region, const Vector2& from, double radius, KeyedRandom random, const World& world,
                   const Reach& can_reach) const;
  /// @brief Draws a start position in a region: a free place. Absent if the draws of one tick find none.
  std::optional<Vector2> drawStart(const Region& region, double radius, KeyedRandom random, const World& world) const;
  /// @brief Whether a place that was drawn from {map: free} is connected with the goals or the route of an agent, as
  /// far as these are known before they are drawn; true for all other places.
  bool connects(const Vector2& place, const AgentGroup& group, const PopulationDescription& population) const;
  /// @brief The place in an area where an agent fits that is nearest to it [m]; it is within the goal tolerance of the
  /// edge only if the area is that small.
  Vector2 nearestIn(const Region& area, const Vector2& from, double radius, const World& world) const;

 private:
  static constexpr int MAX_TRIES = 1000;
  static constexpr int START_TRIES = 20;  // per tick

  /// The component of the free space that a place, or one nearby, is in.
  std::uint32_t componentNear(const Vector2& place, double radius) const;

  double goal_tolerance_;
  std::shared_ptr<const FreeSpace> free_space_;
  std::shared_ptr<const OccupancyMap> map_;
};

}  // namespace crowd
