// SPDX-License-Identifier: GPL-3.0-or-later
// Sampling schemes by name, their directions and stencils as arrays.
#include <cmath>
#include <stdexcept>
#include <string>

#include <pybind11/stl.h>

#include "python/arrays.hpp"
#include "python/joint_class.hpp"
#include "sphere/any_scheme.hpp"
#include "sphere/scheme_choice.hpp"

namespace impinge::python {
namespace {

py::array directions_of(const AnyScheme& scheme) {
  py::array_t<double> directions({static_cast<py::ssize_t>(scheme.size()), py::ssize_t{3}});
  double* out = directions.mutable_data();
  without_lock(scheme.size(),
               [&](std::size_t entry) { Eigen::Map<Vec3>(out + 3 * entry) = scheme.direction(entry); });
  return directions;
}

void require_directions(const Doubles& x) {
  if (x.ndim() < 1 || x.ndim() > 2 || x.shape(x.ndim() - 1) != 3)
    throw std::invalid_argument("directions: an array of shape " + std::string(py::str(x.attr("shape"))) +
                                "; give (n, 3) or (3,)");
  for (const Vec3& u : points_of(x)) {
    if (!u.allFinite() || u.isZero(0.0))
      throw std::invalid_argument("directions: a vector is zero, NaN or infinite; give others");
  }
}

py::tuple stencils_of(const AnyScheme& scheme, const Doubles& x) {
  require_directions(x);
  const std::span<const Vec3> directions = points_of(x);
  const auto rows = static_cast<py::ssize_t>(directions.size());
  py::array_t<std::int64_t> entries({rows, py::ssize_t{4}});
  py::array_t<double> weights({rows, py::ssize_t{4}});
  py::array_t<std::int64_t> cells(rows);
  std::int64_t* entry = entries.mutable_data();
  double* weight = weights.mutable_data();
  std::int64_t* cell = cells.mutable_data();
  without_lock(directions.size(), [&](std::size_t row) {
    const Stencil stencil = scheme.stencil(directions[row]);
    cell[row] = static_cast<std::int64_t>(stencil.cell);
    for (std::size_t k = 0; k < 4; ++k) {
      const bool tap = k < stencil.taps;
      entry[4 * row + k] = tap ? static_cast<std::int64_t>(stencil.entry[k]) : -1;
      weight[4 * row + k] = tap ? stencil.weight[k] : 0.0;
    }
  });
  return py::make_tuple(entries, weights, cells);
}

// A text of the scheme's class: its label, or where it was published.
std::string scheme_text(const AnyScheme& scheme, bool label) {
  std::string text;
  with_scheme(scheme.name(), [&]<class S>() { text = label ? S::label : S::citation; });
  return text;
}

}  // namespace

void bind_scheme(py::module_& module) {
  module.def("schemes", &all_scheme_names,
             "schemes()\n--\n\n"
             "Names of all sampling schemes.");
  py::class_<AnyScheme>(module, "Scheme", "A sampling scheme: which directions a table samples.")
      .def(py::init<std::string_view, double>(), py::arg("name"), py::arg("precision_deg") = 1.0)
      .def_property_readonly("name", &AnyScheme::name, "One of schemes().")
      .def_property_readonly(
          "label", [](const AnyScheme& s) { return scheme_text(s, true); }, "For figures.")
      .def_property_readonly(
          "citation", [](const AnyScheme& s) { return scheme_text(s, false); }, "Its source.")
      .def_property_readonly("precision_deg", &AnyScheme::precision_deg,
                             "Spacing of entries at the equator, degrees.")
      .def_property_readonly("size", &AnyScheme::size, "Number of entries.")
      .def_property_readonly("cells", &AnyScheme::cells, "Number of cells that answer between entries.")
      .def_property_readonly(
          "covering_radius_deg", [](const AnyScheme& s) { return s.covering_radius() / kDegree; },
          "Every direction is within this angle of an entry.")
      .def_property_readonly(
          "stencil_radius_deg", [](const AnyScheme& s) { return s.stencil_radius() / kDegree; },
          "Every direction is within this angle of the entries that answer it.")
      .def("directions", &directions_of,
           "directions(self)\n--\n\n"
           "Unit vectors of all entries, shape (size, 3).")
      .def(
          "stencils", &stencils_of, py::arg("directions"),
          "stencils(self, directions)\n--\n\n"
          "Entries (n, 4), their weights (n, 4) and cells (n,) that answer along directions of shape (n, 3); "
          "an entry that is not read is -1, with weight 0.")
      .def("__len__", &AnyScheme::size)
      .def("__repr__", [](const AnyScheme& s) {
        return "<impinge.Scheme " + std::string(s.name()) + " of " + std::to_string(s.size()) + " entries>";
      });
}

}  // namespace impinge::python
