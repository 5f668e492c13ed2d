#include "social_crowd/simulation/episode.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "geometry/finite_checks.h"
#include "social_crowd/common/errors.h"
#include "social_crowd/population/population_changes.h"
#include "social_crowd/population/route_check.h"

namespace crowd {
namespace {

Scene withFirstGoals(Scene scene, const StopRequest& stop) {
  Population::chooseFirstGoals(scene, stop);
  return scene;
}

}  // namespace

Episode::Episode(Scene scene, std::uint64_t number, const Vision& vision, ThreadPool& thread_pool, StopRequest stop)
    : scene_(withFirstGoals(std::move(scene), stop)),
      world_(scene_, std::move(stop)),
      vision_(vision),
      thread_pool_(&thread_pool),
      monitor_(scene_, world_),
      robot_monitor_(world_),
      population_(scene_),
      way_finder_(scene_),
      way_lengths_(scene_),
      number_(number) {
  population_.begin(world_, monitor_);
  noteChange();
}

void Episode::noteChange() {
  ++changes_;
  are_current_ = false;
  if (!findsWays()) return;
  try {
    way_finder_.update(world_);
  } catch (const InputError& error) {  // the floor is too large
    way_finding_problem_ = error.what();
    WayFinder::release(world_);
  }
}

template <typename Change>
void Episode::requireFloorAfter(const Change& change) const {
  if (!findsWays()) return;
  World trial = world_;
  change(trial);
  requireNavigableFloor(trial, largestSourceRadius(scene_));
}

void Episode::noteWalls() {
  population_.updateGates(world_);
  noteChange();
}

void Episode::setVision(const Vision& vision) {
  vision_ = vision;
  are_current_ = false;
}

bool Episode::step(const std::vector<AgentAction>& actions) {
  world_.stopRequest().throwIfMade();
  if (!isSequential()) {
    world_.step(actions, *thread_pool_);
    return endTick();
  }
  world_.moveAgent(turn_, actions);
  are_current_ = false;
  ++turn_;
  if (findTurn()) return false;
  world_.endTick(*thread_pool_);
  turn_ = 0;
  return endTick();
}

bool Episode::endTick() {
  population_.update(world_, monitor_);
  world_.stopRequest().throwIfMade();
  monitor_.observe(world_, *thread_pool_);
  if (!world_.robots().empty()) robot_monitor_.observe(world_);
  noteChange();
  return true;
}

bool Episode::findTurn() {
  const AgentMap<Agent>& agents = world_.agents();
  std::size_t position = agents.lowerBound(turn_);
  while (position < agents.size() && !world_.isPerceiving(agents.idAt(position))) ++position;
  const bool found = position < agents.size();
  turn_ = found ? agents.idAt(position) : static_cast<AgentId>(world_.enteredCount());
  return found;
}

bool Episode::isOver() const {
  if (world_.tick() >= scene_.max_ticks) return true;
  const bool crowd_is_done = world_.activeCount() == 0 && !population_.expectsAgents();
  if (world_.robots().empty()) return crowd_is_done;
  bool has_goal = false;
  for (const Robot& robot : world_.robots()) {
    if (robot.hasGoal() && !robot.hasArrived()) return false;
    has_goal = has_goal || robot.hasGoal();
  }
  if (scene_.ends == Ends::ROBOTS) return has_goal;
  return crowd_is_done && (has_goal || world_.enteredCount() > 0);
}

EpisodeResult Episode::result() const {
  EpisodeResult result = monitor_.result();
  result.robots = robot_monitor_.results();
  result.way_finding_problem = way_finding_problem_;
  if (!findsWays()) return result;
  for (const Agent& agent : world_.agents()) {
    if (agent.isWalking()) result.agents.add(agent.id).out_of_reach = way_finder_.isOutOfReach(agent.id);
  }
  return result;
}

const Perceptions& Episode::perceptions() {
  if (are_current_) return *perceptions_;
  if (may_be_held_) {
    perceptions_.reset();
    perceptions_ = buffers_.next();
    may_be_held_ = false;
  }
  perceptions_->turn = 0;
  if (!isSequential() || isOver()) {
    world_.perceive(vision_, *perceptions_);
  } else {
    perceiveTurn();
  }
  perceptions_->episode = number_;
  perceptions_->last = isOver();
  are_current_ = true;
  return *perceptions_;
}

std::shared_ptr<const Perceptions> Episode::sharedPerceptions() {
  perceptions();
  may_be_held_ = true;
  return perceptions_;
}

void Episode::perceiveTurn() {
  // There is no agent if the remaining ones were removed after the previous turn.
  const bool found = findTurn();
  world_.perceiveAgent(vision_, found ? std::optional<AgentId>(turn_) : std::nullopt, *perceptions_);
  perceptions_->turn = turn_;
}

void Episode::decide(Learner& learner, RelativeActions& actions) {
  if (learner.mode() != Mode::DEMO || isSequential()) return learner.decide(perceptions(), actions);
  actions.episode = number_;
  actions.tick = world_.tick();
  actions.agents.clear();
  if (!isOver()) crowd_.decide(world_, number_, vision_, learner, actions.agents, *thread_pool_);
}

AgentId Episode::spawnAgent(const AgentStart& start) {
  for (const Vector2& goal : start.goals) requirePlace("goal [m]", goal);
  requireFloorAfter([&](World& world) { world.spawnAgent(start); });
  if (findsWays()) way_lengths_.requireWay("the agent", world_, start.position, start.goals.front(), start.radius);
  const AgentId id = world_.spawnAgent(start);
  monitor_.watch(start, world_);
  noteChange();
  return id;
}

void Episode::removeAgent(AgentId id) {
  world_.removeAgent(id);
  noteChange();
}

void Episode::setGoal(AgentId id, const Vector2& goal) {
  requirePlace("goal [m]", goal);
  requireFloorAfter([&](World& world) { world.setGoal(id, goal); });
  if (findsWays()) {
    const Agent& agent = world_.agents()[id];
    way_lengths_.requireWay("agent " + std::to_string(id), world_, agent.pose.position, goal, agent.radius);
  }
  world_.setGoal(id, goal);
  population_.dropRoute(id, world_, monitor_);
  monitor_.recordGoal(world_.agents()[id], goal);
  noteChange();
}

std::size_t Episode::spawnObstacle(const Vector2& position, const Vector2& velocity, double radius) {
  requireFloorAfter([&](World& world) { world.spawnObstacle(position, velocity, radius); });
  const std::size_t number = world_.spawnObstacle(position, velocity, radius);
  noteChange();
  return number;
}

void Episode::moveObstacle(std::size_t number, const Vector2& position) {
  requireFloorAfter([&](World& world) { world.moveObstacle(number, position); });
  world_.moveObstacle(number, position);
  noteChange();
}

void Episode::removeObstacle(std::size_t number) {
  world_.removeObstacle(number);
  noteChange();
}

void Episode::teleport(AgentId id, const Pose& pose) {
  requireFloorAfter([&](World& world) { world.teleport(id, pose); });
  if (findsWays()) {
    const Agent& agent = world_.agents()[id];
    way_lengths_.requireWay("agent " + std::to_string(id), world_, pose.position, agent.goal(), agent.radius);
  }
  world_.teleport(id, pose);
  noteChange();
}

void Episode::teleportRobot(RobotId id, const Pose& pose) {
  world_.teleportRobot(id, pose);
  noteChange();
}

std::size_t Episode::addWall(const Segment& wall) {
  requireFloorAfter([&](World& world) { world.addWall(wall); });
  const std::size_t id = world_.addWall(wall);
  noteChange();
  return id;
}

void Episode::removeWall(std::size_t id) {
  world_.removeWall(id);
  noteWalls();
}

void Episode::replaceWalls(std::vector<Segment> walls) {
  requireFloorAfter([&](World& world) { world.replaceWalls(walls); });
  world_.replaceWalls(std::move(walls));
  noteWalls();
}

void Episode::setRoute(AgentId id, const std::string& route) {
  population_.setRoute(id, route, findsWays() ? &way_lengths_ : nullptr, world_, monitor_);
  noteChange();
}

bool Episode::setGate(const std::string& gate, bool open) {
  const bool is_open = population_.setGate(gate, open, world_);
  noteChange();
  return is_open;
}

void Episode::adopt(PopulationDescription population) {
  scene_.population = std::make_shared<const PopulationDescription>(std::move(population));
  way_finder_ = WayFinder(scene_);
  way_lengths_ = WayLengths(scene_);
}

std::size_t Episode::addSource(const SourceDescription& source) {
  PopulationDescription population = withSource(scene_, source, world_.walls());
  const AgentGroup& agents = source.agents;
  if (findsWays()) {
    WayLengths ways(scene_);
    const Vector2& from = agents.position.first;
    if (agents.route) {
      RouteCheck("an agent of the source", agents.radius.high, population, PlacePicker(scene_), ways, world_)
          .require(population.routes[*agents.route], from);
    } else {
      ways.requireWay("an agent of the source", world_, from, agents.goals.front().first, agents.radius.high);
    }
  }
  adopt(std::move(population));
  population_.addSource(scene_, world_);
  noteChange();
  return scene_.population->sources.size() - 1;
}

void Episode::addGate(const GateDescription& gate) {
  PopulationDescription population = withGate(scene_, gate);
  requireFloorAfter([&](World& world) {  // with agents in the gate: it waits for them
    std::vector<Segment> walls = world.walls();
    walls.push_back(gate.wall);
    world.replaceWalls(std::move(walls));
  });
  adopt(std::move(population));
  population_.addGate(scene_, world_);
  noteWalls();
}

}  // namespace crowd
