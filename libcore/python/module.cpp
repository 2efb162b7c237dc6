// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_error.hpp"
#include "python/bindings.hpp"

PYBIND11_MODULE(_impinge, module) {
  pybind11::options options;
  options.disable_function_signatures();  // docstrings begin with their own, for inspect
  module.attr("__version__") = IMPINGE_VERSION;
  module.doc() = "Gaps, contact and limits of ball-and-socket joints. Lengths in mm, angles in degrees.";
  pybind11::register_exception<impinge::FileError>(module, "FileError", PyExc_RuntimeError).attr("__doc__") =
      "A file, or a mesh, that cannot be used.";
  impinge::python::bind_hip(module);
  impinge::python::bind_joint(module);
  impinge::python::bind_scheme(module);
}
