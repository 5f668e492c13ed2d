#include "population/population.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/limits.h"
#include "population/entry_velocity.h"
#include "population/facing.h"
#include "scenario/region_geometry.h"
#include "world/world_editor.h"

namespace crowd {
namespace {

using Kind = WaypointDescription::Kind;

/// What is drawn, as part of the keys of random numbers.
enum Drawn : std::uint64_t { SOURCE = 0, ROUTE = 1, QUEUE = 2 };

KeyedRandom randomOf(std::uint64_t seed, Drawn what, std::uint64_t number) {
  return {seed, KeyedRandom::POPULATION, {what, number}};
}

}  // namespace

Population::Population(const Scene& scene)
    : description_(scene.population ? scene.population : std::make_shared<const PopulationDescription>()),
      seed_(scene.population_seed),
      places_(scene),
      ways_(scene),
      followers_(places_),
      distraction_(seed_),
      attractions_(scene, description_->attractions, seed_),
      reactions_(places_),
      alarms_(description_->alarms) {
  const auto is_member = [&](const AgentStart& start) {
    const bool reacts = RobotReactions::isSpecial(start.reaction) && !scene.robots.empty();
    return start.route || start.leader || start.reaction_time > 0.0 || reacts || description_->pausesOf(start.kind);
  };
  if (std::any_of(scene.agents.begin(), scene.agents.end(), is_member)) starts_ = scene.agents;
  for (std::size_t i = 0; i < description_->sources.size(); ++i) {
    sources_.emplace_back(*description_, i, randomOf(seed_, SOURCE, i));
  }
  for (std::size_t i = 0; i < description_->queues.size(); ++i) {
    queues_.emplace_back(description_->queues[i], randomOf(seed_, QUEUE, i));
  }
  for (const GateDescription& gate : description_->gates) gates_.emplace_back(gate);
}

void Population::chooseFirstGoals(Scene& scene, const StopRequest& stop) {
  const auto needs_goal = [](const AgentStart& start) { return start.route || start.leader; };
  if (std::none_of(scene.agents.begin(), scene.agents.end(), needs_goal)) return;
  const World world(scene, stop);
  Population population(scene);
  for (std::size_t i = 0; i < scene.agents.size(); ++i) {
    AgentStart& start = scene.agents[i];
    if (!start.route) continue;
    stop.throwIfMade();
    Member member;
    member.route.emplace(population.description_->routes[*start.route],
                         population.randomOfRoute(static_cast<AgentId>(i), world.tick()));
    start.goals = {population.goalOfLeg(member, start.position, start.radius, world)};
  }
  population.chooseGoalsOfFollowers(scene, world);
  for (AgentStart& start : scene.agents) {
    if (start.faces_goal) start.heading = wrapAngle(bearingOf(start.goals.front() - start.position));
  }
}

void Population::chooseGoalsOfFollowers(Scene& scene, const World& world) const {
  std::map<GroupId, std::size_t> counts;  // of followers
  for (AgentStart& start : scene.agents) {
    if (!start.leader) continue;
    const std::size_t number = counts[groupOf(*start.leader)]++;
    if (start.leader->kind == Leader::Kind::ROBOT) {
      start.goals = {followers_.goalBehind(start.leader->number, number, start.radius, world)};
    } else {
      const AgentStart& leader = scene.agents[start.leader->number];
      start.goals = followers_.goalsBeside(leader.goals, leader.position, number, start.radius, world);
    }
  }
}

KeyedRandom Population::randomOfRoute(AgentId id, std::uint64_t tick) const {
  return randomOf(seed_, ROUTE, id).with(tick);
}

Population::Member* Population::find(AgentId id) {
  const auto before = [](const Member& member, AgentId sought) { return member.id < sought; };
  const auto found = std::lower_bound(members_.begin(), members_.end(), id, before);
  return found != members_.end() && found->id == id ? &*found : nullptr;
}

void Population::begin(World& world, RouteObserver& observer) {
  for (std::size_t i = 0; i < starts_.size(); ++i) admit(static_cast<AgentId>(i), starts_[i], world, observer);
  for (std::size_t i = 0; i < starts_.size(); ++i) follow(static_cast<AgentId>(i), starts_[i], world, observer);
  starts_.clear();
  raiseAlarms(world, observer);
  updateGates(world);
  spawn(world, observer);
}

void Population::admit(AgentId id, const AgentStart& start, World& world, RouteObserver& observer) {
  if (const auto pauses = description_->pausesOf(start.kind)) distraction_.add(id, *pauses, world.time());
  if (RobotReactions::isSpecial(start.reaction) && !world.robots().empty()) reactions_.add(id, start.reaction);
  if (!start.route && start.reaction_time <= 0.0) return;
  world.stopRequest().throwIfMade();
  Member& member = members_.emplace_back();
  member.id = id;
  member.reacts_at = world.time() + start.reaction_time - TIME_ROUNDING;
  if (start.route) {
    member.route.emplace(description_->routes[*start.route], randomOfRoute(id, world.tick()));
    world.walkingAgent(id).leaves = false;
    observer.setEndless(id, member.route->repeats());
    beginLeg(member, world);
  }
  hold(member, world);
}

void Population::follow(AgentId id, const AgentStart& start, const World& world, RouteObserver& observer) {
  if (start.leader) followers_.add(id, *start.leader, isEndless(*start.leader, world), world, observer);
}

Vector2 Population::goalOfLeg(Member& member, const Vector2& from, double radius, const World& world) {
  const WaypointDescription& waypoint = member.route->waypoint();
  if (waypoint.kind == Kind::PLACE) {
    return places_.drawGoal(waypoint.place, from, radius, member.route->random(), world, ways_.reachIn(world));
  }
  if (waypoint.kind == Kind::QUEUE) return queues_[waypoint.target].end();
  member.sink = waypoint.target;
  if (waypoint.kind == Kind::SINK) return places_.nearestIn(description_->sinks[member.sink].area, from, radius, world);
  const PlaceWays::Exit exit = ways_.nearestSink(description_->sinks, places_, from, radius, world);
  member.sink = exit.sink;
  return exit.place;
}

void Population::beginLeg(Member& member, World& world) {
  const Agent& agent = world.agents()[member.id];
  const Vector2 goal = goalOfLeg(member, agent.pose.position, agent.radius, world);
  const WaypointDescription& waypoint = member.route->waypoint();
  if (waypoint.kind == Kind::QUEUE) queues_[waypoint.target].join(member.id);
  const bool has_others = agent.next_goal + 1 < agent.goals.size();
  if (goal != agent.goal() || agent.at_goal || has_others) world.walkingAgent(member.id).setGoal(goal);
}

void Population::advance(Member& member, World& world, RouteObserver& observer) {
  observer.countWaypoint(member.id);
  const Kind kind = member.route->waypoint().kind;
  if (!member.route->advance()) {
    // Whoever stays at the head of a queue stands in the way of all others.
    return kind == Kind::PLACE ? WorldEditor(world).arrive(member.id) : WorldEditor(world).leave(member.id);
  }
  beginLeg(member, world);
  observer.extendWay(world.agents()[member.id]);
}

void Population::walk(Member& member, World& world, RouteObserver& observer) {
  if (!member.route || world.time() < member.reacts_at) return;
  const Agent& agent = world.agents()[member.id];
  const Kind kind = member.route->waypoint().kind;
  if (kind == Kind::QUEUE) return;
  if (kind == Kind::PLACE) {
    if (agent.at_goal && !member.route->isWaiting()) member.route->beginWait(world.time());
    if (member.route->hasWaited(world.time())) advance(member, world, observer);
  } else if (agent.at_goal || contains(description_->sinks[member.sink].area, agent.pose.position)) {
    advance(member, world, observer);
  }
}

/// Agents stand before they react, while they wait at a place, and in their places in line.
void Population::hold(const Member& member, World& world) const {
  const Agent& agent = world.agents()[member.id];
  const bool has_reacted = world.time() >= member.reacts_at;
  const auto stands_on_route = [&](const RouteFollower& route) {
    if (route.waypoint().kind != Kind::QUEUE) return route.isWaiting();
    return queues_[route.waypoint().target].stands(member.id, world);
  };
  const bool stands = member.route && stands_on_route(*member.route);
  const bool is_held = stands || !has_reacted;
  if (agent.isHeldBy(Hold::ROUTE) != is_held) world.walkingAgent(member.id).setHeld(Hold::ROUTE, is_held);
}

/// Those who wait at a place, or are served, look where they are to look.
void Population::face(const Member& member, World& world) const {
  if (!member.route) return;
  const WaypointDescription& waypoint = member.route->waypoint();
  const FacingDescription* face = nullptr;
  if (waypoint.kind == Kind::QUEUE) {
    face = queues_[waypoint.target].facingOf(member.id);
  } else if (waypoint.face && member.route->isWaiting()) {
    face = &*waypoint.face;
  }
  if (face != nullptr) turnTowards(*face, member.id, world);
}

void Population::serveQueues(World& world, RouteObserver& observer) {
  for (Queue& queue : queues_) {
    for (const AgentId id : queue.update(world)) advance(*find(id), world, observer);
  }
}

/// Sets the first goal of an agent of a source, if its route or its leader has it, and its velocity.
void Population::completeStart(AgentId id, AgentStart& start, const World& world) {
  if (start.route) {
    Member member;
    member.route.emplace(description_->routes[*start.route], randomOfRoute(id, world.tick()));
    start.goals = {goalOfLeg(member, start.position, start.radius, world)};
  }
  if (start.leader) {
    const Agent& leader = world.agents()[start.leader->number];
    const std::size_t number = followers_.countOf(*start.leader);
    start.goals = followers_.goalsBeside(leader.goals, leader.pose.position, number, start.radius, world);
  }
  start.heading = bearingOf(start.goals.front() - start.position);
  start.velocity = entryVelocity(start, world);
}

void Population::spawn(World& world, RouteObserver& observer) {
  for (AgentSource& source : sources_) {
    while (world.activeCount() < limits::BODIES) {
      std::optional<AgentStart> start = source.next(world, places_, ways_.reachIn(world));
      if (!start) break;
      world.stopRequest().throwIfMade();
      const auto id = static_cast<AgentId>(world.enteredCount());
      completeStart(id, *start, world);
      WorldEditor(world).spawnAgent(*start);
      observer.watch(*start, world);
      admit(id, *start, world, observer);
      follow(id, *start, world, observer);
    }
  }
}

void Population::updateAll(World& world, RouteObserver& observer) {
  const auto is_gone = [&](const Member& member) {
    if (world.isActive(member.id)) return false;
    for (Queue& queue : queues_) queue.leave(member.id);
    return true;
  };
  const auto is_done = [&](const Member& member) { return !member.route && world.time() >= member.reacts_at; };
  members_.erase(std::remove_if(members_.begin(), members_.end(), is_gone), members_.end());
  updateGates(world);
  for (Member& member : members_) walk(member, world, observer);
  serveQueues(world, observer);
  members_.erase(std::remove_if(members_.begin(), members_.end(), is_gone), members_.end());
  raiseAlarms(world, observer);
  updateAttractions(world, observer);
  updateReactions(world);
  for (const Member& member : members_) hold(member, world);
  for (const Member& member : members_) face(member, world);
  members_.erase(std::remove_if(members_.begin(), members_.end(), is_done), members_.end());
  distraction_.update(world);
  followers_.update(world, observer);  // after what their leaders do
  spawn(world, observer);
}

void Population::updateGates(World& world) {
  for (Gate& gate : gates_) gate.update(world);
}

bool Population::expectsAgents() const {
  return std::any_of(sources_.begin(), sources_.end(), [](const AgentSource& source) { return !source.isOver(); });
}

/// Whether an agent's leader never arrives.
bool Population::isEndless(const Leader& leader, const World& world) {
  if (leader.kind == Leader::Kind::ROBOT) return !world.robots().require(leader.number).hasGoal();
  const Member* const member = find(leader.number);
  return member != nullptr && member->route && member->route->repeats();
}

void Population::adopt(const Scene& scene, PopulationDescription description) {
  earlier_.push_back(description_);
  description_ = std::make_shared<const PopulationDescription>(std::move(description));
  ways_ = PlaceWays(scene);
}

void Population::addSource(const Scene& scene, const World& world) {
  PopulationDescription description = *scene.population;
  SourceDescription& source = description.sources.back();
  source.from = std::max(source.from, world.time());
  adopt(scene, std::move(description));
  const std::size_t index = description_->sources.size() - 1;
  sources_.emplace_back(*description_, index, randomOf(seed_, SOURCE, index));
}

void Population::addGate(const Scene& scene, World& world) {
  adopt(scene, *scene.population);
  gates_.emplace_back(description_->gates.back()).update(world);
}

}  // namespace crowd
