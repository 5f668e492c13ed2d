#include "social_crowd/world/scenario.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "social_crowd/common/errors.h"
#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

/// Maximum number of draws of a body before the scenario is rejected.
constexpr int MAX_TRIES = 1000;
/// Number of draws that require non-overlapping goals; later draws permit overlaps, since crowded goals may not fit.
constexpr int TRIES_FOR_SEPARATE_GOALS = 200;

/// Name of a body in messages: its entry in the file, and its number among the bodies of that entry.
struct Label {
  const char* list;
  std::size_t entry;
  int line;
  int number;
  int count;

  std::string text() const {
    const std::string name = std::string(list) + "[" + std::to_string(entry) + "]";
    return count == 1 ? name : name + " (" + std::to_string(number) + " of " + std::to_string(count) + ")";
  }
};

/// A disc whose position is determined.
struct PlacedBody {
  Label label;
  Vector2 centre;
  double radius;
  bool at_rest;  ///< static during the whole episode
};

/// A goal whose position is determined, and the radius of its agent.
struct PlacedGoal {
  Vector2 point;
  double radius;
};

/// A body or wall that overlaps a requested position, and the depth of the overlap [m].
struct Blocker {
  std::string name;
  double depth;
};

/// Builds the scene of one episode. Fixed bodies are placed before drawn ones, so that drawn bodies avoid all of them
/// independently of the order in the file. Obstacles are placed before agents, because drawn goals avoid them.
class Placement {
 public:
  Placement(const Scenario& scenario, std::uint64_t run_seed, std::uint64_t episode)
      : scenario_(scenario), random_(run_seed, KeyedRandom::PLACEMENT, {scenario.seed, episode}) {}

  Scene place();

 private:
  [[noreturn]] void fail(const Label& label, const std::string& problem) const;

  /// How the position of an obstacle is determined.
  enum class Position { FIXED, DRAWN, BETWEEN };
  static Position positionOf(const ObstacleGroup& group);

  void recordFixedGoals();
  void placeObstacles(Position position);
  Vector2 drawStart(const ObstacleGroup& group, const Label& label);
  Obstacle drawObstacle(const ObstacleGroup& group, const Label& label);
  ObstaclePath drawPath(const ObstacleGroup& group, const Vector2& start, const Label& label);

  void placeFixedAgents();
  void completeAgents();
  void completeAgent(const AgentGroup& group, const Label& label, AgentStart& agent, bool& separate_goals);
  bool drawGoals(const AgentGroup& group, AgentStart& agent, bool separate);
  void requireWay(const AgentGroup& group, const Label& label) const;

  std::optional<Blocker> findBlocker(const Vector2& centre, double radius, double gap) const;
  bool coversGoal(const Vector2& centre, double radius) const;
  bool canStandAt(const Vector2& point, double radius) const;
  bool isNearAGoal(const Vector2& point, double radius) const;

  const Scenario& scenario_;
  KeyedRandom random_;
  Scene scene_;
  std::vector<PlacedBody> bodies_;
  std::vector<PlacedGoal> goals_;
};

Scene Placement::place() {
  scene_.name = scenario_.name;
  scene_.tick_duration = scenario_.tick_duration;
  scene_.max_ticks = scenario_.max_ticks;
  scene_.goal_tolerance = scenario_.goal_tolerance;
  scene_.collision_radius = scenario_.collision_radius;
  scene_.contact = scenario_.contact;
  scene_.order = scenario_.order;
  scene_.walls = scenario_.walls;
  for (const AgentGroup& group : scenario_.agents) {
    scene_.agents.resize(scene_.agents.size() + static_cast<std::size_t>(group.count));
  }
  std::size_t obstacle_count = 0;
  for (const ObstacleGroup& group : scenario_.obstacles) {
    obstacle_count += static_cast<std::size_t>(group.count);
  }
  scene_.obstacles.resize(obstacle_count, {ObstaclePath::atRest(Vector2::Zero()), 0.0});
  recordFixedGoals();
  placeObstacles(Position::FIXED);
  placeFixedAgents();
  placeObstacles(Position::DRAWN);
  completeAgents();
  placeObstacles(Position::BETWEEN);
  return std::move(scene_);
}

void Placement::fail(const Label& label, const std::string& problem) const {
  throw InputError(scenario_.source + ", line " + std::to_string(label.line) + ": " + problem);
}

