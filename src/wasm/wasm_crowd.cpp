#include "wasm/wasm_crowd.h"

#include <cmath>
#include <optional>

#include "learning/learner.h"
#include "simulation/agent_mind.h"

namespace crowd::wasm {
namespace {

template <typename Number>
val viewOf(const std::vector<Number>& numbers) {
  return val(emscripten::typed_memory_view(numbers.size(), numbers.data()));
}

template <typename Vector>
val pointOf(const Vector& vector) {
  val point = val::array();
  point.call<void>("push", vector[0], vector[1]);
  return point;
}

val pointOf(const library::Vector2& vector) { return pointOf(Vector2(vector.x, vector.y)); }

library::Vector2 toVector(const val& point) { return {point[0].as<double>(), point[1].as<double>()}; }

/// An array with what `describe` returns for each element.
template <typename Elements, typename Describe>
val arrayOf(const Elements& elements, const Describe& describe) {
  val array = val::array();
  for (const auto& element : elements) array.call<void>("push", describe(element));
  return array;
}

}  // namespace

WasmCrowd::WasmCrowd(const std::string& scenario, const std::string& table, double seed, double number)
    : WasmCrowd(library::Scenario::load(scenario), library::QTable::load(table), static_cast<std::uint64_t>(seed),
                static_cast<std::uint64_t>(number)) {}

WasmCrowd::WasmCrowd(const library::Scenario& scenario, const library::QTable& table, std::uint64_t seed,
                     std::uint64_t number)
    : learner_(table, seed), episode_(scenario, table.vision(), seed, number) {}

bool WasmCrowd::step() { return episode_.walk(learner_); }

double WasmCrowd::arrived() {
  std::size_t arrived = world().departed().arrived;
  for (const Agent& agent : world().agents()) arrived += agent.hasArrived() ? 1 : 0;
  return static_cast<double>(arrived);
}

val WasmCrowd::agents() {
  episode_.agents(arrays_);
  val arrays = val::object();
  arrays.set("ids", viewOf(arrays_.id));
  arrays.set("statuses", viewOf(arrays_.status));
  arrays.set("positions", viewOf(arrays_.position));
  arrays.set("headings", viewOf(arrays_.heading));
  arrays.set("velocities", viewOf(arrays_.velocity));
  arrays.set("radii", viewOf(arrays_.radius));
  arrays.set("goals", viewOf(arrays_.goal));
  arrays.set("inContact", viewOf(arrays_.in_contact));
  return arrays;
}

val WasmCrowd::walls() {
  return arrayOf(episode_.walls(), [](const auto& entry) {
    val wall = val::object();
    wall.set("id", static_cast<double>(entry.first));
    wall.set("from", pointOf(entry.second.from));
    wall.set("to", pointOf(entry.second.to));
    return wall;
  });
}

val WasmCrowd::obstacles() {
  val obstacles = val::array();
  for (std::size_t i = 0; i < world().obstacles().size(); ++i) {
    const Obstacle& obstacle = world().obstacles()[i];
    if (!world().isPresent(obstacle)) continue;
    val fields = val::object();
    fields.set("id", static_cast<double>(i));
    fields.set("position", pointOf(obstacle.path.position(world().time())));
    fields.set("radius", obstacle.radius);
    obstacles.call<void>("push", fields);
  }
  return obstacles;
}

val WasmCrowd::robots() {
  std::uint32_t number = 0;
  return arrayOf(episode_.robots(), [&](const library::RobotState& robot) {
    val fields = val::object();
    fields.set("name", robot.name);
    fields.set("radius", robot.radius);
    val pose = pointOf(robot.pose.position);
    pose.call<void>("push", robot.pose.heading);
    fields.set("pose", pose);
    fields.set("goal", robot.goal ? pointOf(*robot.goal) : val::null());
    fields.set("scan", scanOf(number++));
    return fields;
  });
}

val WasmCrowd::scanOf(std::uint32_t robot) {
  const library::RobotScan scan = episode_.scan(robot);
  val fields = val::object();
  fields.set("angle_min", scan.first_angle);
  fields.set("angle_increment", scan.increment);
  val ranges = val::array();
  for (const float range : scan.ranges) {
    ranges.call<void>("push", std::isfinite(range) ? val(range) : val::null());
  }
  fields.set("ranges", ranges);
  return fields;
}

val WasmCrowd::map() {
  const auto& map = episode_.episode().scene().map;
  if (map == nullptr) return val::null();
  cells_.clear();
  for (const CellState cell : map->cells) {
    cells_.push_back(cell == CellState::FREE ? 0 : cell == CellState::OCCUPIED ? 100 : 255);
  }
  val fields = val::object();
  fields.set("width", map->width);
  fields.set("height", map->height);
  fields.set("resolution", map->resolution);
  val origin = pointOf(map->origin.position);
  origin.call<void>("push", map->origin.heading);
  fields.set("origin", origin);
  fields.set("cells", viewOf(cells_));
  return fields;
}

val WasmCrowd::mind(AgentId agent) {
  const std::optional<AgentMind> known = mindOf(episode_.episode(), learner_.learner(), agent);
  if (!known) return val::null();
  val mind = val::object();
  mind.set("agent", agent);
  mind.set("tick", tick());
  mind.set("actions", arrayOf(known->values.moves, [&](const ValuedMove& valued) {
             val action = val::object();
             action.set("direction", bearingOf(valued.move.direction));
             action.set("speed", valued.move.wanted * known->max_speed);
             action.set("value", valued.value);
             action.set("visits", valued.visits);
             return action;
           }));
  mind.set("chosen", known->values.chosen);
  mind.set("neighbours", arrayOf(known->neighbours, [](AgentId id) { return val(id); }));
  return mind;
}

AgentId WasmCrowd::addAgent(const val& position, const val& goal, double heading, double max_speed, double radius) {
  return episode_.spawnAgent({toVector(position), heading, {toVector(goal)}, max_speed, radius});
}

void WasmCrowd::setGoal(AgentId agent, const val& goal) { episode_.setGoal(agent, toVector(goal)); }

double WasmCrowd::addObstacle(const val& position, double radius) {
  const library::Vector2 place = toVector(position);
  const std::size_t number = episode_.episode().edit().spawnObstacle({place.x, place.y}, Vector2::Zero(), radius);
  return static_cast<double>(number);
}

double WasmCrowd::addWall(const val& from, const val& to) {
  return static_cast<double>(episode_.addWall({toVector(from), toVector(to)}));
}

}  // namespace crowd::wasm
