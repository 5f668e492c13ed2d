#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "common/random.h"
#include "population/place_picker.h"
#include "population/route_observer.h"
#include "scenario/population_spec.h"
#include "world/world.h"

namespace crowd {

/// @brief The attractions of an episode, and the agents that stop at them.
///
/// An agent on its way that comes within the radius of an attraction, and sees it, stops with its probability, which is
/// drawn once for each agent and attraction. It gets a further goal before its present one, a free place in the area
/// (in a box not farther away than twice the radius in x and y), stands there, and goes on. It also goes on if there is
/// no free place, or if the way there takes too long.
class Attractions {
 public:
  /// @brief Whether an agent on its way may stop now.
  using MayStop = std::function<bool(const Agent&)>;

  /// @param seed for everything that is drawn
  Attractions(const Scene& scene, const std::vector<AttractionDescription>& attractions, std::uint64_t seed)
      : goal_tolerance_(scene.goal_tolerance),
        random_(seed, KeyedRandom::ATTRACTIONS, {}),
        attractions_(attractions),
        known_(attractions.size()) {}

  bool empty() const { return attractions_.empty(); }
  /// @brief Lets agents stop, wait and go on. Call it after each tick.
  void update(World& world, const PlacePicker& places, const PlacePicker::Reach& can_reach, const MayStop& may_stop,
              RouteObserver& observer);
  /// @brief Ends the visit of an agent, if it is at an attraction or on its way to one. Call it before its goals
  /// change.
  /// @param for_good it does not stop at any other one, either
  void leave(AgentId id, bool for_good, World& world);

 private:
  enum Choice : std::uint64_t { SHARE = 0, PLACE = 1, WAIT = 2 };
  static constexpr int MAX_TRIES = 50;  // draws of a place

  struct Visit {
    AgentId id = 0;
    std::size_t attraction = 0;
    Vector2 place = Vector2::Zero();
    bool waits = false;
    double end = 0.0;  // of the wait, or of the patience [s]
  };

  KeyedRandom randomOf(std::size_t attraction, AgentId id, Choice choice) const {
    return random_.with(attraction).with(id).with(choice);
  }
  void forget(const World& world);
  /// Whether an agent has noticed an attraction now and stops.
  bool stops(std::size_t attraction, const Agent& agent, const World& world) const;
  /// @return whether there is a place for the agent
  bool begin(std::size_t attraction, AgentId id, World& world, const PlacePicker& places,
             const PlacePicker::Reach& can_reach, RouteObserver& observer);
  /// A place near the agent that nobody stands at or walks to.
  std::optional<Vector2> freePlace(std::size_t attraction, const Agent& agent, const World& world,
                                   const PlacePicker& places, const PlacePicker::Reach& can_reach) const;
  bool isTaken(const Vector2& place, const Agent& agent, const World& world) const;
  /// @return whether the visit goes on
  bool goOn(Visit& visit, World& world) const;
  void face(const Visit& visit, World& world) const;

  double goal_tolerance_;
  KeyedRandom random_;
  std::vector<AttractionDescription> attractions_;
  std::vector<std::vector<AgentId>> known_;  // by attraction, ascending: agents that do not stop there any more
  std::vector<Visit> visits_;                // in the order of their beginning
};

}  // namespace crowd
