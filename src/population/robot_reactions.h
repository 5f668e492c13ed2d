#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "population/place_picker.h"
#include "scenario/reaction.h"
#include "world/world.h"

namespace crowd {

/// @brief The agents that react to robots in another way than to other bodies (AgentStart::reaction).
///
/// An agent on its way meets the nearest perceived robot within the distance of its reaction that it sees: in front of
/// it, and not behind a wall. It reacts once, for a time, until the robot is 1.5 times this distance away; then it may
/// meet it again. A place that it walks to is a further goal before its present one.
///
/// Call contract: as for Population, which owns it. Deterministic; depends only on the world. Not thread-safe.
class RobotReactions {
 public:
  /// @brief What an agent may do. NOTHING: it waits or stands in line. STAY: it may stop or change its speed. WALK: it
  /// may have a further goal, too.
  enum class Freedom { NOTHING, STAY, WALK };
  using FreedomOf = std::function<Freedom(const Agent&)>;

  explicit RobotReactions(const PlacePicker& places) : places_(places) {}

  /// @brief Whether this reaction differs from that to other bodies.
  static bool isSpecial(Reaction reaction) { return reaction > Reaction::INDIFFERENT; }

  bool empty() const { return people_.empty(); }
  /// @brief Adds an agent that has just appeared, with a special reaction.
  void add(AgentId id, Reaction reaction) { people_.push_back({id, reaction}); }
  /// @brief Lets agents react and go on. Call it after each tick.
  /// @param begins is called with each agent that begins to react, before its goals change
  void update(World& world, const FreedomOf& freedom_of, const std::function<void(AgentId)>& begins);
  /// @brief Whether an agent reacts now.
  bool isReacting(AgentId id) const;
  /// @brief A robot is about to be removed: reactions to it end; those after it get smaller ids.
  void forgetRobot(RobotId robot, World& world);
  /// @brief Ends what an agent does now. Call it before its goals change. @param for_good it does not react any more
  void leave(AgentId id, bool for_good, World& world);

 private:
  enum class Phase { UNAWARE, REACTING, DONE };

  struct Person {
    AgentId id = 0;
    Reaction reaction = Reaction::REGULAR;
    Phase phase = Phase::UNAWARE;
    RobotId robot = 0;                            // that it has met, unless it is unaware
    double end = 0.0;                             // of the reaction [s]
    std::optional<Vector2> place = std::nullopt;  // the further goal
  };

  std::vector<Person>::const_iterator find(AgentId id) const;
  bool meets(Person& person, const Agent& agent, const World& world) const;
  void react(Person& person, Freedom freedom, World& world) const;
  /// Walks to a place, unless the agent is there: then it stands and looks at the robot.
  void stayAt(const Vector2& place, Person& person, World& world) const;
  void flee(Person& person, World& world) const;
  static void walkTo(const Vector2& place, Person& person, Agent& agent);
  bool canWalk(const Agent& agent, const Vector2& place, const World& world) const;
  static void dropPlace(Person& person, Agent& agent);
  static void finish(Person& person, Phase phase, World& world);

  PlacePicker places_;
  std::vector<Person> people_;  // by ascending id
};

}  // namespace crowd
