#pragma once

#include <map>
#include <optional>
#include <vector>

#include "population/place_picker.h"
#include "population/route_observer.h"
#include "world/world.h"

namespace crowd {

/// @brief The agents that follow a leader (AgentStart::leader): each gets a goal beside that of its leader, or, behind
/// a robot, a place behind it. When the leader has arrived they go on to their last goals, and leave the world there.
///
/// Call contract: as for Population, which owns it. Deterministic; depends only on the world. Not thread-safe.
class Followers {
 public:
  explicit Followers(const PlacePicker& places) : places_(places) {}

  bool empty() const { return followers_.empty(); }
  bool contains(AgentId id) const { return leaderOf(id).has_value(); }
  std::optional<Leader> leaderOf(AgentId id) const;
  /// @brief The goals of a follower: free places around those of its leader, the first ones to the left and to the
  /// right of it; those of the leader where there is no room.
  /// @param goals of the leader [m] @param from its place [m] @param number of the follower, from 0 @param radius [m]
  std::vector<Vector2> goalsBeside(const std::vector<Vector2>& goals, Vector2 from, std::size_t number, double radius,
                                   const World& world) const;
  /// @brief The same for a place behind a robot.
  Vector2 goalBehind(RobotId robot, std::size_t number, double radius, const World& world) const;
  /// @brief Whether an agent has followers that are on their way.
  bool leads(AgentId id, const World& world) const;
  /// @brief Number of followers that a leader has had.
  std::size_t countOf(const Leader& leader) const {
    const auto found = counts_.find(groupOf(leader));
    return found == counts_.end() ? 0 : found->second;
  }
  /// @param is_endless its leader never arrives
  void add(AgentId id, const Leader& leader, bool is_endless, const World& world, RouteObserver& observer);
  /// @brief Sets the goals that have changed.
  void update(World& world, RouteObserver& observer);
  /// @brief The agent follows nobody any more, because a user gave it a goal.
  void drop(AgentId id, World& world, RouteObserver& observer);

 private:
  struct Follower {
    AgentId id = 0;
    Leader leader;
    std::size_t number = 0;              // among the followers of this leader
    std::vector<Vector2> leader_goals;   // that its own goals are beside
    std::optional<Vector2> single_goal;  // of the leader, if it gets one after the other
    std::optional<Pose> robot_pose;      // that its goal is behind
  };

  void followAgent(Follower& follower, World& world, RouteObserver& observer) const;
  void followRobot(Follower& follower, World& world, RouteObserver& observer) const;
  static bool hasLeft(const Leader& leader, const World& world);
  static void release(const Follower& follower, World& world, RouteObserver& observer);

  Vector2 goalBeside(const Vector2& goal, const Vector2& from, std::size_t number, double radius,
                     const World& world) const;

  /// The first follower whose id is not lower.
  std::vector<Follower>::const_iterator lowerBound(AgentId id) const;

  PlacePicker places_;
  std::vector<Follower> followers_;  // by ascending id
  std::map<GroupId, std::size_t> counts_;
};

}  // namespace crowd
