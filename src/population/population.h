#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "navigation/way_lengths.h"
#include "population/agent_source.h"
#include "population/alarms.h"
#include "population/attractions.h"
#include "population/distraction.h"
#include "population/followers.h"
#include "population/gate.h"
#include "population/place_picker.h"
#include "population/place_ways.h"
#include "population/queue.h"
#include "population/robot_reactions.h"
#include "population/route_follower.h"
#include "population/route_observer.h"
#include "scenario/population_spec.h"
#include "world/world.h"

namespace crowd {

/// @brief Runs the sources, sinks, routes, queues, gates, attractions, alarms, leaders, reaction times, pauses and
/// reactions to robots of an episode.
///
/// Call contract: begin() before the first tick; update() after each tick, before it is measured; the other
/// functions between two ticks. Deterministic; depends only on the scene and the world. Not thread-safe.
class Population {
 public:
  explicit Population(const Scene& scene);

  /// @brief Sets the first goals, and headings towards them, of the agents of a scene that have routes or leaders.
  /// @throws Stopped if `stop` is made, as begin() and update() do for that of the world
  static void chooseFirstGoals(Scene& scene, const StopRequest& stop = {});

  void begin(World& world, RouteObserver& observer);
  void update(World& world, RouteObserver& observer) {
    if (!isEmpty()) updateAll(world, observer);
  }
  /// @brief Whether a source has agents left.
  bool expectsAgents() const;

  /// @brief Lets an agent begin a route. @throws InputError that lists the known names, or if the agent is not on its
  /// way, or cannot walk the route (RouteCheck); nothing is changed then
  /// @param ways for the check, so that a refused route does not affect the ways of others; null: it is not checked
  void setRoute(AgentId id, const std::string& route, WayLengths* ways, World& world, RouteObserver& observer);
  /// @brief Ends the route of an agent, for example when a user sets a goal. Does nothing without a route.
  void dropRoute(AgentId id, World& world, RouteObserver& observer);
  /// @brief Opens or closes a gate, see Gate. @return whether it is open now @throws InputError that lists the known
  /// names
  bool setGate(const std::string& gate, bool open, World& world);
  /// @brief Lets people walk to a sink, or change their speed, now. Waits, queues and attractions end for those who
  /// walk to a sink, and they do not stop at attractions any more. @return number of these people
  /// @throws InputError if one of them would be faster than the greatest permitted speed; nothing is changed then
  std::size_t raiseAlarm(AlarmDescription alarm, World& world, RouteObserver& observer);
  /// @brief Adds the last source, or the last gate, of a description that is otherwise the present one. A source begins
  /// now.
  void addSource(const Scene& scene, const World& world);
  void addGate(const Scene& scene, World& world);
  /// @brief Adds or removes the walls of the gates, for changes of walls by others.
  void updateGates(World& world);

  /// @brief Whom an agent follows, if anybody.
  std::optional<Leader> leaderOf(AgentId id) const { return followers_.leaderOf(id); }
  /// @brief Number of agents on a route or within their reaction time.
  std::size_t memberCount() const { return members_.size(); }
  const Queue& queue(std::size_t index) const { return queues_[index]; }

  /// @brief A robot is about to be removed; those after it get smaller ids.
  void forgetRobot(RobotId robot, World& world) { reactions_.forgetRobot(robot, world); }

 private:
  /// An agent on a route, or one that has not reacted yet.
  struct Member {
    AgentId id = 0;
    double reacts_at = 0.0;  // [s]
    std::optional<RouteFollower> route;
    std::size_t sink = 0;  // of the present leg
  };

  /// Whether there is nothing to update, as in scenes of agents with goals alone.
  bool isEmpty() const {
    return members_.empty() && sources_.empty() && queues_.empty() && gates_.empty() && attractions_.empty() &&
           !alarms_.arePending() && followers_.empty() && distraction_.isEmpty() && reactions_.empty();
  }
  void updateAll(World& world, RouteObserver& observer);
  /// Uses this description from now on. The one before is kept, because queues, gates and routes refer to it.
  void adopt(const Scene& scene, PopulationDescription description);
  KeyedRandom randomOfRoute(AgentId id, std::uint64_t tick) const;
  Member* find(AgentId id);
  /// Adds an agent that has just appeared.
  void admit(AgentId id, const AgentStart& start, World& world, RouteObserver& observer);
  /// The same for one that follows another; its leader must have been added before.
  void follow(AgentId id, const AgentStart& start, const World& world, RouteObserver& observer);
  /// Returns the goal of an agent's present leg, and sets its sink.
  Vector2 goalOfLeg(Member& member, const Vector2& from, double radius, const World& world);
  void chooseGoalsOfFollowers(Scene& scene, const World& world) const;
  bool isEndless(const Leader& leader, const World& world);
  void beginLeg(Member& member, World& world);
  /// An agent that is sent elsewhere leaves its group, unless somebody follows it.
  void leaveGroup(AgentId id, World& world, RouteObserver& observer);
  /// Goes on to the next waypoint, or lets the agent leave at the end of its route.
  void advance(Member& member, World& world, RouteObserver& observer);
  void walk(Member& member, World& world, RouteObserver& observer);
  void hold(const Member& member, World& world) const;
  void face(const Member& member, World& world) const;
  /// Lets an agent walk a route, which must outlive it, in place of what it does.
  Member& beginRoute(AgentId id, const RouteDescription& route, World& world, RouteObserver& observer);
  /// Raises an alarm by its number.
  std::size_t raise(std::size_t number, World& world, RouteObserver& observer);
  void raiseAlarms(World& world, RouteObserver& observer);
  void updateAttractions(World& world, RouteObserver& observer);
  void updateReactions(World& world);
  /// Whether an agent is on its way to a queue, or stands in it.
  bool isQueuing(AgentId id);
  void serveQueues(World& world, RouteObserver& observer);
  void completeStart(AgentId id, AgentStart& start, const World& world);
  void spawn(World& world, RouteObserver& observer);

  std::shared_ptr<const PopulationDescription> description_;
  std::vector<std::shared_ptr<const PopulationDescription>> earlier_;  // descriptions, which others refer to
  std::uint64_t seed_;
  PlacePicker places_;
  PlaceWays ways_;
  Followers followers_;
  Distraction distraction_;
  std::vector<AgentStart> starts_;  // until begin()
  std::vector<AgentSource> sources_;
  std::vector<Queue> queues_;
  std::vector<Gate> gates_;
  Attractions attractions_;
  RobotReactions reactions_;
  Alarms alarms_;
  std::vector<Member> members_;  // by ascending id
};

}  // namespace crowd
