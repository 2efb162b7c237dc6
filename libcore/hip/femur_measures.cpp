// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "hip/hip_measures.hpp"
#include "hip/hip_surface.hpp"
#include "mesh/sphere_section.hpp"

namespace impinge {
namespace {

constexpr double kNeckSection = 1.35;  // of the head's radius, from the centre
constexpr double kShaftStart = 1.45;   // the same: no shaft is nearer
constexpr double kLowerEnd = 0.35;     // of the mesh beyond that, measured from its end: the straight shaft
constexpr double kEndFace = 0.5;       // cosine between normal and axis; above, a face belongs to the cut
constexpr double kRound = 0.05;        // least over middle eigenvalue of normals round a shaft
constexpr int kShaftSteps = 20;

Vec3 mirrored(const Vec3& x, Side side) { return side == Side::left ? Vec3(-x.x(), x.y(), x.z()) : x; }

// The same mesh as a right one, with the head's centre as origin.
TriangleMesh as_right(TriangleMesh mesh, const Vec3& centre, Side side) {
  for (Vec3& v : mesh.vertices) v = mirrored(v - centre, side);
  if (side == Side::left) {
    for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  }
  return mesh;
}

// Mean of a function of the points of a curve, by length.
template <class F>
auto mean_over(const std::vector<Segment>& curve, const F& f) {
  auto sum = f(curve.front()[0]);
  sum *= 0.0;
  double total = 0.0;
  for (const Segment& s : curve) {
    const double length = (s[1] - s[0]).norm();
    sum += 0.5 * length * (f(s[0]) + f(s[1]));
    total += length;
  }
  sum /= total;
  return sum;
}

// Largest angle from the axis at which a curve crosses the half-plane at these hours, degrees.
double highest_crossing(const std::vector<Segment>& curve, const Vec3& axis, const Vec3& outward) {
  const Vec3 across = axis.cross(outward);
  double highest = std::numeric_limits<double>::quiet_NaN();
  for (const Segment& s : curve) {
    const double from = s[0].dot(across);
    const double to = s[1].dot(across);
    if ((from < 0.0) == (to < 0.0)) continue;
    const Vec3 x = s[0] + from / (from - to) * (s[1] - s[0]);
    if (x.dot(outward) > 0.0) highest = std::fmax(highest, angle_between(x, axis) / kDegree);
  }
  return highest;
}

// Direction square to the normals of the straight lower end of the shaft, pointing down it.
std::optional<Vec3> shaft_axis(const TriangleMesh& mesh, double head_radius) {
  Vec3 axis = *std::ranges::max_element(mesh.vertices, {}, [](const Vec3& v) { return v.squaredNorm(); });
  const double beyond = axis.norm() - kShaftStart * head_radius;
  if (!(beyond > 0.0)) return std::nullopt;
  axis.normalize();
  Vec3 spread = Vec3::Zero();
  for (int k = 0; k < kShaftSteps; ++k) {
    double end = 0.0;
    for (const Vec3& v : mesh.vertices) end = std::max(end, v.dot(axis));
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    for (const Face& face : mesh.faces) {
      const Vec3 middle = (corner(mesh, face, 0) + corner(mesh, face, 1) + corner(mesh, face, 2)) / 3.0;
      const Vec3 area = area_vector(mesh, face);
      if (middle.dot(axis) < end - kLowerEnd * beyond) continue;
      if (std::abs(area.dot(axis)) > kEndFace * area.norm()) continue;
      normals += area * area.transpose() / area.norm();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normals);
    const Vec3 next = solver.eigenvectors().col(0);
    spread = solver.eigenvalues();
    axis = next.dot(axis) < 0.0 ? Vec3(-next) : next;
  }
  if (!(spread[0] < kRound * spread[1])) return std::nullopt;
  return axis;
}

// Angle of the neck from the transverse axis, in the plane square to the shaft.
double torsion_deg(const Vec3& neck, const Vec3& shaft) {
  const Vec3 lateral = (Vec3::UnitX() - shaft.x() * shaft).normalized();
  const Vec3 anterior = lateral.cross(shaft);
  return std::atan2(-neck.dot(anterior), neck.dot(lateral)) / kDegree;
}

}  // namespace

FemurMeasures measure_femur(const TriangleMesh& ball, Side side) {
  FemurMeasures found;
  found.head = fit_ball(ball);
  const double radius = found.head.radius;
  const TriangleMesh right = as_right(ball, found.head.centre, side);
  const std::vector<Segment> section = sphere_section(right, kNeckSection * radius);
  if (section.empty()) {
    throw std::invalid_argument("the ball has no neck to measure; give a mesh that reaches 1.35 head radii");
  }
  const Vec3 neck = mean_over(section, [](const Vec3& x) { return x; }).normalized();
  found.neck_axis = mirrored(neck, side);
  found.neck_radius = mean_over(section, [&neck](const Vec3& x) { return x.cross(neck).norm(); });
  found.head_neck_offset = radius - found.neck_radius;
  if (const auto clock = clock_about(neck)) {
    const std::vector<Segment> contour = sphere_section(right, (1.0 + kAlphaShare) * radius);
    for (std::size_t h = 0; h < kClockHours; ++h) {
      const Vec3 outward = clock_direction(neck, *clock, 0.5 * kPi, static_cast<double>(h));
      found.alpha[h] = highest_crossing(contour, neck, outward);
    }
  }
  if (const auto shaft = shaft_axis(right, radius)) {
    found.neck_shaft_angle = 180.0 - angle_between(neck, *shaft) / kDegree;
    found.femoral_torsion = torsion_deg(neck, *shaft);
  }
  return found;
}

}  // namespace impinge
