// SPDX-License-Identifier: GPL-3.0-or-later
#include "04_sampling_error/sampling_study.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "mesh/generated_pair.hpp"
#include "reference/exact_radius.hpp"
#include "table/probe_directions.hpp"

namespace impinge::lab {
namespace {

constexpr double kPolarCells = 3.0;  // directions within so many spacings of a pole are close to it

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
  study.sphere.columns = {kScheme,
                          kPrecision,
                          {"tangential_max_mm", "mm",
                           "largest distance from an entry along a sphere: radius times covering radius"},
                          {"radial_max_mm", "mm", "largest |radius of the look-up - that of the sphere|"}};
  study.bounds.columns = {
      kScheme,
      kPrecision,
      {"reach", "", "radius of the scheme in the bound: covering or stencil"},
      {"error_max_mm", "mm", "largest error of a look-up on a plane, away from the poles"},
      {"share_max", "1", "largest error divided by its bound"},
      {"holds", "", "no error is above its bound"}};
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
  append(study.directions, feature_directions(study.head));
  study.truth = exact_radii(study.head, {study.directions, Layer::farthest, {}});
  name_columns(study);
  return study;
}

void add_proven_row(SamplingStudy& study, const StudyCase& now, double measured_max,
                    const TableBound& bound) {
  const double rounding = 1e-12 * study.radius;  // rounding of the truth
  if (!(measured_max <= bound.bound_mm + rounding)) {
    throw std::runtime_error(std::string(now.scheme) + " at " + std::to_string(now.precision) +
                             " degrees errs by " + std::to_string(measured_max) +
                             " mm, above its proven bound of " + std::to_string(bound.bound_mm) + " mm");
  }
  study.proven.add_row({now.scheme, now.precision, bound.bound_mm, bound.a_priori_mm, bound.attained_mm,
                        measured_max, std::max(measured_max, bound.attained_mm) / bound.bound_mm});
}

}  // namespace impinge::lab
