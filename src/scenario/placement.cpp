#include "scenario/scenario.h"

#include <utility>

#include "common/text/numbers.h"
#include "geometry/impact.h"
#include "scenario/goal_checks.h"
#include "scenario/group_placement.h"
#include "scenario/obstacle_placement.h"
#include "scenario/person_kind.h"
#include "scenario/placed_bodies.h"
#include "scenario/population_spec.h"
#include "scenario/robot_placement.h"
#include "scenario/route_reach.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

/// Number of draws that require non-overlapping goals; later draws permit overlaps, since crowded goals may not fit.
constexpr int TRIES_FOR_SEPARATE_GOALS = 200;
constexpr int TRIES_BESIDE = 20;  // of a place beside the leader that no wall separates from it

/// The settings of a scenario and its walls, without bodies.
Scene emptyScene(const Scenario& scenario) {
  Scene scene;
  scene.name = scenario.name;
  scene.tick_duration = scenario.tick_duration;
  scene.max_ticks = scenario.max_ticks;
  scene.goal_tolerance = scenario.goal_tolerance;
  scene.collision_radius = scenario.collision_radius;
  scene.contact = scenario.contact;
  scene.motion = scenario.motion;
  scene.order = scenario.order;
  scene.walls = scenario.walls;
  scene.own_walls = scenario.walls.size();
  scene.way_finding = scenario.way_finding;
  scene.map = scenario.map;
  scene.map_file = scenario.map_file;
  scene.free_space = scenario.free_space;
  scene.free_radius = scenario.free_radius;
  scene.seed = scenario.seed;
  scene.ends = scenario.ends;
  scene.arrived = scenario.arrived;
  scene.population = scenario.population;
  if (scenario.map_walls) scene.walls.insert(scene.walls.end(), scenario.map_walls->begin(), scenario.map_walls->end());
  return scene;
}

/// Builds the scene of one episode. Fixed bodies are placed before drawn ones, so that drawn bodies avoid all of them
/// independently of the order in the file. Obstacles are placed before agents, because drawn goals avoid them.
class Placement {
 public:
  Placement(const Scenario& scenario, std::uint64_t run_seed, std::uint64_t episode, const StopRequest& stop)
      : scenario_(scenario),
        stop_(stop),
        random_(run_seed, KeyedRandom::PLACEMENT, {scenario.seed, episode}),
        robot_random_(run_seed, KeyedRandom::ROBOT_PLACEMENT, {scenario.seed, episode}),
        group_random_(run_seed, KeyedRandom::GROUPS, {scenario.seed, episode}),
        kind_random_(run_seed, KeyedRandom::KIND, {scenario.seed, episode}),
        reaction_random_(run_seed, KeyedRandom::REACTIONS, {scenario.seed, episode}),
        scene_(emptyScene(scenario)),
        placed_(scene_.walls) {
    scene_.population_seed = KeyedRandom(run_seed, KeyedRandom::POPULATION, {scenario.seed, episode}).next();
  }

  Scene place();

 private:
  void placeRecorded();
  void recordFixedGoals();

  /// What is demanded of goals that are drawn, as long as there is room.
  struct Demands {
    bool separate = true;   // from those of other agents
    bool connected = true;  // with the start, by a way
  };
  void drawKinds();
  void placeFixedAgents();
  void completeAgents();
  Vector2 drawPosition(const AgentGroup& group, const AgentStart& agent, int tries);
  void completeAgent(const AgentGroup& group, const Label& label, AgentStart& agent, Demands& demands);
  bool drawGoals(const AgentGroup& group, AgentStart& agent, const Demands& demands, int& unconnected);

  const Scenario& scenario_;
  const StopRequest& stop_;
  KeyedRandom random_;
  KeyedRandom robot_random_;
  KeyedRandom group_random_;
  KeyedRandom kind_random_;
  KeyedRandom reaction_random_;
  Scene scene_;
  PlacedBodies placed_;
};

