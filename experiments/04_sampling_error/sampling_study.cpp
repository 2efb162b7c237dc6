// SPDX-License-Identifier: GPL-3.0-or-later
#include "04_sampling_error/sampling_study.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "curves/conchoid.hpp"
#include "mesh/generated_pair.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

constexpr double kSteepest = 75.0;         // degrees, of the plane
constexpr double kDihedral = 1.6;          // degrees, that of a sphere of 12,000 faces
const Vec3 kAxis = Vec3(0.48, 0.6, 0.64);  // of all shapes: no line of a grid runs along or round it

// The smooth head behind the mesh: a sphere with a bump.
RadialSurface head_surface(const PairShape& shape) {
  RadialSurface surface;
  surface.name = "head_formula";
  surface.radius = [shape](const Vec3& u) { return ball_radius(u, shape); };
  surface.slope = [shape](const Vec3& u) {
    const double width = shape.cam_half_width_deg * kDegree;
    const double t = angle_between(u, cam_direction(shape)) / width;
    if (t >= 1.0) return 0.0;
    return 0.5 * kPi / width * shape.cam_height * std::sin(kPi * t) / ball_radius(u, shape);
  };
  return surface;
}

std::vector<RadialSurface> formulas(double radius) {
  const ConchoidShape hip;
  return {spherical_surface("sphere", radius, Vec3::Zero()),
          spherical_surface("sphere_1mm_off", radius, kAxis),
          spherical_surface("sphere_5mm_off", radius, 5.0 * kAxis),
          conchoid_surface("conchoid", {hip.a, hip.b}, kAxis), head_surface({})};
}

const Column kScheme{"scheme", "", "name of the sampling scheme"};
const Column kPrecision{"precision_deg", "deg", "spacing of the entries at the equator"};

void name_columns(SamplingStudy& study) {
  study.errors.columns = {
      kScheme,
      kPrecision,
      {"formula_max_mm", "mm", "Eq. 7: half the diagonal of a cell at the equator, along the surface"},
      {"formula_relative", "percent", "Eq. 8: the same as a share of the radius"},
      {"measured_max_mm", "mm",
       "largest |radius of the table - radius of the mesh|; empty where it was not measured"},
      {"measured_rms_mm", "mm", "root mean square of it over uniform directions"}};
  study.proven.columns = {kScheme,
                          kPrecision,
                          {"bound_mm", "mm", "proven: no direction with an answer has a larger error"},
                          {"a_priori_mm", "mm", "the bound before any patch of the table was halved"},
                          {"attained_mm", "mm", "largest error that the search for the bound came across"},
                          {"measured_max_mm", "mm", "that of sampling_error.csv"},
                          {"tightness", "1", "the larger of the two errors divided by the bound"}};
  study.surfaces.columns = {
      {"surface", "", "what was sampled"},
      kScheme,
      kPrecision,
      {"tangential_max_mm", "mm", "largest radius times angle from a direction to its nearest entry"},
      {"radial_max_mm", "mm", "largest |radius of the look-up - true radius|"},
      {"radial_rms_mm", "mm", "root mean square of it over uniform directions"},
      {"radial_p9999_mm", "mm", "quantile 0.9999 of it over uniform directions"},
      {"interpolant", "", "nearest entry, smooth (linear in r) or mesh_exact (linear in 1/r)"}};
  study.bounds.columns = {
      {"promise", "", "which bound: nearest entry; smooth on a plane, there at a pole, and across an edge"},
      {"surface", "", "what was sampled"},
      kScheme,
      kPrecision,
      {"reach", "", "radius of the scheme in the bound: covering or stencil; none for nearest"},
      {"error_max_mm", "mm", "largest error"},
      {"share_max", "1", "largest error divided by its bound; 0 where no error exceeds rounding"},
      {"holds", "", "no error is above its bound"}};
}

}  // namespace

