#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "navigation/deadlock_resolver.h"
#include "navigation/passages.h"
#include "navigation/remaining_path.h"
#include "world/world.h"

namespace crowd {

/// @brief Decides which agents go first through passages that are too narrow for two agents to pass each other, so that
/// agents do not block each other there. Deterministic; depends only on the world and the earlier calls.
///
/// At most one direction at a time has the right of way in a passage. Agents of that direction are admitted in the
/// order of their distance: without traffic in the other direction at a rate in proportion to the width, otherwise as
/// many at a time as fit side by side, with room between them. After BATCH_SIZE agents the others have their turn.
/// Agents that wait stay outside of a zone in front of the mouth; if there is traffic in the other direction, the zone
/// contains a lane for agents that come out. If no agent makes progress, because agents that wait are in the way of
/// others, all are released for some seconds.
///
/// Passages without room to wait are not controlled. Those that are too narrow for two agents side by side are entered
/// by one agent after the other (formSingleFiles()): two agents in them would be wedged.
///
/// Call contract: update() once per tick, after the agents have moved and waypoints were set.
class RightOfWay {
 public:
  /// @brief Passages below this width are controlled, for agents of this radius [m].
  static double maxWidth(double radius) { return 4.0 * radius + 0.45; }
  /// @brief Number of agents of one direction that go before the others have their turn.
  static constexpr std::size_t BATCH_SIZE = 8;
  /// @brief Agents take part from this distance along their path to the passage [m].
  static constexpr double LOOKAHEAD = 4.0;

  /// @param passages narrower than maxWidth() @param radius of the largest agents [m]
  RightOfWay(std::shared_ptr<const Passages> passages, double radius);

  /// @brief Holds agents that must wait (World::setYielding), and sends those that are in the way of others aside
  /// (World::setWaypoint). @param paths of the agents of the world; empty for those that have none
  void update(World& world, const AgentMap<RemainingPath>& paths);
  /// @brief Holds agents in front of narrow passages that are not controlled (World::setYielding) while an agent
  /// inside, or one that enters at the same mouth, is beside or ahead of them. @param deadlocks after its update() of
  /// this tick; agents that walk back are not held
  void formSingleFiles(World& world, const DeadlockResolver& deadlocks) const;

 private:
  /// The next passage on the path of an agent.
  struct Claim {
    AgentId agent = 0;
    std::size_t mouth = 0;  // where it enters
    double distance = 0.0;  // along the path [m]; 0 inside
  };
  struct Admitted {
    AgentId agent = 0;
    double remaining = std::numeric_limits<double>::infinity();  // length of its path when it last made progress [m]
  };
  /// Agents in a passage: at most `abreast` within `length` of the path.
  struct Spacing {
    std::size_t abreast;
    double length;  // [m]
  };
  struct PassageState {
    std::vector<Claim> claims;  // of this tick, nearest first
    std::vector<Admitted> admitted;
    std::size_t direction = 0;   // the mouth that admitted agents enter
    std::size_t served = 0;      // since the direction changed
    bool is_controlled = true;   // there is room to wait
    double progress_time = 0.0;  // when an admitted agent last made progress [s]

    bool isAdmitted(AgentId agent) const;
  };

  bool hasRoomToWait(const Mouth& mouth) const;
  void collectClaims(const World& world, const AgentMap<RemainingPath>& paths);
  void addClaim(const Agent& agent, const RemainingPath& path);
  static void dropPassed(double time, PassageState& state);
  static void noteProgress(const World& world, const AgentMap<RemainingPath>& paths, PassageState& state);
  void admit(std::size_t passage, PassageState& state) const;
  void chooseDirection(PassageState& state) const;
  Spacing spacing(std::size_t passage, bool two_way) const;
  void guide(std::size_t passage, const PassageState& state, World& world) const;
  static bool isBehindAnother(const World& world, std::vector<Claim>::const_iterator first,
                              std::vector<Claim>::const_iterator claim);
  void guideWaiting(const Mouth& mouth, bool two_way, const Claim& claim, World& world) const;
  void formSingleFile(const PassageState& state, const DeadlockResolver& deadlocks, World& world) const;
  std::size_t nearestMouth(std::size_t passage, const Vector2& place) const;

  std::shared_ptr<const Passages> passages_;
  double radius_;
  std::vector<PassageState> states_;  // by passage
};

}  // namespace crowd