Scene Placement::place() {
  for (const AgentGroup& group : scenario_.agents) {
    scene_.agents.resize(scene_.agents.size() + static_cast<std::size_t>(group.count));
  }
  std::size_t obstacle_count = 0;
  for (const ObstacleGroup& group : scenario_.obstacles) {
    obstacle_count += static_cast<std::size_t>(group.count);
  }
  scene_.obstacles.resize(obstacle_count, {ObstaclePath::atRest(Vector2::Zero()), 0.0});
  drawKinds();
  recordFixedGoals();
  placeObstacles(scenario_, ObstaclePosition::FIXED, random_, stop_, placed_, scene_);
  placeRecorded();
  placeFixedAgents();
  placeRobots(scenario_, true, robot_random_, placed_, scene_);
  requireFreeGoals(scenario_, placed_);
  placeObstacles(scenario_, ObstaclePosition::DRAWN, random_, stop_, placed_, scene_);
  completeAgents();
  placeObstacles(scenario_, ObstaclePosition::BETWEEN, random_, stop_, placed_, scene_);
  placeRobots(scenario_, false, robot_random_, placed_, scene_);
  assignGroups(scenario_, scene_);
  return std::move(scene_);
}

void Placement::recordFixedGoals() {
  for (const AgentGroup& group : scenario_.agents) {
    for (const Region& goal : group.goals) {
      if (goal.isFixed()) placed_.addGoal(goal.first, group.radius.high);
    }
    if (group.opposite && group.position.isFixed()) {
      placed_.addGoal(2.0 * *group.opposite - group.position.first, group.radius.high);
    }
  }
}

/// Adds the recorded people behind the obstacles. Only those who are there at the start take a place.
void Placement::placeRecorded() {
  for (std::size_t entry = 0; entry < scenario_.recorded.size(); ++entry) {
    const RecordedGroup& group = scenario_.recorded[entry];
    scene_.recorded.push_back(group.description);
    for (const Obstacle& person : group.people) {
      scene_.obstacles.push_back(person);
      if (!person.path.isPresent(0.0)) continue;
      placed_.add({"recorded", entry, group.line, 1, 1, person.person}, person.path.position(0.0), person.radius,
                  false);
    }
  }
}

void Placement::drawKinds() {
  forEachBody("agents", scenario_.agents, stop_,
              [&](const AgentGroup& group, const Label& /*label*/, std::size_t index) {
                if (!group.kinds.empty()) {
                  drawKind(group, scenario_.population->kinds, kind_random_.with(index), scene_.agents[index]);
                }
                drawReaction(group, reaction_random_.with(index), scene_.agents[index]);
              });
}

void Placement::placeFixedAgents() {
  forEachBody("agents", scenario_.agents, stop_, [&](const AgentGroup& group, const Label& label, std::size_t index) {
    if (!group.position.isFixed()) return;
    AgentStart& agent = scene_.agents[index];
    agent.position = group.position.first;
    if (!group.radius_of_kind) agent.radius = group.radius.draw(random_);
    if (const auto blocker = placed_.findBlocker(agent.position, agent.radius, -TOUCH_TOLERANCE)) {
      refuse(scenario_, label, overlapText(label.text(), blocker->name, blocker->depth));
    }
    placed_.add(label, agent.position, agent.radius, false);
  });
}

void Placement::completeAgents() {
  Demands demands;
  std::optional<Parties> parties;
  forEachBody("agents", scenario_.agents, stop_, [&](const AgentGroup& group, const Label& label, std::size_t index) {
    if (label.number == 1) {
      demands = Demands();
      parties.emplace(group.groups, group_random_);
    }
    AgentStart& agent = scene_.agents[index];
    const auto left = static_cast<std::size_t>(group.count - label.number + 1);
    agent.leader = leaderOf(group, parties->next(static_cast<AgentId>(index), left));
    completeAgent(group, label, agent, demands);
    if (!group.speed_of_kind) agent.max_speed = group.max_speed.draw(random_);
    const bool waits_for_goal = group.route || agent.leader;  // Episode determines the first goal
    if (!agent.leader) agent.route = group.route;
    agent.faces_goal = waits_for_goal && !group.heading;
    if (waits_for_goal) agent.goals = {agent.position};
    agent.leaves = !agent.leader;
    agent.stays = scenario_.arrived == Arrived::STAY;
    agent.heading = group.heading ? group.heading->draw(random_) : bearingOf(agent.goals.front() - agent.position);
    agent.heading = wrapAngle(agent.heading);
    agent.keeps_heading = group.keeps_heading;
    agent.velocity = group.velocity;
    agent.reaction_time = group.reaction_time.drawUnlessFixed(random_);
    agent.hurry = group.hurry.drawUnlessFixed(random_);
  });
}

