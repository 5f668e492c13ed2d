#pragma once

#include <pybind11/pybind11.h>

/// Parts of the Python module social_crowd._core; the Python package social_crowd documents it for users.
namespace crowd::python {

/// @brief Errors, Scenario and QTable.
void bindFiles(pybind11::module_& module);
/// @brief Crowd and its perceptions.
void bindCrowd(pybind11::module_& module);
/// @brief RobotBatch.
void bindRobots(pybind11::module_& module);
/// @brief evaluate() and Training.
void bindRuns(pybind11::module_& module);

}  // namespace crowd::python
