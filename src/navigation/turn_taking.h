#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "navigation/floor_ruler.h"
#include "navigation/remaining_path.h"
#include "navigation/way_claims.h"
#include "world/world.h"

namespace crowd {

/// @brief Where the floor is too narrow for two agents to pass each other, opposite directions go in turns, and agents
/// of one direction go one behind the other (docs/way_finding.md).
///
/// The direction in which an agent has been on its way to the narrow part for the longest time goes first, and goes on
/// for a while. Each agent that was near it when it saw the narrow part counts like a time of waiting, so that people
/// leave crowded places before others enter them (the idea of max-pressure control of traffic lights, Varaiya 2013).
/// Agents of the other direction wait at a distance, and step aside for those who come out. If both directions are
/// inside, one of them stops, and walks back where it is in the way (DeadlockResolver).
///
/// Call contract: update() once per tick, after waypoints were set; it replaces waypoints of agents that step aside,
/// and makes agents wait (Agent::yielding). Deterministic; depends only on the world and the ways. Not thread-safe.
class TurnTaking {
 public:
  static constexpr double WAITING_DISTANCE = 1.8;  ///< agents wait at this distance from the narrow part [m]
  static constexpr double TURN_TIME = 6.0;         ///< the direction that is inside goes on for this time at least [s]
  static constexpr double QUEUE_GAP = 0.2;         ///< in front of narrow parts [m]
  static constexpr double DECISION_TIME = 0.2;     ///< between two decisions whether to wait [s]
  static constexpr double CROWD_TIME = 2.0;        ///< of waiting, which each agent near counts like [s]
  static constexpr double CROWD_RADIUS = 2.0;      ///< in which agents are near [m]

  explicit TurnTaking(std::shared_ptr<const FloorRuler> floor) : floor_(std::move(floor)) {}

  /// @param paths of the agents of the world; empty for those that have none
  void update(World& world, const AgentMap<RemainingPath>& paths);

 private:
  /// What an agent remembers about the narrow part ahead of it.
  struct Approach {
    double begin = NEVER;          // time at which it came into sight [s]
    double priority_time = NEVER;  // this time, earlier by CROWD_TIME for each agent that was near it then [s]
    bool was_inside = false;
    bool waits = false;
    Vector2 aside = Vector2::Zero();  // direction in which it steps aside while it waits; zero if it does not
  };
  /// Who else is about to pass the first narrow part on an agent's way.
  struct Traffic {
    bool is_queued = false;              // an agent outside, nearer to the narrow part, is right ahead
    const Claimant* opposite = nullptr;  // outside, the one with priority
    const Claimant* same = nullptr;      // the same, in the agent's direction; may be the agent itself
    const Claimant* opposite_inside = nullptr;
    const Claimant* same_inside = nullptr;
  };
  static constexpr double NEVER = -1.0;

  void decide(const World& world, const AgentMap<RemainingPath>& paths);
  void noteApproach(const World& world, const Claimant& claimant, Approach& approach);
  void rank();
  Traffic trafficOf(const Claimant& claimant);
  void addTraffic(const Claimant& claimant, const Claim& claim, Traffic& traffic);
  void replaceIfFirst(const Claimant*& first, const Claimant& other) const;
  bool hasPriority(const Claimant& a, const Claimant& b) const;
  bool mustWait(const Claimant& claimant, const Traffic& traffic) const;
  Vector2 sideOf(const World& world, const Claimant& claimant);

  std::shared_ptr<const FloorRuler> floor_;
  WayClaims claims_;
  AgentMap<Approach> approaches_;
  std::vector<std::uint32_t> order_;  // the claimants, by descending priority
  std::vector<std::uint32_t> ranks_;  // of the claimants in this order
  std::uint64_t decision_tick_ = 0;   // of the next decision
  std::vector<std::uint32_t> near_;   // by countPeopleNear()
};

}  // namespace crowd
