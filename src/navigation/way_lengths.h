#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "navigation/sized_floor.h"
#include "scenario/scene.h"
#include "world/world.h"

namespace crowd {

/// @brief Answers whether places can be reached, and how far it is, with the floor and the mesh of WayFinder.
///
/// Keeps the meshes of the last layout. Deterministic. Not thread-safe.
class WayLengths {
 public:
  /// @brief FREE: now. GATES: only with all gates open, so that an agent has to wait at one. STRAIGHT: the straight
  /// line between two places, used for those that no way connects.
  enum class Kind : std::uint8_t { FREE = 0, GATES = 1, STRAIGHT = 2 };
  struct Way {
    Kind kind = Kind::FREE;
    double length = 0.0;  ///< [m]
    /// @brief Whether an agent prefers this way.
    bool operator<(const Way& other) const { return std::tie(kind, length) < std::tie(other.kind, other.length); }
  };

  explicit WayLengths(const Scene& scene) : gates_(gateWalls(scene)), goal_tolerance_(scene.goal_tolerance) {}

  /// @brief The shortest way between two places [m]; only if there is none, the shortest one with all gates open.
  /// @param radius of the agent [m]
  /// @return std::nullopt if they are not connected @throws InputError if the floor is too large
  std::optional<Way> find(const World& world, const Vector2& from, const Vector2& to, double radius);

  /// @brief Whether a way leads from one place to another [m], if necessary with all gates open. A place where no way
  /// begins is connected with all. @throws InputError if the floor is too large
  bool connects(const World& world, const Vector2& from, const Vector2& to, double radius);

  /// @brief Why an agent at a place may not have a goal: it is in a wall or obstacle, or cannot be reached. Empty if it
  /// may. A place where no way begins, such as a gap that is too narrow for way-finding, may have any that is not in a
  /// wall or obstacle. @throws InputError if the floor is too large
  std::string problemOf(const World& world, const Vector2& from, const Vector2& goal, double radius);
  /// @brief Does nothing if an agent at a place may have a goal.
  /// @param who for the message, such as "agent 3"
  /// @throws InputError with the problem if it may not, or if the floor is too large
  void requireWay(const std::string& who, const World& world, const Vector2& from, const Vector2& goal, double radius);

 private:
  /// The floor for agents of this radius; nullptr if there is nothing to walk round.
  SizedFloor* floorFor(const World& world, const Vector2& from, const Vector2& to, double radius);

  std::vector<Segment> gates_;
  double goal_tolerance_;
  std::uint64_t layout_changes_ = 0;                    // of the world that the floors belong to
  FloorPlan::Bounds bounds_;                            // of the floors
  std::map<double, std::optional<SizedFloor>> floors_;  // by size; none if there is nothing to walk round
};

}  // namespace crowd
