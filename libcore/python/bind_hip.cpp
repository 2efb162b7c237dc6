// SPDX-License-Identifier: GPL-3.0-or-later
// The presets and parameters of a generated hip.
#include <pybind11/stl.h>

#include "hip/hip_presets.hpp"
#include "python/bindings.hpp"

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

}  // namespace

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

}  // namespace impinge::python