namespace {

// Two edges as those between faces of the head, one seen straight on and one obliquely.
std::vector<EdgeShape> edge_shapes(double radius) {
  EdgeShape straight;
  straight.axis = kAxis;
  straight.edge = kAxis.cross(Vec3(0.8, 0.0, -0.6)).normalized();
  straight.radius = radius;
  straight.dihedral_deg = kDihedral;
  EdgeShape oblique = straight;
  oblique.tilt_deg = 50.0;
  return {straight, oblique};
}

void append(std::vector<Vec3>& list, const std::vector<Vec3>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

SamplingStudy make_sampling_study(const StudyOptions& options) {
  SamplingStudy study;
  const PairShape shape;
  study.radius = shape.head_radius;
  study.head = make_ball_socket_pair(options.faces, shape).ball;
  study.directions = uniform_directions(options.uniform, options.seed);
  study.uniform = options.uniform;
  std::ranges::copy_if(study.directions, std::back_inserter(study.away_from_poles),
                       [](const Vec3& u) { return std::abs(u.z()) < std::cos(10.0 * kDegree); });
  for (const double precision : options.precisions)
    append(study.directions, polar_directions(kPolarCells * precision * kDegree, options.polar));
  for (const RadialSurface& surface : formulas(study.radius))
    study.formulas.push_back({surface, probes_of(surface, study.directions)});
  append(study.directions, feature_directions(study.head));
  study.head_formula = probes_of(head_surface(shape), study.directions);
  study.head_mesh.place = study.head_formula.place;
  const RayCaster caster(study.head);
  for (const Vec3& u : study.directions) study.head_mesh.truth.push_back(caster.cast(u, Layer::farthest));
  study.plane = planar_surface("plane", kAxis, study.radius, kSteepest);
  study.edges = edge_shapes(study.radius);
  name_columns(study);
  return study;
}

void add_surface_row(SamplingStudy& study, const StudyCase& now, const ExaminedSurface& examined,
                     std::string_view interpolant, const std::vector<double>& errors) {
  const Probes& probes = examined.probes;
  double tangential = 0.0;
  for (std::size_t k = 0; k < probes.place.size(); ++k)
    tangential = std::max(tangential, probes.truth[k] * now.nearest[probes.place[k]].angle);
  const RadialSurface& surface = examined.surface;
  if (surface.radius && surface.covers(now.gap.direction))
    tangential = std::max(tangential, surface.radius(now.gap.direction) * now.gap.angle);
  const auto uniform =
      static_cast<std::size_t>(std::ranges::lower_bound(probes.place, study.uniform) - probes.place.begin());
  const ErrorSummary summary = summarise_errors(errors, uniform);
  study.surfaces.add_row({surface.name, now.scheme, now.precision, tangential, summary.max, summary.rms,
                          summary.p9999, interpolant});
}

void add_proven_row(SamplingStudy& study, const StudyCase& now, double measured_max,
                    const TableBound& bound) {
  const double rounding = 1e-12 * study.radius;  // of the truth
  if (!(measured_max <= bound.bound_mm + rounding)) {
    throw std::runtime_error(std::string(now.scheme) + " at " + std::to_string(now.precision) +
                             " degrees errs by " + std::to_string(measured_max) +
                             " mm, above its proven bound of " + std::to_string(bound.bound_mm) + " mm");
  }
  study.proven.add_row({now.scheme, now.precision, bound.bound_mm, bound.a_priori_mm, bound.attained_mm,
                        measured_max, std::max(measured_max, bound.attained_mm) / bound.bound_mm});
}

void add_bound_row(SamplingStudy& study, const StudyCase& now, const BoundCheck& check,
                   const std::vector<double>& errors, const std::vector<double>& bounds) {
  const double rounding = 1e-12 * study.radius;
  double largest = 0.0;
  double share = 0.0;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    largest = std::max(largest, errors[k]);
    if (errors[k] > rounding) share = std::max(share, (errors[k] - rounding) / bounds[k]);
  }
  study.bounds.add_row(
      {check.promise, check.surface, now.scheme, now.precision, check.reach, largest, share, share <= 1.0});
}

}  // namespace impinge::lab
