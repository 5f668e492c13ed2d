#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "navigation/floor_ruler.h"
#include "navigation/remaining_path.h"
#include "world/world.h"

namespace crowd {

/// @brief Keeps the members of each group (Agent::group) together while they walk (docs/groups.md): each gets a place
/// beside its mates, to whose side it walks, and a pace that lets those behind catch up.
///
/// Members walk abreast, the inner ones the more behind the denser the crowd is (a V, Moussaid et al. 2010), and in
/// rows, at last in file, where the floor leaves no room. All walk at the speed of the slowest, less for each mate;
/// those ahead wait where others can pass. In a dense crowd each walks alone until it is less dense.
///
/// Call contract: update() once per tick, before the agents are led; then aimOf() for each agent. Deterministic;
/// depends only on the world and the ways. Not thread-safe.
class GroupWalking {
 public:
  static constexpr double DECISION_TIME = 0.4;    ///< between two decisions of a group [s]
  static constexpr double SPACING = 0.95;         ///< between the centres of neighbours [m]
  static constexpr double SIZE_SLOWDOWN = 0.06;   ///< of the speed, for each mate [m/s]
  static constexpr std::size_t MOST_ABREAST = 4;  ///< a larger group walks in several rows

  /// @param paths of the agents as of the last tick; agents without one walk straight to their goals
  /// @param floor null: there are no walls
  void update(World& world, const AgentMap<RemainingPath>& paths, const FloorRuler* floor);
  /// @brief The point that an agent of a group walks to, to get to its place in the group; absent if it is to walk its
  /// own way. @param next the point that it would walk to by itself [m]
  std::optional<Vector2> aimOf(const Agent& agent, const Vector2& next);
  bool empty() const { return groups_.empty(); }

 private:
  static constexpr double LOOKAHEAD = 2.5;  // [m]

  /// A member that walks, as of the decision.
  struct Walker {
    const Agent* agent = nullptr;
    double ahead = 0.0;               // of the mean of the group, along the way [m]
    double left = 0.0;                // of the mean of the group, across the direction of the group [m]
    std::optional<Vector2> goal;      // the next one of the group [m], `map`
    Vector2 place = Vector2::Zero();  // that it should have: ahead and to the left of the mean [m]
  };
  /// What is kept of a member until the next decision.
  struct Member {
    double shift = 0.0;  // to the left of its way [m]
    Vector2 next = Vector2::Zero();
    std::optional<Vector2> aim;  // for `next`
  };
  struct Group {
    std::vector<AgentId> members;                // on their way, by ascending id
    std::optional<std::uint64_t> decision_tick;  // of the next decision
  };
  using Paths = AgentMap<RemainingPath>;

  void collect(const World& world);
  void decide(const Group& group, World& world, const Paths& paths, const FloorRuler* floor);
  static std::vector<Walker> walkersOf(const Group& group, const World& world, const Paths& paths, Vector2& forward);
  /// Who is ahead of a group.
  struct Traffic {
    double density = 0.0;      // [1/m2]
    bool is_oncoming = false;  // somebody comes towards the group
  };
  static bool haveParted(const std::vector<Walker>& walkers);
  static Traffic trafficAhead(const std::vector<Walker>& walkers, const Vector2& forward, const World& world);
  static std::size_t columnsFor(const std::vector<Walker>& walkers, double spacing, const Vector2& forward,
                                const Traffic& traffic, const FloorRuler* floor);
  static void arrange(std::vector<Walker>& walkers, std::size_t columns, double spacing, double bend);
  void assign(const std::vector<Walker>& walkers, World& world, const FloorRuler* floor);

  std::map<GroupId, Group> groups_;
  AgentMap<Member> members_;
};

}  // namespace crowd
