#include "population/robot_reactions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/limits.h"
#include "population/facing.h"

namespace crowd {
namespace {

/// When and how people react. Distances from centre to centre and times are those of HuNavSim (behaviour trees of
/// hunav_agent_manager); paces and gaps are our choice.
struct ReactionRule {
  double distance = 0.0;  // within which a robot is met [m]
  double time = 0.0;      // [s]
  double pace = 1.0;      // factor of the speed
  double gap = 0.0;       // between the rims of agent and robot at the place where it stands [m]
};

ReactionRule ruleOf(Reaction reaction) {
  constexpr double NO_END = std::numeric_limits<double>::infinity();
  switch (reaction) {
    case Reaction::SURPRISED:
      return {4.0, 30.0};
    case Reaction::CURIOUS:
      return {10.0, 30.0, 0.6, 1.2};
    case Reaction::SCARED:
      return {3.0, NO_END, 1.3};
    case Reaction::THREATENING:
      return {4.0, 40.0, 1.0, 0.6};
    case Reaction::REGULAR:
    case Reaction::INDIFFERENT:
      break;
  }
  return {};
}

constexpr double FORGET_FACTOR = 1.5;    // of the distance
const double SIGHT = toRadians(100.0);   // to either side
constexpr double PLACE_TOLERANCE = 0.3;  // [m]; a place moves with the robot
constexpr double FLIGHT_STEP = 2.0;      // [m]
// From the direction away from the robot [degrees]:
constexpr std::array<double, 5> FLIGHT_TURNS{0.0, 40.0, -40.0, 80.0, -80.0};

bool hasClearSight(const Agent& agent, const Robot& robot, const World& world) {
  return world.walls().index().isClear(agent.pose.position, robot.pose.position, 0.0);
}

bool looksAt(const Vector2& place, const Agent& agent) {
  const Vector2 way = place - agent.pose.position;
  return way == Vector2::Zero() || std::abs(wrapAngle(bearingOf(way) - agent.pose.heading)) <= SIGHT;
}

/// The unit vector from a robot to an agent.
Vector2 directionFrom(const Robot& robot, const Agent& agent) {
  const Vector2 way = agent.pose.position - robot.pose.position;
  const double length = way.norm();
  return length > 0.0 ? Vector2(way / length) : unitVector(robot.pose.heading);
}

void standAndLook(const Vector2& place, AgentId id, World& world) {
  world.walkingAgent(id).setHeld(Hold::REACTION, true);
  turnTowards(place, id, world);
}

}  // namespace

void RobotReactions::update(World& world, const FreedomOf& freedom_of, const std::function<void(AgentId)>& begins) {
  const auto is_gone = [&](const Person& person) { return !world.isActive(person.id); };
  people_.erase(std::remove_if(people_.begin(), people_.end(), is_gone), people_.end());
  for (Person& person : people_) {
    const Agent& agent = world.agents()[person.id];
    const ReactionRule rule = ruleOf(person.reaction);
    const Freedom freedom = agent.at_goal ? Freedom::NOTHING : freedom_of(agent);
    const bool walks = person.reaction == Reaction::CURIOUS || person.reaction == Reaction::THREATENING;
    const bool may = freedom == Freedom::WALK || (freedom == Freedom::STAY && !walks);
    if (person.phase == Phase::UNAWARE) {
      if (!may || agent.isHeld() || !meets(person, agent, world)) continue;
      begins(person.id);
      person.phase = Phase::REACTING;
      person.end = world.time() + rule.time - TIME_ROUNDING;
      const double most = limits::SPEED.most / agent.wanted_speed;
      world.walkingAgent(person.id).setPace(Pace::REACTION, std::min(rule.pace, most));
    }
    const Robot& robot = world.robots()[person.robot];
    const double distance = (robot.pose.position - agent.pose.position).norm();
    const bool is_hidden = person.reaction == Reaction::SCARED && !hasClearSight(agent, robot, world);
    if (distance > FORGET_FACTOR * rule.distance || is_hidden) {
      finish(person, Phase::UNAWARE, world);
    } else if (person.phase == Phase::REACTING && (!may || world.time() >= person.end)) {
      finish(person, Phase::DONE, world);
    } else if (person.phase == Phase::REACTING) {
      react(person, freedom, world);
    }
  }
}

/// Whether there is a robot to react to; the nearest one.
bool RobotReactions::meets(Person& person, const Agent& agent, const World& world) const {
  double nearest = ruleOf(person.reaction).distance;
  bool found = false;
  for (RobotId id = 0; id < world.robots().size(); ++id) {
    const Robot& robot = world.robots()[id];
    const double distance = (robot.pose.position - agent.pose.position).norm();
    if (!robot.start.perceived || distance > nearest || (found && distance == nearest)) continue;
    if (!looksAt(robot.pose.position, agent) || !hasClearSight(agent, robot, world)) continue;
    nearest = distance;
    person.robot = id;
    found = true;
  }
  return found;
}

void RobotReactions::react(Person& person, Freedom freedom, World& world) const {
  const Agent& agent = world.agents()[person.id];
  const Robot& robot = world.robots()[person.robot];
  const double gap = robot.perceived_radius + agent.radius + ruleOf(person.reaction).gap;
  if (person.reaction == Reaction::SURPRISED) {
    standAndLook(robot.pose.position, person.id, world);
  } else if (person.reaction == Reaction::CURIOUS) {
    stayAt(robot.pose.position + gap * directionFrom(robot, agent), person, world);
  } else if (person.reaction == Reaction::THREATENING) {
    stayAt(robot.pose.position + gap * unitVector(robot.pose.heading), person, world);
  } else if (freedom == Freedom::WALK) {
    flee(person, world);
  }
}

void RobotReactions::stayAt(const Vector2& place, Person& person, World& world) const {
  Agent& agent = world.walkingAgent(person.id);
  if ((place - agent.pose.position).norm() <= PLACE_TOLERANCE) {
    dropPlace(person, agent);
    return standAndLook(world.robots()[person.robot].pose.position, person.id, world);
  }
  agent.setHeld(Hold::REACTION, false);
  if (canWalk(agent, place, world)) {
    walkTo(place, person, agent);
  } else {
    dropPlace(person, agent);
  }
}

void RobotReactions::flee(Person& person, World& world) const {
  Agent& agent = world.walkingAgent(person.id);
  const Robot& robot = world.robots()[person.robot];
  const double distance = (agent.pose.position - robot.pose.position).norm();
  const bool flees = person.place && agent.goal() == *person.place;
  if (flees && (*person.place - robot.pose.position).norm() > distance) return;
  for (const double turn : FLIGHT_TURNS) {
    const double direction = bearingOf(directionFrom(robot, agent)) + toRadians(turn);
    const Vector2 place = agent.pose.position + FLIGHT_STEP * unitVector(direction);
    if (canWalk(agent, place, world)) return walkTo(place, person, agent);
  }
  dropPlace(person, agent);
}

void RobotReactions::walkTo(const Vector2& place, Person& person, Agent& agent) {
  if (!person.place || agent.goal() != *person.place) {
    agent.insertGoal(place);
  } else if ((place - *person.place).norm() > PLACE_TOLERANCE) {
    agent.replaceGoal(place);
  } else {
    return;  // another goal costs another way
  }
  person.place = place;
}

bool RobotReactions::canWalk(const Agent& agent, const Vector2& place, const World& world) const {
  return places_.fits(place, agent.radius, world) &&
         world.walls().index().isClear(agent.pose.position, place, agent.radius);
}

void RobotReactions::dropPlace(Person& person, Agent& agent) {
  const bool walks_there = person.place && agent.goal() == *person.place;
  if (walks_there && agent.next_goal + 1 < agent.goals.size()) agent.passGoal();  // else a user has set this goal
  person.place.reset();
}

void RobotReactions::finish(Person& person, Phase phase, World& world) {
  Agent& agent = world.walkingAgent(person.id);
  if (person.phase == Phase::REACTING) {
    dropPlace(person, agent);
    agent.setHeld(Hold::REACTION, false);
    agent.setPace(Pace::REACTION, 1.0);
  }
  person.phase = phase;
}

std::vector<RobotReactions::Person>::const_iterator RobotReactions::find(AgentId id) const {
  const auto before = [](const Person& person, AgentId sought) { return person.id < sought; };
  const auto found = std::lower_bound(people_.begin(), people_.end(), id, before);
  return found != people_.end() && found->id == id ? found : people_.end();
}

bool RobotReactions::isReacting(AgentId id) const {
  const auto found = find(id);
  return found != people_.end() && found->phase == Phase::REACTING;
}

void RobotReactions::forgetRobot(RobotId robot, World& world) {
  for (Person& person : people_) {
    if (person.phase == Phase::UNAWARE) continue;
    if (person.robot == robot) {
      if (world.isActive(person.id)) finish(person, Phase::UNAWARE, world);
      person.phase = Phase::UNAWARE;
    } else if (person.robot > robot) {
      --person.robot;
    }
  }
}

void RobotReactions::leave(AgentId id, bool for_good, World& world) {
  const auto found = people_.begin() + std::distance(people_.cbegin(), find(id));
  if (found == people_.end()) return;
  if (found->phase == Phase::REACTING && world.isActive(id)) finish(*found, Phase::DONE, world);
  if (for_good) people_.erase(found);
}

}  // namespace crowd
