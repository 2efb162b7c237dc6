// SPDX-License-Identifier: GPL-3.0-or-later
#include "04_error_budget/error_budget.hpp"

#include <algorithm>
#include <stdexcept>

#include <Eigen/Geometry>

#include "harness/statistics.hpp"
#include "mesh/edges.hpp"
#include "reference/exact_radius.hpp"

namespace impinge::lab {
namespace {

constexpr double kMicrometres = 1000.0;  // in a millimetre
constexpr double kSameGap = 1e-11;       // mm; sums of differences of gaps are rounded less

std::vector<double> exact_gaps(const TriangleMesh& socket, const std::vector<Vec3>& vertices) {
  std::vector<double> gaps = exact_radii(socket, {vertices, Layer::nearest, {}});
  for (std::size_t i = 0; i < gaps.size(); ++i) gaps[i] -= vertices[i].norm();
  return gaps;
}

std::vector<std::size_t> with_every_gap(const std::vector<Stage>& stages) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < stages.front().gap.size(); ++i) {
    const auto known = [i](const Stage& stage) { return !std::isnan(stage.gap[i]); };
    if (std::ranges::all_of(stages, known)) places.push_back(i);
  }
  return places;
}

// |to - from| at the places, mm.
std::vector<double> apart(const Stage& from, const Stage& to, const std::vector<std::size_t>& places) {
  std::vector<double> errors;
  errors.reserve(places.size());
  for (const std::size_t i : places) errors.push_back(std::abs(to.gap[i] - from.gap[i]));
  return errors;
}

void require_sums(const std::vector<Stage>& stages, const std::vector<std::size_t>& places) {
  for (const std::size_t i : places) {
    double sum = 0.0;
    for (std::size_t k = 1; k < stages.size(); ++k) sum += stages[k].gap[i] - stages[k - 1].gap[i];
    const double total = stages.back().gap[i] - stages.front().gap[i];
    if (std::abs(sum - total) > kSameGap) {
      throw std::logic_error("the stages of vertex " + std::to_string(i) + " add up to " +
                             std::to_string(sum) + " mm, not to the total of " + std::to_string(total) +
                             " mm");
    }
  }
}

}  // namespace

std::vector<Vec3> seen_from_wrong_centre(const BudgetJoint& joint) {
  std::vector<Vec3> vertices = joint.meshes.ball.vertices;
  for (Vec3& x : vertices) x -= joint.wrong_centre;
  return vertices;
}

TriangleMesh socket_about_wrong_centre(const BudgetJoint& joint) {
  TriangleMesh socket = joint.meshes.socket;
  for (Vec3& x : socket.vertices) x -= joint.wrong_centre;
  return socket;
}

std::vector<Stage> exact_stages(const BudgetJoint& joint) {
  std::vector<Stage> stages;
  const std::vector<Vec3>& vertices = joint.meshes.ball.vertices;
  if (joint.socket_radius) {
    Stage truth{"", {}};
    for (const Vec3& x : vertices) truth.gap.push_back(joint.socket_radius(x.normalized()) - x.norm());
    stages.push_back(std::move(truth));
  }
  stages.push_back({joint.socket_radius ? "mesh" : "", exact_gaps(joint.meshes.socket, vertices)});
  stages.push_back({"centre", exact_gaps(socket_about_wrong_centre(joint), seen_from_wrong_centre(joint))});
  return stages;
}

Table budget_table() {
  Table table;
  table.columns = {
      {"joint", "", "the generated pair or a real joint"},
      {"scheme", "", "of the table; empty for stages before it"},
      {"precision_deg", "deg", "of the table"},
      {"storage", "", "of the entries: double, float or uint16"},
      {"stage", "", "source of the error; total is last gap minus first, sum that of all stages"},
      {"vertices", "1", "of the ball, with a gap in every stage; faces for mesh_estimate"},
      {"missed", "1", "vertices left out: some stage gives them no gap (most do not face the socket)"},
      {"max_um", "um", "largest error of the gap; of sum the sum of the largest ones"},
      {"rms_um", "um", "root mean square; of sum the sum of them"}};
  return table;
}

void add_budget(Table& table, const BudgetCase& now, const std::vector<Stage>& stages) {
  const std::vector<std::size_t> places = with_every_gap(stages);
  if (places.empty()) {
    throw std::invalid_argument(
        std::string(now.joint) + ": no vertex of the ball has a gap in every stage of a table of " +
        std::string(now.scheme) + ": the socket covers none of them; leave the joint out");
  }
  const std::size_t missed = stages.front().gap.size() - places.size();
  require_sums(stages, places);
  const auto add = [&](std::string_view stage, double max, double rms) {
    table.add_row({now.joint, now.scheme, now.precision_deg, now.storage, stage, places.size(), missed,
                   kMicrometres * max, kMicrometres * rms});
  };
  double max_sum = 0.0;
  double rms_sum = 0.0;
  for (std::size_t k = 1; k < stages.size(); ++k) {
    const ErrorSummary errors = summarise_errors(apart(stages[k - 1], stages[k], places));
    add(stages[k].adds, errors.max, errors.rms);
    max_sum += errors.max;
    rms_sum += errors.rms;
  }
  const ErrorSummary total = summarise_errors(apart(stages.front(), stages.back(), places));
  add("total", total.max, total.rms);
  add("sum", max_sum, rms_sum);
}

std::vector<double> face_sagittas(const TriangleMesh& mesh) {
  const auto corner = [&mesh](std::size_t face, std::size_t k) -> const Vec3& {
    return mesh.vertices[mesh.faces[face][k]];
  };
  std::vector<double> bend(mesh.faces.size(), 0.0);  // curvature, 1 / mm
  std::vector<Vec3> normal;
  std::vector<Vec3> centroid;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    normal.emplace_back((corner(f, 1) - corner(f, 0)).cross(corner(f, 2) - corner(f, 0)));
    centroid.emplace_back((corner(f, 0) + corner(f, 1) + corner(f, 2)) / 3.0);
  }
  const EdgeList list = edges(mesh);
  for (std::size_t e = 0; e < list.size(); ++e) {
    if (list[e].size() != 2) continue;
    const std::size_t f = list[e][0].face;
    const std::size_t g = list[e][1].face;
    if (normal[f].isZero(0.0) || normal[g].isZero(0.0)) continue;
    const double curvature = angle_between(normal[f], normal[g]) / (centroid[f] - centroid[g]).norm();
    for (const std::size_t face : {f, g}) bend[face] = std::max(bend[face], curvature);
  }
  std::vector<double> sagittas;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (normal[f].isZero(0.0)) continue;
    const double product = (corner(f, 1) - corner(f, 0)).norm() * (corner(f, 2) - corner(f, 1)).norm() *
                           (corner(f, 0) - corner(f, 2)).norm();
    const double circumradius = product / (2.0 * normal[f].norm());
    const double share = std::min(circumradius * bend[f], 1.0);  // no farther than a half sphere
    sagittas.push_back(circumradius * share / (1.0 + std::sqrt(1.0 - share * share)));
  }
  return sagittas;
}

void add_sagittas(Table& table, std::string_view joint, const std::vector<double>& sagittas) {
  const ErrorSummary summary = summarise_errors(sagittas);
  table.add_row({joint, Cell(), Cell(), Cell(), "mesh_estimate", sagittas.size(), 0,
                 kMicrometres * summary.max, kMicrometres * summary.rms});
}

}  // namespace impinge::lab