void Placement::recordFixedGoals() {
  for (const AgentGroup& group : scenario_.agents) {
    for (const Region& goal : group.goals) {
      if (goal.isFixed()) {
        goals_.push_back({goal.first, group.radius.high});
      }
    }
    if (group.opposite && group.position.isFixed()) {
      goals_.push_back({2.0 * *group.opposite - group.position.first, group.radius.high});
    }
  }
}

Placement::Position Placement::positionOf(const ObstacleGroup& group) {
  if (group.between) return Position::BETWEEN;
  return group.position.isFixed() ? Position::FIXED : Position::DRAWN;
}

void Placement::placeObstacles(Position position) {
  std::size_t next = 0;
  for (std::size_t entry = 0; entry < scenario_.obstacles.size(); ++entry) {
    const ObstacleGroup& group = scenario_.obstacles[entry];
    for (int number = 1; number <= group.count; ++number, ++next) {
      if (positionOf(group) != position) {
        continue;
      }
      const Label label{"obstacles", entry, group.line, number, group.count};
      const Obstacle obstacle = drawObstacle(group, label);
      bodies_.push_back({label, obstacle.path.position(0.0), obstacle.radius, !obstacle.path.moves()});
      scene_.obstacles[next] = obstacle;
    }
  }
}

Vector2 Placement::drawStart(const ObstacleGroup& group, const Label& label) {
  if (!group.between) return group.position.draw(random_);
  if (group.between->agent >= scene_.agents.size()) {
    fail(label, label.text() + ".position.between.agent: expected the number of an agent, 0 to " +
                    std::to_string(scene_.agents.size() - 1) + ", got " + std::to_string(group.between->agent));
  }
  return group.between->draw(scene_.agents[group.between->agent], random_);
}

Obstacle Placement::drawObstacle(const ObstacleGroup& group, const Label& label) {
  const bool rests = group.motion == ObstaclePath::Kind::AT_REST;
  for (int tries = 0; tries < MAX_TRIES; ++tries) {
    const Vector2 start = drawStart(group, label);
    const double radius = group.radius.draw(random_);
    const bool fits = positionOf(group) == Position::FIXED ||
                      (!findBlocker(start, radius, DRAWN_GAP) && !(rests && coversGoal(start, radius)));
    if (fits) {
      return {drawPath(group, start, label), radius};
    }
  }
  fail(label, label.text() + ": no free place found in " + std::to_string(MAX_TRIES) + " tries");
}

ObstaclePath Placement::drawPath(const ObstacleGroup& group, const Vector2& start, const Label& label) {
  if (group.motion == ObstaclePath::Kind::AT_REST) {
    return ObstaclePath::atRest(start);
  }
  if (group.motion == ObstaclePath::Kind::STRAIGHT) {
    return ObstaclePath::straight(start, group.velocity);
  }
  std::vector<Vector2> points = {start};
  for (const Region& waypoint : group.waypoints) {
    points.push_back(waypoint.draw(random_));
  }
  const double speed = group.speed.draw(random_);
  try {
    const bool loop = group.motion == ObstaclePath::Kind::LOOP;
    return loop ? ObstaclePath::loop(points, speed) : ObstaclePath::toAndFro(points, speed);
  } catch (const InputError& error) {
    fail(label, label.text() + ": " + error.what());
  }
}

void Placement::placeFixedAgents() {
  std::size_t next = 0;
  for (std::size_t entry = 0; entry < scenario_.agents.size(); ++entry) {
    const AgentGroup& group = scenario_.agents[entry];
    for (int number = 1; number <= group.count; ++number, ++next) {
      if (!group.position.isFixed()) {
        continue;
      }
      const Label label{"agents", entry, group.line, number, group.count};
      AgentStart& agent = scene_.agents[next];
      agent.position = group.position.first;
      agent.radius = group.radius.draw(random_);
      if (const auto blocker = findBlocker(agent.position, agent.radius, -TOUCH_TOLERANCE)) {
        fail(label, overlapText(label.text(), blocker->name, blocker->depth));
      }
      bodies_.push_back({label, agent.position, agent.radius, false});
    }
  }
}

void Placement::completeAgents() {
  std::size_t next = 0;
  for (std::size_t entry = 0; entry < scenario_.agents.size(); ++entry) {
    const AgentGroup& group = scenario_.agents[entry];
    bool separate_goals = true;
    for (int number = 1; number <= group.count; ++number, ++next) {
      const Label label{"agents", entry, group.line, number, group.count};
      AgentStart& agent = scene_.agents[next];
      completeAgent(group, label, agent, separate_goals);
      agent.max_speed = group.max_speed.draw(random_);
      agent.heading = group.heading ? group.heading->draw(random_) : bearingOf(agent.goals.front() - agent.position);
      agent.heading = wrapAngle(agent.heading);
      agent.keeps_heading = group.keeps_heading;
    }
  }
}

