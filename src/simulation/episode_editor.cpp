#include "simulation/episode_editor.h"

#include <memory>
#include <utility>
#include <vector>

#include "navigation/sized_floor.h"
#include "population/population_changes.h"
#include "population/route_check.h"
#include "simulation/episode.h"

namespace crowd {

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
