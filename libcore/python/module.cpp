// SPDX-License-Identifier: GPL-3.0-or-later
// The module, with the presets and parameters of a generated hip.
#include <pybind11/stl.h>

#include "files/file_error.hpp"
#include "hip/hip_presets.hpp"
#include "python/joint_class.hpp"

namespace impinge::python {
namespace {

namespace py = pybind11;

py::dict parameters_of(const std::string& preset) {
  const HipParameters parameters = hip_preset(preset);
  py::dict found;
  found["side"] = parameters.side == Side::left ? "left" : "right";
  for (const HipParameter& parameter : hip_parameter_list())
    found[py::str(std::string(parameter.name))] = parameters.*parameter.value;
  return found;
}

py::dict ranges() {
  py::dict found;
  for (const HipParameter& parameter : hip_parameter_list())
    found[py::str(std::string(parameter.name))] =
        py::make_tuple(std::string(parameter.unit), parameter.least, parameter.most);
  return found;
}

void bind_hip(py::module_& module) {
  module.def(
      "hip_presets",
      [] {
        std::vector<std::string> names;
        for (const std::string_view name : hip_preset_names()) names.emplace_back(name);
        return names;
      },
      "hip_presets()\n--\n\n"
      "Names of the hips that Joint.from_hip() makes.");
  module.def("hip_parameters", &parameters_of, py::arg("preset") = "normal",
             "hip_parameters(preset='normal')\n--\n\n"
             "The parameters of a preset, by name; mm, degrees and hours.");
  module.def("hip_parameter_ranges", &ranges,
             "hip_parameter_ranges()\n--\n\n"
             "Unit, least and largest value of each parameter, by name.");
}

}  // namespace
}  // namespace impinge::python

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