/// A place in the region of the entry; for those who walk with another agent of the entry beside that one, if there is
/// room.
Vector2 Placement::drawPosition(const AgentGroup& group, const AgentStart& agent, int tries) {
  const bool follows = agent.leader && !group.leader && tries < MAX_TRIES / 2;
  if (!follows) return group.position.draw(random_, scene_.free_space.get());
  const Vector2& leader = scene_.agents[agent.leader->number].position;
  for (int i = 0; i < TRIES_BESIDE; ++i) {
    Vector2 place = placesBeside(leader, group.radius.high).draw(random_);
    if (placed_.canWalkBetween(leader, place)) return place;
  }
  return leader;  // taken
}

void Placement::completeAgent(const AgentGroup& group, const Label& label, AgentStart& agent, Demands& demands) {
  requireWay(scenario_, group, label);
  const bool placed = group.position.isFixed();
  int unconnected = 0;  // tries
  for (int tries = 0; tries < MAX_TRIES; ++tries) {
    demands.connected = demands.connected && unconnected < MAX_TRIES / 2;
    demands.separate = demands.separate && tries - unconnected < TRIES_FOR_SEPARATE_GOALS;
    if (!placed) {
      agent.position = drawPosition(group, agent, tries);
      if (!group.radius_of_kind) agent.radius = group.radius.draw(random_);
      if (placed_.findBlocker(agent.position, agent.radius, DRAWN_GAP)) {
        continue;
      }
    }
    if (!drawGoals(group, agent, demands, unconnected)) {
      continue;
    }
    if (!placed) {
      placed_.add(label, agent.position, agent.radius, false);
    }
    for (const Vector2& goal : agent.goals) {
      placed_.addGoal(goal, agent.radius);
    }
    return;
  }
  refuse(scenario_, label,
         label.text() + ": no free place for it and its goal found in " + std::to_string(MAX_TRIES) + " tries");
}

bool Placement::drawGoals(const AgentGroup& group, AgentStart& agent, const Demands& demands, int& unconnected) {
  agent.goals.clear();
  if (agent.leader) return true;
  const bool is_anywhere = group.position.kind == Region::Kind::FREE;
  if (group.route && is_anywhere) {
    return connectsRoute(*scene_.free_space, *scene_.population, *group.route, agent.position);
  }
  Vector2 from = agent.position;
  bool from_drawn = !group.position.isFixed();
  const std::size_t count = group.opposite ? 1 : group.goals.size();
  for (std::size_t i = 0; i < count; ++i) {
    const bool drawn = group.opposite ? from_drawn : !group.goals[i].isFixed();
    const Vector2 goal = group.opposite ? Vector2(2.0 * *group.opposite - agent.position)
                                        : group.goals[i].draw(random_, scene_.free_space.get());
    if ((drawn || from_drawn) && (goal - from).norm() <= scenario_.goal_tolerance) {
      return false;
    }
    const bool anywhere = drawn && !group.opposite && group.goals[i].kind == Region::Kind::FREE;
    if ((anywhere || is_anywhere) && !areConnected(*scene_.free_space, from, goal)) return false;
    const bool needs_way = demands.connected && group.reach && (drawn || from_drawn);
    if (needs_way && !group.reach->connects(from, goal)) {
      ++unconnected;
      return false;
    }
    if (drawn && !placed_.canStandAt(goal, agent.radius)) return false;
    if (drawn && demands.separate && placed_.isNearGoal(goal, agent.radius)) return false;
    agent.goals.push_back(goal);
    from = goal;
    from_drawn = drawn;
  }
  return true;
}

}  // namespace

Scene Scenario::instantiate(std::uint64_t run_seed, std::uint64_t episode, const StopRequest& stop) const {
  return Placement(*this, run_seed, episode, stop).place();
}

}  // namespace crowd
