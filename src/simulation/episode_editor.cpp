#include "simulation/episode_editor.h"

#include <memory>
#include <utility>
#include <vector>

#include "common/text/quotes.h"
#include "geometry/finite_checks.h"
#include "navigation/sized_floor.h"
#include "population/changes/population_changes.h"
#include "population/changes/route_check.h"
#include "scenario/region_geometry.h"
#include "simulation/episode.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

/// Why a robot cannot be within the tolerance of a goal; empty if it can. Only the disc within its footprint is tested.
std::string goalProblemOf(const RobotStart& robot, const Vector2& goal, const Scene& scene, const World& world) {
  requirePlace("goal [m]", goal);
  if (scene.map != nullptr) {
    const Cell cell = CellFrame(*scene.map).cellAt(goal);
    if (!scene.map->contains(cell)) return "is beyond the map";
    if (!scene.map->isFree(cell)) return "is on a cell of the map that is not free";
  }
  const double inner = -distance(robot.footprint, Pose(), Vector2(0.0, 0.0));
  const double room = inner - robot.goal_tolerance;
  return room > 0.0 && world.walls().index().isAnyWithin(goal, room) ? "is in a wall" : "";
}

void requireGoal(const RobotStart& robot, const Vector2& goal, const Scene& scene, const World& world) {
  const std::string problem = goalProblemOf(robot, goal, scene, world);
  if (!problem.empty()) throw InputError("the goal " + placeText(goal) + " " + problem);
}

}  // namespace

EpisodeEditor::EpisodeEditor(Episode& episode) : WorldEditor(episode.world_), episode_(episode) {}

AgentId EpisodeEditor::addAgent(AgentStart start) {
  start.stays = episode_.scene_.arrived == Arrived::STAY;
  return spawnAgent(start);
}

void EpisodeEditor::review(const WorldChange& change) {
  if (!episode_.findsWays()) return;
  requireNavigableFloor(world_, change, episode_.scene_);
  if (change.agent == nullptr) return;
  const Agent& agent = *change.agent;
  const std::string name = change.start != nullptr ? "the agent" : "agent " + std::to_string(agent.id);
  episode_.way_lengths_.requireWay(name, world_, agent.pose.position, agent.goal(), agent.radius);
}

void EpisodeEditor::note(const WorldChange& change) {
  if (change.start != nullptr) episode_.monitor_.watch(*change.start, world_);
  if (change.new_goal) {
    episode_.population_.dropRoute(change.agent->id, world_, episode_.monitor_);
    episode_.monitor_.recordGoal(*change.agent, change.agent->goal());
  }
  if (change.fewer_walls) episode_.population_.updateGates(world_);
  episode_.noteChange();
}

void EpisodeEditor::sendRobot(RobotId id, const Vector2& goal) {
  requireGoal(world_.robots().require(id).start, goal, episode_.scene_, world_);
  episode_.robots().send(id, goal);
}

RobotId EpisodeEditor::addRobot(const RobotStart& start) {
  for (const Robot& other : world_.robots()) {
    if (other.start.name == start.name) throw InputError("there is a robot " + inQuotes(start.name) + " already");
    if (other.start.name_space == start.name_space) {
      throw InputError("robot " + inQuotes(other.start.name) + " is in the namespace " + inQuotes(start.name_space));
    }
  }
  const std::string blocker = world_.blockerAt(start.position, start.footprint.reach(), false);
  if (!blocker.empty()) throw InputError("the place is taken by " + blocker);
  for (const Vector2& goal : start.goals) requireGoal(start, goal, episode_.scene_, world_);
  episode_.scene_.robots.push_back(start);
  const RobotId id = episode_.robots().add(start);
  episode_.robot_monitor_.add(world_);
  note({});
  return id;
}

void EpisodeEditor::removeRobot(RobotId id) {
  const std::string name = world_.robots().require(id).start.name;
  const auto follows = [&](const std::optional<Leader>& leader) {
    return leader && leader->kind == Leader::Kind::ROBOT && leader->number >= id;
  };
  for (const AgentStart& agent : episode_.scene_.agents) {
    if (follows(agent.leader)) throw InputError("agents follow robot " + inQuotes(name) + ", or one after it");
  }
  episode_.scene_.robots.erase(episode_.scene_.robots.begin() + id);
  episode_.population_.forgetRobot(id, world_);
  episode_.robots().remove(id);
  episode_.robot_monitor_.remove(id);
  note({});
}

void EpisodeEditor::replaceMap(std::shared_ptr<const OccupancyMap> map, const std::vector<Segment>& map_walls) {
  Scene& scene = episode_.scene_;
  std::vector<Segment> walls(scene.walls.begin(), scene.walls.begin() + static_cast<std::ptrdiff_t>(scene.own_walls));
  walls.insert(walls.end(), map_walls.begin(), map_walls.end());
  replaceWalls(std::move(walls));
  scene.map = std::move(map);
}

void EpisodeEditor::replaceCrowd(std::vector<Agent>& agents, std::vector<EpisodeMonitor::Track>& tracks) {
  agents = replaceAgents(std::move(agents));
  tracks = episode_.monitor_.replaceTracks(world_.agents(), tracks);
}

void EpisodeEditor::setRoute(AgentId id, const std::string& route) {
  WayLengths* const ways = episode_.findsWays() ? &episode_.way_lengths_ : nullptr;
  episode_.population_.setRoute(id, route, ways, world_, episode_.monitor_);
  note({});
}

bool EpisodeEditor::setGate(const std::string& gate, bool open) {
  const bool is_open = episode_.population_.setGate(gate, open, world_);
  note({});
  return is_open;
}

std::size_t EpisodeEditor::raiseAlarm(AlarmDescription alarm) {
  alarm.time = 0.0;
  PopulationDescription population = withAlarm(episode_.scene_, alarm);
  const std::size_t count = episode_.population_.raiseAlarm(std::move(alarm), world_, episode_.monitor_);
  episode_.scene_.population = std::make_shared<const PopulationDescription>(std::move(population));
  note({});
  return count;
}

void EpisodeEditor::adopt(PopulationDescription population) {
  episode_.scene_.population = std::make_shared<const PopulationDescription>(std::move(population));
  episode_.way_finder_ = WayFinder(episode_.scene_);
  episode_.way_lengths_ = WayLengths(episode_.scene_);
}

std::size_t EpisodeEditor::addSource(const SourceDescription& source) {
  const Scene& scene = episode_.scene_;
  PopulationDescription population = withSource(scene, source, world_.walls().list());
  const AgentGroup& agents = source.agents;
  if (episode_.findsWays()) {
    WayLengths ways(scene);
    const Vector2& from = agents.position.first;
    if (agents.route) {
      RouteCheck("an agent of the source", agents.radius.high, population, PlacePicker(scene), ways, world_)
          .require(population.routes[*agents.route], from);
    } else {
      ways.requireWay("an agent of the source", world_, from, agents.goals.front().first, agents.radius.high);
    }
  }
  adopt(std::move(population));
  episode_.population_.addSource(scene, world_);
  note({});
  return scene.population->sources.size() - 1;
}

void EpisodeEditor::addGate(const GateDescription& gate) {
  PopulationDescription population = withGate(episode_.scene_, gate);
  std::vector<Segment> walls = world_.walls().list();
  walls.push_back(gate.wall);
  WorldChange change;
  change.walls = &walls;
  review(change);  // also with agents in the gate: it waits for them
  adopt(std::move(population));
  episode_.population_.addGate(episode_.scene_, world_);
  change.fewer_walls = true;
  note(change);
}

}  // namespace crowd
