#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

#include "social_crowd/perception.h"

/// NumPy arrays that show memory of C++ without a copy. They are read-only, and keep their owner alive.
namespace crowd::python {

namespace py = pybind11;

using Shape = std::vector<py::ssize_t>;

/// @brief Numbers from Python, converted and laid out row by row.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// @brief Read-only array at an address. @param owner keeps the memory; not none
inline py::array viewOf(const py::dtype& type, const Shape& shape, const Shape& strides, const void* memory,
                        const py::handle& owner) {
  py::array array(type, shape, strides, memory, owner);
  array.attr("setflags")(false);
  return array;
}

/// @brief Read-only array of all elements of a vector, row by row. @param columns of a row; 0: there are no rows, but
/// elements
template <typename Number>
py::array viewOf(const std::vector<Number>& numbers, std::size_t columns, const py::handle& owner) {
  const auto size = static_cast<py::ssize_t>(sizeof(Number));
  const auto all = static_cast<py::ssize_t>(numbers.size());
  const auto row = static_cast<py::ssize_t>(columns);
  const py::dtype type = py::dtype::of<Number>();
  if (columns == 0) return viewOf(type, {all}, {size}, numbers.data(), owner);
  return viewOf(type, {all / row, row}, {row * size, size}, numbers.data(), owner);
}

/// @brief The same of flags, as an array of bool.
inline py::array viewOfFlags(const std::vector<std::uint8_t>& flags, const py::handle& owner) {
  return viewOf(py::dtype::of<bool>(), {static_cast<py::ssize_t>(flags.size())}, {1}, flags.data(), owner);
}

/// @brief A row with x, y of both ends [m] for each wall: a new array.
inline py::array arrayOf(const std::vector<library::Wall>& walls) {
  py::array_t<double> array({walls.size(), std::size_t{4}});
  double* to = array.mutable_data();
  for (const library::Wall& wall : walls) {
    for (const double number : {wall.from.x, wall.from.y, wall.to.x, wall.to.y}) *to++ = number;
  }
  return array;
}

/// @brief An owner that shares an object.
template <typename Object>
py::capsule shareOf(const std::shared_ptr<Object>& object) {
  return py::capsule(new std::shared_ptr<Object>(object),
                     [](void* shared) { delete static_cast<std::shared_ptr<Object>*>(shared); });
}

}  // namespace crowd::python
