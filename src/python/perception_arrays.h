#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "python/arrays.h"
#include "world/perception.h"

namespace crowd::python {

/// What agents perceive at the start of a tick, as arrays that show the memory of a shared object.
class PerceptionArrays {
 public:
  explicit PerceptionArrays(std::shared_ptr<const Perceptions> perceptions) : shared_(std::move(perceptions)) {}

  const Perceptions& perceptions() const { return *shared_; }

  /// An array of a field of all agents. @param columns numbers of the field; 0: it is one number
  template <typename Number, typename Field>
  py::array ofAgents(Field AgentPerception::*field, std::size_t columns) const {
    return ofElements<Number>(shared_->agents, columns, [&](const AgentPerception& seen) { return &(seen.*field); });
  }
  py::array pose() const {
    return ofElements<double>(shared_->agents, 3, [](const AgentPerception& seen) { return &seen.pose; });
  }
  py::array walls() const {
    return ofElements<double>(shared_->walls, 4, [](const Segment& wall) { return &wall; });
  }
  template <typename Number>
  py::array ofNeighbours(const Number* numbers) const {
    const auto count = static_cast<py::ssize_t>(shared_->neighbours.size());
    return viewOf(py::dtype::of<Number>(), {count}, {static_cast<py::ssize_t>(sizeof(Number))}, numbers,
                  shareOf(shared_));
  }

 private:
  template <typename Number, typename Element, typename Address>
  py::array ofElements(const std::vector<Element>& elements, std::size_t columns, const Address& address) const {
    const auto count = static_cast<py::ssize_t>(elements.size());
    const auto step = static_cast<py::ssize_t>(sizeof(Element));
    const void* const first = elements.empty() ? nullptr : static_cast<const void*>(address(elements.front()));
    const py::dtype type = py::dtype::of<Number>();
    if (columns == 0) return viewOf(type, {count}, {step}, first, shareOf(shared_));
    return viewOf(type, {count, static_cast<py::ssize_t>(columns)}, {step, static_cast<py::ssize_t>(sizeof(Number))},
                  first, shareOf(shared_));
  }

  std::shared_ptr<const Perceptions> shared_;
};

static_assert(offsetof(Pose, heading) == 2 * sizeof(double) && sizeof(Segment) == 4 * sizeof(double),
              "arrays show them as numbers side by side");

inline void bindPerceptions(py::module_& module) {
  using Arrays = PerceptionArrays;
  const auto field = [](auto member, std::size_t columns) {
    return [=](const Arrays& arrays) { return arrays.ofAgents<double>(member, columns); };
  };
  py::class_<Arrays>(module, "Perceptions", "What the agents perceive at the start of a tick: arrays without copies.")
      .def_property_readonly("ids",
                             [](const Arrays& a) { return a.ofAgents<std::uint32_t>(&AgentPerception::agent, 0); })
      .def_property_readonly("poses", &Arrays::pose, "x, y, heading of each agent; map")
      .def_property_readonly("velocities", field(&AgentPerception::velocity, 2), "of the last tick, agent frame")
      .def_property_readonly("goals", field(&AgentPerception::goal, 2), "or the next point on the way, agent frame")
      .def_property_readonly("max_speeds", field(&AgentPerception::max_speed, 0))
      .def_property_readonly("radii", field(&AgentPerception::radius, 0))
      .def_property_readonly("arrived", [](const Arrays& a) { return a.ofAgents<bool>(&AgentPerception::arrived, 0); })
      .def_property_readonly(
          "first_neighbours",
          [](const Arrays& a) { return a.ofAgents<std::uint32_t>(&AgentPerception::first_neighbour, 0); })
      .def_property_readonly(
          "neighbour_counts",
          [](const Arrays& a) { return a.ofAgents<std::uint32_t>(&AgentPerception::neighbour_count, 0); })
      .def_property_readonly("first_walls",
                             [](const Arrays& a) { return a.ofAgents<std::uint32_t>(&AgentPerception::first_wall, 0); })
      .def_property_readonly("wall_counts",
                             [](const Arrays& a) { return a.ofAgents<std::uint32_t>(&AgentPerception::wall_count, 0); })
      .def_property_readonly("neighbour_x",
                             [](const Arrays& a) { return a.ofNeighbours(a.perceptions().neighbours.xs()); })
      .def_property_readonly("neighbour_y",
                             [](const Arrays& a) { return a.ofNeighbours(a.perceptions().neighbours.ys()); })
      .def_property_readonly("neighbour_vx",
                             [](const Arrays& a) { return a.ofNeighbours(a.perceptions().neighbours.vxs()); })
      .def_property_readonly("neighbour_vy",
                             [](const Arrays& a) { return a.ofNeighbours(a.perceptions().neighbours.vys()); })
      .def_property_readonly("neighbour_radii",
                             [](const Arrays& a) { return a.ofNeighbours(a.perceptions().neighbours.radii()); })
      .def_property_readonly("walls", &Arrays::walls, "x, y of both ends, agent frame");
}

}  // namespace crowd::python
