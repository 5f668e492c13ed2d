// Errors, scenarios and Q-tables.

#include <pybind11/stl.h>

#include <exception>

#include "learning/q_table_file.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "social_crowd/errors.h"
#include "social_crowd/q_table.h"
#include "social_crowd/scenario.h"

namespace crowd::python {
namespace {

using library::QTable;
using library::Scenario;

/// Makes an exception class of the module. It lives as long as the interpreter.
PyObject* addError(py::module_& module, const char* name, const py::handle& bases) {
  const std::string full = "social_crowd." + std::string(name);
  PyObject* const error = PyErr_NewException(full.c_str(), bases.ptr(), nullptr);
  if (error == nullptr) throw py::error_already_set();
  module.add_object(name, py::reinterpret_borrow<py::object>(error));
  return error;
}

void bindErrors(py::module_& module) {
  static PyObject* const ANY = addError(module, "CrowdError", PyExc_Exception);
  static PyObject* const INPUT =
      addError(module, "InputError", py::make_tuple(py::handle(ANY), py::handle(PyExc_ValueError)));
  static PyObject* const FILE_ACCESS =
      addError(module, "FileError", py::make_tuple(py::handle(ANY), py::handle(PyExc_OSError)));
  static PyObject* const SHAPE =
      addError(module, "ShapeError", py::make_tuple(py::handle(ANY), py::handle(PyExc_ValueError)));
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      PyErr_SetString(INPUT, error.what());
    } catch (const FileError& error) {
      PyErr_SetString(FILE_ACCESS, error.what());
    } catch (const ShapeError& error) {
      PyErr_SetString(SHAPE, error.what());
    } catch (const Error& error) {
      PyErr_SetString(ANY, error.what());
    }
  });
}

/// All values of a table, or all visits: an array of rows and actions.
template <typename Number, typename Get>
py::array_t<Number> arrayOf(const QTable& table, const Get& get) {
  py::array_t<Number> array({table.rows(), table.actions()});
  auto numbers = array.template mutable_unchecked<2>();
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t action = 0; action < table.actions(); ++action) {
      const auto at = static_cast<Row>(row);
      numbers(static_cast<py::ssize_t>(row), static_cast<py::ssize_t>(action)) =
          get(at, static_cast<crowd::Action>(action));
    }
  }
  return array;
}

}  // namespace

void bindFiles(py::module_& module) {
  bindErrors(module);
  py::class_<Scenario>(module, "Scenario", "The documents of a scenario file; immutable.")
      .def_static("load", &Scenario::load, py::arg("name_or_file"),
                  "A scenario file, or one of the package by its name.")
      .def_static("parse", &Scenario::parse, py::arg("text"), py::arg("name") = "text", "The text of a scenario file.")
      .def_static("names", &Scenario::names, "Names of the scenarios of the package.")
      .def("__len__", &Scenario::size);
  py::class_<QTable>(module, "QTable", "A learned Q-table with its state set, action set and reward; immutable.")
      .def_static("load", &QTable::load, py::arg("name_or_file"),
                  "A Q-table file, or a Q-table of the package by its name.")
      .def("save", &QTable::save, py::arg("file"), "Writes a file that load() reads, bit for bit.")
      .def_property_readonly("model", &QTable::model, "State set, action set and reward in YAML.")
      .def_property_readonly("decisions", &QTable::decisions, "Number of decisions that it was learned from.")
      .def_property_readonly("rows", &QTable::rows)
      .def_property_readonly("actions", &QTable::actions)
      .def_property_readonly(
          "values",
          [](const QTable& table) {
            const auto& values = table.trained().table;
            return arrayOf<double>(table, [&](Row row, crowd::Action action) { return values.value(row, action); });
          },
          "A copy of the values: an array of rows and actions.")
      .def_property_readonly(
          "visits",
          [](const QTable& table) {
            const auto& values = table.trained().table;
            return arrayOf<std::uint32_t>(table,
                                          [&](Row row, crowd::Action action) { return values.visits(row, action); });
          },
          "A copy of the number of decisions that each value was learned from.");
}

}  // namespace crowd::python
