#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/neighbour_grid.h"
#include "navigation/floor_ruler.h"
#include "navigation/remaining_path.h"
#include "world/world.h"

namespace crowd {

/// @brief A place on the way ahead of an agent.
struct Claim {
  Vector2 place = Vector2::Zero();       ///< [m], `map`
  Vector2 direction = Vector2::UnitX();  ///< of the way there, unit vector
  double ahead = 0.0;                    ///< length of the way to it [m]
  FloorWidth width;                      ///< free floor across the way, for the agent's centre; where it is narrow [m]
  double room = 0.0;                     ///< beside two bodies that pass each other there [m]
  bool is_narrow = false;                ///< agents of this size and in opposite directions do not pass each other
  std::uint32_t passage = 0;             ///< number of narrow parts of the way that begin between the agent and it
  std::uint32_t claimant = 0;            ///< see WayClaims::claimants()
};

/// @brief An agent whose way leads through a narrow part of the floor.
struct Claimant {
  AgentId agent = 0;
  std::uint32_t first = 0;             // of its claims
  std::uint32_t last = 0;              // behind its last claim
  Vector2 heading = Vector2::UnitX();  ///< to the place on its way at HEADING_DISTANCE, unit vector
  double distance = 0.0;               ///< of the first narrow place on its way; 0 inside [m]
  double length = 0.0;                 ///< of the first narrow part of its way [m]
  Vector2 position = Vector2::Zero();  ///< of the agent [m]
  double radius = 0.0;                 ///< of the agent [m]
  bool isInside() const { return distance <= 0.0; }
};

/// @brief What others look at in a claim, in little memory.
struct NearClaim {
  Vector2 place = Vector2::Zero();
  Vector2 direction = Vector2::UnitX();
  double ahead = 0.0;
  std::uint32_t claimant = 0;
  bool is_narrow = false;
  bool is_first_passage = false;
};

/// @brief The ways that agents are about to take: places at intervals of STEP on the next LOOKAHEAD of them, or to the
/// end of a narrow part that begins there. Agents whose way has no narrow part have no claims.
///
/// Call contract: update() once per tick; the results are valid until the next call. Not thread-safe.
class WayClaims {
 public:
  static constexpr double STEP = 0.2;              ///< [m]
  static constexpr double LOOKAHEAD = 3.0;         ///< [m]
  static constexpr double MAX_LENGTH = 25.0;       ///< of ways through a narrow part [m]
  static constexpr double HEADING_DISTANCE = 0.4;  ///< [m]
  static constexpr double PASSING_ROOM = 0.6;      ///< beside two bodies that pass each other [m]
  static constexpr double DOOR_ROOM = 1.4;         ///< the same in a door [m]
  static constexpr double DOOR_LENGTH = 1.0;       ///< greatest length of a door [m]

  /// @brief The clearance beyond which floor is wide for agents up to a radius [m].
  static double wideClearance(double radius) { return 2.0 * radius + 0.5 * DOOR_ROOM; }

  void update(const World& world, const AgentMap<RemainingPath>& paths, const FloorRuler& floor);

  /// @brief By ascending id of the agents.
  const std::vector<Claimant>& claimants() const { return claimants_; }
  Span<Claim> of(const Claimant& claimant) const {
    return {claims_.data() + claimant.first, std::size_t{claimant.last} - claimant.first};
  }
  /// @brief Of the claimants [m].
  double largestRadius() const { return largest_radius_; }
  /// @brief Calls visit(claim) for the claims within a distance of a place [m].
  template <typename Visit>
  void visitNear(const Vector2& place, double distance, const Visit& visit) {
    const NeighbourGrid::RunsNear candidates = grid_.findRunsNear(place, distance, runs_);
    if (near_.size() < candidates.discs + 1) near_.resize(2 * candidates.discs + 1);
    std::size_t count = 0;
    for (const NeighbourGrid::Run& run : candidates.runs) {
      for (std::uint32_t i = run.begin; i < run.end; ++i) {
        near_[count] = i;  // without a branch, which would often be mispredicted
        count += (grid_.centre(i) - place).squaredNorm() <= distance * distance ? 1U : 0U;
      }
    }
    for (std::size_t i = 0; i < count; ++i) visit(sorted_[near_[i]]);
  }

 private:
  void addWay(const Agent& agent, const RemainingPath& path, const FloorRuler& floor);
  void addPlaces(const Agent& agent, const RemainingPath& path, const FloorRuler& floor);
  void tellDoors(std::size_t first, double radius);

  std::vector<Claimant> claimants_;
  std::vector<Claim> claims_;
  double largest_radius_ = 0.0;    // of the claimants [m]
  NeighbourGrid grid_;             // of the claims
  std::vector<NearClaim> sorted_;  // in the order of the grid
  NeighbourGrid::Runs runs_;
  std::vector<std::uint32_t> near_;  // by visitNear()
};

}  // namespace crowd
