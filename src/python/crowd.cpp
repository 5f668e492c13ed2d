// A crowd that walks tick by tick.

#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "python/arrays.h"
#include "python/bindings.h"
#include "python/perception_arrays.h"
#include "python/results.h"
#include "python/world_arrays.h"
#include "simulation/episode.h"
#include "social_crowd/episode.h"
#include "social_crowd/errors.h"

namespace crowd::python {
namespace {

using library::AgentArrays;

/// @throws InputError unless the array has this number of elements
void requireLength(const char* name, const Numbers& numbers, std::size_t expected) {
  if (numbers.ndim() == 1 && static_cast<std::size_t>(numbers.size()) == expected) return;
  throw InputError(std::string(name) + ": expected an array of " + std::to_string(expected) + " numbers, got " +
                   std::to_string(numbers.size()) + " in " + std::to_string(numbers.ndim()) + " dimensions");
}

/// An episode, and the arrays of its agents, which step() updates in place while their number stays the same.
class Crowd {
 public:
  Crowd(const library::Scenario& scenario, const library::QTable& table, std::uint64_t seed, std::uint64_t number,
        unsigned threads)
      : learner_(table, seed), episode_(scenario, table.vision(), seed, number, threads) {
    update();
  }

  bool step() {
    const bool walked = episode_.walk(learner_);
    update();
    return walked;
  }

  bool stepWith(const Numbers& rotations, const Numbers& speeds) {
    if (episode_.episode().scene().order == Order::SEQUENTIAL) {
      throw InputError("step() with actions: expected a scenario with order: simultaneous");
    }
    const Perceptions& seen = episode_.episode().perceptions();
    requireLength("rotations", rotations, seen.agents.size());
    requireLength("speeds", speeds, seen.agents.size());
    std::vector<library::Action> actions;
    for (std::size_t i = 0; i < seen.agents.size(); ++i) {
      const auto at = static_cast<py::ssize_t>(i);
      if (!seen.agents[i].arrived) actions.push_back({seen.agents[i].agent, rotations.at(at), speeds.at(at)});
    }
    const py::gil_scoped_release released;
    const bool walked = episode_.walk(actions);
    update();
    return walked;
  }

  /// Changes the world, then the arrays.
  template <typename Change>
  auto edit(const Change& change) {
    const auto result = change(episode_);
    update();
    return result;
  }

  py::object mind(AgentId agent) {
    const auto mind = mindOf(episode_.episode(), learner_.learner(), agent);
    return mind ? py::object(toDict(*mind)) : py::none();
  }

  library::Episode& episode() { return episode_; }
  const World& world() { return episode_.episode().world(); }
  const std::shared_ptr<AgentArrays>& arrays() const { return arrays_; }
  PerceptionArrays perceptions() { return PerceptionArrays(episode_.episode().sharedPerceptions()); }

 private:
  void update() {
    const std::size_t count = episode_.episode().world().agents().size();
    if (arrays_ == nullptr || arrays_->id.size() != count) arrays_ = std::make_shared<AgentArrays>();
    episode_.agents(*arrays_);
  }

