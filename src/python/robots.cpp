// Episodes side by side, in each of which a robot is commanded from outside.

#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "python/arrays.h"
#include "python/bindings.h"
#include "python/results.h"
#include "social_crowd/errors.h"
#include "social_crowd/robot_batch.h"

namespace crowd::python {
namespace {

using library::AgentArrays;
using library::RobotArrays;
using library::RobotBatch;

/// The arrays of a batch by name; its owner keeps them alive.
py::dict arraysOf(const py::object& owner) {
  const auto& batch = owner.cast<const RobotBatch&>();
  const RobotArrays& of = batch.arrays();
  py::dict arrays;
  arrays["pose"] = viewOf(of.pose, 3, owner);
  arrays["twist"] = viewOf(of.twist, 3, owner);
  arrays["goal"] = viewOf(of.goal, 2, owner);
  arrays["remaining_distance"] = viewOf(of.remaining_distance, 0, owner);
  arrays["clearance"] = viewOf(of.clearance, 0, owner);
  arrays["contacts"] = viewOf(of.contacts, 0, owner);
  arrays["contacts_by_robot"] = viewOf(of.contacts_by_robot, 0, owner);
  arrays["contacts_by_person"] = viewOf(of.contacts_by_person, 0, owner);
  arrays["has_goal"] = viewOfFlags(of.has_goal, owner);
  arrays["arrived"] = viewOfFlags(of.arrived, owner);
  arrays["blocked"] = viewOfFlags(of.blocked, owner);
  arrays["over"] = viewOfFlags(of.over, owner);
  arrays["tick"] = viewOf(of.tick, 0, owner);
  arrays["people_count"] = viewOf(of.people_count, 0, owner);
  const auto size = static_cast<py::ssize_t>(batch.size());
  if (!of.scan.empty()) arrays["scan"] = viewOf(of.scan, batch.robot().rays, owner);
  if (!of.people.empty()) {
    constexpr auto NUMBERS = static_cast<py::ssize_t>(RobotArrays::PERSON);
    const py::ssize_t row = static_cast<py::ssize_t>(of.people.size()) / size;
    constexpr auto NUMBER = static_cast<py::ssize_t>(sizeof(double));
    arrays["people"] = viewOf(py::dtype::of<double>(), {size, row / NUMBERS, NUMBERS},
                              {row * NUMBER, NUMBERS * NUMBER, NUMBER}, of.people.data(), owner);
  }
  return arrays;
}

py::dict describe(const library::RobotDescription& robot) {
  py::dict fields;
  fields["name"] = robot.name;
  fields["drive"] = robot.drive;
  fields["max_speed"] = robot.max_speed;
  fields["max_rotation"] = robot.max_rotation;
  fields["radius"] = robot.radius;
  fields["rays"] = robot.rays;
  fields["first_angle"] = robot.first_angle;
  fields["angle_increment"] = robot.angle_increment;
  fields["min_range"] = robot.min_range;
  fields["max_range"] = robot.max_range;
  return fields;
}

}  // namespace

void bindRobots(py::module_& module) {
  py::class_<RobotBatch>(module, "RobotBatch", "Episodes with a robot each, side by side on threads.")
      .def(py::init([](std::vector<library::Scenario> scenarios, const library::QTable& table, std::size_t size,
                       const std::string& robot, std::uint32_t ticks, bool scan, std::uint32_t max_people,
                       unsigned threads) {
             return RobotBatch(std::move(scenarios), table, {size, robot, ticks, scan, max_people, threads});
           }),
           py::arg("scenarios"), py::arg("table"), py::arg("size"), py::arg("robot"), py::arg("ticks"), py::arg("scan"),
           py::arg("max_people"), py::arg("threads"))
      .def_property_readonly("robot", [](const RobotBatch& batch) { return describe(batch.robot()); })
      .def(
          "arrays", [](const py::object& self) { return arraysOf(self); },
          "Read-only arrays by name, which begin() and step() overwrite.")
      .def(
          "begin",
          [](RobotBatch& batch, const std::vector<std::array<std::uint64_t, 5>>& starts) {
            std::vector<library::EpisodeStart> all;
            all.reserve(starts.size());
            for (const auto& start : starts) {
              all.push_back({static_cast<std::size_t>(start[0]), static_cast<std::size_t>(start[1]), start[2], start[3],
                             start[4]});
            }
            const py::gil_scoped_release released;
            batch.begin(all);
          },
          py::arg("starts"), "Begins episodes: element, scenario, seed, instance, number of each.")
      .def(
          "step",
          [](RobotBatch& batch, const Numbers& commands) {
            const std::vector<double> numbers(commands.data(), commands.data() + commands.size());
            const py::gil_scoped_release released;
            batch.step(numbers);
          },
          py::arg("commands"), "Walks a step with ahead, left, rotation for each element.")
      .def("result", [](const RobotBatch& batch, std::size_t element) { return toDict(batch.result(element)); })
      .def("agents",
           [](const RobotBatch& batch, std::size_t element) {
             const auto arrays = std::make_shared<AgentArrays>();
             batch.agents(element, *arrays);
             const py::capsule owner = shareOf(arrays);
             return py::make_tuple(viewOf(arrays->position, 2, owner), viewOf(arrays->radius, 0, owner),
                                   viewOf(arrays->status, 0, owner));
           })
      .def("walls", [](const RobotBatch& batch, std::size_t element) { return arrayOf(batch.walls(element)); });
}

}  // namespace crowd::python