/// An agent that has arrived before it walks counts as a success. What is drawn is drawn so that this does not happen.
void Placement::requireWay(const AgentGroup& group, const Label& label) const {
  const bool goal_is_fixed = group.opposite || group.goals.front().isFixed();
  if (!group.position.isFixed() || !goal_is_fixed) return;
  const Vector2& start = group.position.first;
  const Vector2 goal = group.opposite ? Vector2(2.0 * *group.opposite - start) : group.goals.front().first;
  const double distance = (goal - start).norm();
  if (distance > scenario_.goal_tolerance) return;
  fail(label, label.text() + ": its goal is " + toText(distance) + " m from its start, within goal_tolerance (" +
                  toText(scenario_.goal_tolerance) + " m)");
}

void Placement::completeAgent(const AgentGroup& group, const Label& label, AgentStart& agent, bool& separate_goals) {
  requireWay(group, label);
  const bool placed = group.position.isFixed();
  for (int tries = 0; tries < MAX_TRIES; ++tries) {
    separate_goals = separate_goals && tries < TRIES_FOR_SEPARATE_GOALS;
    if (!placed) {
      agent.position = group.position.draw(random_);
      agent.radius = group.radius.draw(random_);
      if (findBlocker(agent.position, agent.radius, DRAWN_GAP)) {
        continue;
      }
    }
    if (!drawGoals(group, agent, separate_goals)) {
      continue;
    }
    if (!placed) {
      bodies_.push_back({label, agent.position, agent.radius, false});
    }
    for (const Vector2& goal : agent.goals) {
      goals_.push_back({goal, agent.radius});
    }
    return;
  }
  fail(label, label.text() + ": no free place for it and its goal found in " + std::to_string(MAX_TRIES) + " tries");
}

bool Placement::drawGoals(const AgentGroup& group, AgentStart& agent, bool separate) {
  agent.goals.clear();
  Vector2 from = agent.position;
  bool from_drawn = !group.position.isFixed();
  const std::size_t count = group.opposite ? 1 : group.goals.size();
  for (std::size_t i = 0; i < count; ++i) {
    const bool drawn = group.opposite ? from_drawn : !group.goals[i].isFixed();
    const Vector2 goal =
        group.opposite ? Vector2(2.0 * *group.opposite - agent.position) : group.goals[i].draw(random_);
    if ((drawn || from_drawn) && (goal - from).norm() <= scenario_.goal_tolerance) {
      return false;
    }
    if (drawn && (!canStandAt(goal, agent.radius) || (separate && isNearAGoal(goal, agent.radius)))) {
      return false;
    }
    agent.goals.push_back(goal);
    from = goal;
    from_drawn = drawn;
  }
  return true;
}

std::optional<Blocker> Placement::findBlocker(const Vector2& centre, double radius, double gap) const {
  for (const PlacedBody& body : bodies_) {
    const double depth = radius + body.radius - (body.centre - centre).norm();
    if (depth > -gap) {
      return Blocker{body.label.text(), depth};
    }
  }
  for (std::size_t i = 0; i < scenario_.walls.size(); ++i) {
    const double depth = radius - distanceTo(scenario_.walls[i], centre);
    if (depth > -gap) {
      return Blocker{"walls[" + std::to_string(i) + "]", depth};
    }
  }
  return std::nullopt;
}

bool Placement::coversGoal(const Vector2& centre, double radius) const {
  return std::any_of(goals_.begin(), goals_.end(),
                     [&](const PlacedGoal& goal) { return (goal.point - centre).norm() < radius + goal.radius; });
}

bool Placement::canStandAt(const Vector2& point, double radius) const {
  const bool body = std::any_of(bodies_.begin(), bodies_.end(), [&](const PlacedBody& other) {
    return other.at_rest && (other.centre - point).norm() < radius + other.radius;
  });
  return !body && std::none_of(scenario_.walls.begin(), scenario_.walls.end(),
                               [&](const Segment& wall) { return distanceTo(wall, point) < radius; });
}

bool Placement::isNearAGoal(const Vector2& point, double radius) const {
  return std::any_of(goals_.begin(), goals_.end(),
                     [&](const PlacedGoal& goal) { return (goal.point - point).norm() < radius + goal.radius; });
}

}  // namespace

Scene Scenario::instantiate(std::uint64_t run_seed, std::uint64_t episode) const {
  return Placement(*this, run_seed, episode).place();
}

}  // namespace crowd