  library::Learner learner_;
  library::Episode episode_;
  std::shared_ptr<AgentArrays> arrays_;
};

/// A property that shows an array of the agents.
template <typename Number>
auto show(std::vector<Number> AgentArrays::*numbers, std::size_t columns) {
  return [=](const Crowd& crowd) { return viewOf((*crowd.arrays()).*numbers, columns, shareOf(crowd.arrays())); };
}

py::dict describe(const library::RobotState& robot) {
  py::dict fields;
  fields["name"] = robot.name;
  fields["pose"] = py::make_tuple(robot.pose.position.x, robot.pose.position.y, robot.pose.heading);
  fields["velocity"] = py::make_tuple(robot.velocity.x, robot.velocity.y);
  fields["radius"] = robot.radius;
  fields["goal"] = robot.goal ? py::object(py::make_tuple(robot.goal->x, robot.goal->y)) : py::none();
  fields["arrived"] = robot.arrived;
  fields["in_contact"] = robot.in_contact;
  return fields;
}

}  // namespace

void bindCrowd(py::module_& module) {
  bindPerceptions(module);
  const py::call_guard<py::gil_scoped_release> released;
  py::class_<Crowd>(module, "Crowd")
      .def(py::init<const library::Scenario&, const library::QTable&, std::uint64_t, std::uint64_t, unsigned>(),
           py::arg("scenario"), py::arg("table"), py::arg("seed"), py::arg("episode"), py::arg("threads"), released)
      .def("step", &Crowd::step, released,
           "Walks a tick, in which the Q-table decides. Returns False if the episode is over: nothing has moved.")
      .def("step", &Crowd::stepWith, py::arg("rotations"), py::arg("speeds"),
           "The same with a rotation [rad] and a fraction of the maximum speed for each agent of perceptions().")
      .def("perceptions", &Crowd::perceptions)
      .def_property_readonly("is_over", [](Crowd& crowd) { return crowd.episode().isOver(); })
      .def_property_readonly("tick", [](Crowd& crowd) { return crowd.episode().tick(); })
      .def_property_readonly(
          "time", [](Crowd& crowd) { return crowd.episode().time(); }, "[s]")
      .def_property_readonly(
          "tick_duration", [](Crowd& crowd) { return crowd.episode().tickDuration(); }, "[s]")
      .def_property_readonly("ids", show(&AgentArrays::id, 0))
      .def_property_readonly("statuses", show(&AgentArrays::status, 0), "0 walking, 1 arrived, 2 removed, 3 staying")
      .def_property_readonly("positions", show(&AgentArrays::position, 2), "x, y [m], map")
      .def_property_readonly("headings", show(&AgentArrays::heading, 0), "[rad]")
      .def_property_readonly("velocities", show(&AgentArrays::velocity, 2), "of the last tick [m/s], map")
      .def_property_readonly("max_speeds", show(&AgentArrays::max_speed, 0), "[m/s]")
      .def_property_readonly("radii", show(&AgentArrays::radius, 0), "[m]")
      .def_property_readonly("goals", show(&AgentArrays::goal, 2), "x, y [m], map")
      .def_property_readonly(
          "in_contact",
          [](const Crowd& crowd) { return viewOfFlags(crowd.arrays()->in_contact, shareOf(crowd.arrays())); })
      .def_property_readonly("robots",
                             [](Crowd& crowd) {
                               py::list robots;
                               for (const library::RobotState& robot : crowd.episode().robots())
                                 robots.append(describe(robot));
                               return robots;
                             })
      .def(
          "scan",
          [](Crowd& crowd, std::uint32_t robot) {
            const library::RobotScan scan = crowd.episode().scan(robot);
            py::dict fields;
            fields["first_angle"] = scan.first_angle;
            fields["increment"] = scan.increment;
            fields["ranges"] = py::array_t<float>(static_cast<py::ssize_t>(scan.ranges.size()), scan.ranges.data());
            return fields;
          },
          py::arg("robot") = 0,
          "What the laser scanner of a robot reports now: `first_angle` and `increment` [rad], robot frame, and "
          "`ranges` [m], infinite or NaN as in REP 117.")
      .def_property_readonly("walls",
                             [](Crowd& crowd) {
                               const auto by_id = crowd.episode().walls();
                               std::vector<library::Wall> walls;
                               walls.reserve(by_id.size());
                               for (const auto& [id, wall] : by_id) walls.push_back(wall);
                               return arrayOf(walls);
                             })
      .def_property_readonly("wall_ids", [](Crowd& crowd) { return idsOf(crowd.world().walls()); })
      .def_property_readonly(
          "obstacles", [](Crowd& crowd) { return obstaclesOf(crowd.world()); }, "number, x, y, radius of each [m], map")
      .def_property_readonly(
          "map", [](Crowd& crowd) { return mapOf(crowd.episode().episode().scene()); },
          "width, height, resolution, origin (x, y, yaw) and cells (0 free, 100 occupied, 255 unknown), or None")
      .def_property_readonly("arrived", [](Crowd& crowd) { return arrivedIn(crowd.world()); })
      .def("mind", &Crowd::mind, py::arg("agent"),
           "What an agent would choose from now: `actions` (direction relative to its heading [rad], speed [m/s], "
           "value, visits), the number of the `chosen` one, and the ids of the `neighbours` that it perceives. None if "
           "it does not decide.")
      .def(
          "add_wall",
          [](Crowd& crowd, std::array<double, 2> from, std::array<double, 2> to) {
            return crowd.edit([&](library::Episode& e) { return e.addWall({{from[0], from[1]}, {to[0], to[1]}}); });
          },
          py::arg("from_"), py::arg("to"), "Adds a wall. Returns its id.")
      .def(
          "remove_wall",
          [](Crowd& crowd, std::size_t wall) {
            crowd.edit([&](library::Episode& e) { return e.removeWall(wall), 0; });
          },
          py::arg("wall"))
      .def(
          "add_obstacle",
          [](Crowd& crowd, std::array<double, 2> position, double radius) {
            return crowd.edit([&](library::Episode& e) {
              return e.episode().edit().spawnObstacle({position[0], position[1]}, {0.0, 0.0}, radius);
            });
          },
          py::arg("position"), py::arg("radius"), "Adds an obstacle. Returns its number.")
      .def(
          "remove_obstacle",
          [](Crowd& crowd, std::size_t obstacle) {
            crowd.edit([&](library::Episode& e) { return e.episode().edit().removeObstacle(obstacle), 0; });
          },
          py::arg("obstacle"), "The numbers of those after it decrease by one.")
      .def(
          "command_robot",
          [](Crowd& crowd, std::uint32_t robot, double ahead, double left, double rotation) {
            crowd.episode().commandRobot(robot, {ahead, left}, rotation);
          },
          py::arg("robot"), py::arg("ahead"), py::arg("left") = 0.0, py::arg("rotation") = 0.0,
          "Lets a robot drive until the next command, robot frame [m/s], [rad/s].")
      .def(
          "spawn_agent",
          [](Crowd& crowd, std::array<double, 2> position, std::array<double, 2> goal, double heading, double max_speed,
             double radius) {
            return crowd.edit([&](library::Episode& episode) {
              return episode.spawnAgent({{position[0], position[1]}, heading, {{goal[0], goal[1]}}, max_speed, radius});
            });
          },
          py::arg("position"), py::arg("goal"), py::arg("heading") = 0.0, py::arg("max_speed") = 1.3,
          py::arg("radius") = 0.25, "Adds an agent. Returns its id.")
      .def(
          "remove_agent",
          [](Crowd& crowd, std::uint32_t agent) {
            crowd.edit([&](library::Episode& e) { return e.removeAgent(agent), 0; });
          },
          py::arg("agent"))
      .def(
          "set_goal",
          [](Crowd& crowd, std::uint32_t agent, std::array<double, 2> goal) {
            crowd.edit([&](library::Episode& episode) { return episode.setGoal(agent, {goal[0], goal[1]}), 0; });
          },
          py::arg("agent"), py::arg("goal"))
      .def("result", [](Crowd& crowd) {
        const library::EpisodeResult result = crowd.episode().result();
        py::dict fields = toDict(result);
        fields["by_agent"] = toDict(result.agents);
        return fields;
      });
}

}  // namespace crowd::python
