#include "python/bindings.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The C++ library of social_crowd. Use the package social_crowd, which is documented.";
  crowd::python::bindFiles(module);
  crowd::python::bindCrowd(module);
  crowd::python::bindRobots(module);
  crowd::python::bindRuns(module);
}
