// SPDX-License-Identifier: GPL-3.0-or-later
// What would have to change so that motions are reached.
#include <cmath>
#include <stdexcept>
#include <string>

#include <pybind11/stl.h>

#include "python/arrays.hpp"
#include "python/joint_class.hpp"
#include "python/poses.hpp"

namespace impinge::python {
namespace {

py::tuple ends_tuple(const Ends& ends) { return py::make_tuple(ends.low, ends.high); }

py::dict bracket_dict(const TurnLimit& limit) {
  py::dict found;
  found["state"] = std::string(name(limit.state));
  found["low_deg"] = limit.low_deg;
  found["high_deg"] = limit.high_deg;
  return found;
}

py::dict leg_dict(const ReachedLeg& reached) {
  const Motion& start = reached.leg.start;
  py::dict row;
  row["motion"] = std::string(reached.leg.growing);
  row["start"] = py::make_tuple(start.flexion, start.abduction, start.internal_rotation);
  row["required_deg"] = reached.leg.largest_deg;
  row["before"] = bracket_dict(reached.before);
  row["after"] = bracket_dict(reached.after);
  return row;
}

py::object neck_dict(const std::optional<NeckBar>& neck) {
  if (!neck) return py::none();
  py::dict found;
  found["least_mm"] = neck->least;
  found["before_mm"] = neck->before;
  found["after_mm"] = neck->after;
  return found;
}

py::dict size_dict(const CutSize& size) {
  py::dict found;
  found["volume_mm3"] = ends_tuple(size.volume_mm3);
  found["area_mm2"] = ends_tuple(size.area_mm2);
  found["depth_mm"] = ends_tuple(size.depth_mm);
  return found;
}

// With the names of resection.json, and the mesh of resected_ball.ply.
py::dict resection_dict(const SessionJoint& joint, ResectionAnswer& answer) {
  Resection& cut = answer.cut;
  for (Vec3& x : cut.cut.vertices) x = joint.axes.transpose() * x + joint.joint.centre;
  py::list legs;
  for (const ReachedLeg& reached : answer.legs) legs.append(leg_dict(reached));
  const auto rows = [](std::size_t count) { return static_cast<py::ssize_t>(count); };
  py::dict found = size_dict(cut);
  found["least"] = answer.least ? py::object(size_dict(*answer.least)) : py::none();
  found["deepest"] = cut.empty() ? py::none() : py::object(point_tuple(answer.deepest));
  found["mesh_volume_mm3"] = cut.cut_mm3;
  found["neck"] = neck_dict(answer.neck);
  found["legs"] = legs;
  found["vertices"] =
      py::array_t<double>({rows(cut.cut.vertices.size()), py::ssize_t{3}}, cut.cut.vertices.front().data());
  found["faces"] =
      py::array_t<std::uint32_t>({rows(cut.cut.faces.size()), py::ssize_t{3}}, cut.cut.faces.front().data());
  found["depth"] = py::array_t<double>(rows(cut.depth.size()), cut.depth.data());
  return found;
}

void require_above_0(const char* name, double value) {
  if (!(value > 0.0 && std::isfinite(value)))
    throw std::invalid_argument(std::string(name) + ": is no length; give a number of mm above 0");
}

py::dict resection(PoseJoint& joint, const py::object& required, double clearance_mm,
                   const std::optional<double>& neck_mm, bool least) {
  require_above_0("clearance_mm", clearance_mm);
  if (neck_mm) require_above_0("neck_mm", *neck_mm);
  const ResectionRequest request{required_motions(joint.joint(), required), clearance_mm, neck_mm, least};
  std::optional<ResectionAnswer> answer;
  without_lock(1, [&](std::size_t) { answer = joint.resection(request); });
  return resection_dict(joint.joint(), *answer);
}

// A row of orientation.csv.
struct SquareRow {
  double inclination_deg;
  double anteversion_deg;
  double half_width_deg;
  std::int64_t leg;
  std::int64_t state;
};

py::array squares_of(const OrientationAnswer& answer) {
  std::vector<SquareRow> rows;
  for (const OrientationCell& cell : answer.cells)
    rows.push_back({cell.middle.inclination_deg, cell.middle.anteversion_deg, cell.half_deg,
                    cell.leg ? static_cast<std::int64_t>(*cell.leg) : -1,
                    static_cast<std::int64_t>(cell.state)});
  return py::array_t<SquareRow>(static_cast<py::ssize_t>(rows.size()), rows.data());
}

// With the names of orientation.json.
py::dict orientation_dict(const OrientationAnswer& answer) {
  const OrientationQuestion& question = answer.question;
  py::dict as_scanned;
  as_scanned["inclination_deg"] = question.at_rest.inclination_deg;
  as_scanned["anteversion_deg"] = question.at_rest.anteversion_deg;
  as_scanned["state"] = std::string(name(answer.as_scanned));
  py::dict area;
  area["free"] = answer.free;
  area["blocked"] = answer.blocked;
  area["unknown"] = answer.unknown;
  area["open"] = answer.open;
  py::list legs;
  for (const RequiredLeg& leg : question.legs) legs.append(describe(leg));
  py::dict found;
  found["as_scanned"] = as_scanned;
  found["area_deg2"] = area;
  found["legs"] = legs;
  found["squares"] = squares_of(answer);
  return found;
}

py::dict orientation_map(PoseJoint& joint, const py::object& required, double tilt_deg,
                         double resolution_deg) {
  if (!joint.joint().side)
    throw std::invalid_argument("an orientation needs to know the side; give left or right with side=");
  if (!(std::abs(tilt_deg) <= 90.0))
    throw std::invalid_argument("tilt_deg: is no tilt; give degrees from -90 to 90, backwards positive");
  if (!(resolution_deg >= 0.01 && resolution_deg <= 90.0))
    throw std::invalid_argument("resolution_deg: is none; give degrees from 0.01 to 90");
  const OrientationRequest request{required_motions(joint.joint(), required), tilt_deg, resolution_deg};
  std::optional<OrientationAnswer> answer;
  without_lock(1, [&](std::size_t) { answer = joint.orientation(request); });
  return orientation_dict(*answer);
}

}  // namespace

void bind_change(JointClass& joint) {
  PYBIND11_NUMPY_DTYPE(SquareRow, inclination_deg, anteversion_deg, half_width_deg, leg, state);
  joint
      .def("resection", &resection, py::arg("required"), py::kw_only(), py::arg("clearance_mm") = 0.5,
           py::arg("neck_mm") = py::none(), py::arg("least") = false,
           "What of the ball would have to go so that motions are reached with a clearance: a dict with the "
           "names of resection.json, and the cut ball.")
      .def("orientation_map", &orientation_map, py::arg("required"), py::kw_only(), py::arg("tilt_deg") = 0.0,
           py::arg("resolution_deg") = OrientationRequest{}.resolution_deg,
           "In which orientations of the socket motions are free: a dict with the names of orientation.json, "
           "and `squares`, a structured array with those of orientation.csv.");
}

}  // namespace impinge::python
