#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

/// NumPy arrays that show memory of C++ without a copy. They are read-only, and keep their owner alive.
namespace crowd::python {

namespace py = pybind11;

using Shape = std::vector<py::ssize_t>;

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

/// @brief An owner that shares an object.
template <typename Object>
py::capsule shareOf(const std::shared_ptr<Object>& object) {
  return py::capsule(new std::shared_ptr<Object>(object),
                     [](void* shared) { delete static_cast<std::shared_ptr<Object>*>(shared); });
}

}  // namespace crowd::python
