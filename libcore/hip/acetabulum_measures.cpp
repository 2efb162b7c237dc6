// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "hip/hip_measures.hpp"
#include "hip/rim_profile.hpp"
#include "mesh/sphere_section.hpp"

namespace impinge {
namespace {

constexpr double kOnPlane = 0.1;       // mm
constexpr double kEnough = 1.0 / 3.0;  // of the points, on the plane
constexpr int kTrials = 2000;
constexpr unsigned kSeed = 1;
constexpr double kAtEnd = 0.5;  // mm

double distance_to(const Segment& edge, const Vec3& x) {
  const Vec3 along = edge[1] - edge[0];
  const double share = std::clamp((x - edge[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (edge[0] + share * along - x).norm();
}

// Share of the rim's points that are near an edge of only one face.
double at_mesh_end(const TriangleMesh& mesh, const RimProfile& rim) {
  std::map<std::pair<VertexIndex, VertexIndex>, int> uses;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) ++uses[std::minmax(face[k], face[(k + 1) % 3])];
  }
  std::vector<Segment> ends;
  for (const auto& [edge, count] : uses) {
    if (count == 1) ends.push_back({mesh.vertices[edge.first], mesh.vertices[edge.second]});
  }
  double near = 0.0;
  double all = 0.0;
  for (const auto& x : rim.points) {
    if (!x) continue;
    all += 1.0;
    if (std::ranges::any_of(ends, [&](const Segment& edge) { return distance_to(edge, *x) < kAtEnd; }))
      near += 1.0;
  }
  return near / all;
}

// The points x with normal.x = distance.
struct Plane {
  Vec3 normal = Vec3::Zero();
  double distance = 0.0;
  double from(const Vec3& x) const { return std::abs(normal.dot(x) - distance); }
};

// The plane that fits points best, by least squares.
Plane plane_through(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& x : points) mean += x / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& x : points) spread += (x - mean) * (x - mean).transpose();
  const Vec3 normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  return {normal, normal.dot(mean)};
}

// Of planes through three random points takes the one that most points lie on; returns these points.
std::vector<Vec3> most_on_a_plane(const std::vector<Vec3>& points, double tolerance) {
  std::mt19937 random(kSeed);
  const auto pick = [&]() -> const Vec3& { return points[random() % points.size()]; };
  std::vector<Vec3> best;
  for (int k = 0; k < kTrials; ++k) {
    const Vec3& a = pick();
    const Vec3& b = pick();
    const Vec3 normal = (b - a).cross(pick() - a);
    if (normal.norm() == 0.0) continue;
    const Plane trial{normal.normalized(), normal.normalized().dot(a)};
    std::vector<Vec3> on;
    std::ranges::copy_if(points, std::back_inserter(on),
                         [&](const Vec3& x) { return trial.from(x) <= tolerance; });
    if (on.size() > best.size()) best = std::move(on);
  }
  return best;
}

// The plane that most points of the rim lie on, fitted to these points.
Plane rim_plane(const RimProfile& rim, double tolerance_times) {
  std::vector<Vec3> points;
  for (const auto& x : rim.points) {
    if (x) points.push_back(*x);
  }
  double tolerance = kOnPlane;
  const auto enough = static_cast<std::size_t>(kEnough * static_cast<double>(points.size()));
  while (most_on_a_plane(points, tolerance).size() < enough) tolerance *= 2.0;
  return plane_through(most_on_a_plane(points, tolerance_times * tolerance));
}

// The angle at the upper place where the rim crosses the coronal plane through the head's centre. `centre` is
// the head's, relative to the socket's.
std::optional<double> lateral_centre_edge(const RimProfile& rim, const Vec3& centre, double lateral) {
  std::optional<Vec3> highest;
  for (std::size_t k = 0; k < rim.points.size(); ++k) {
    const auto& from = rim.points[k];
    const auto& to = rim.points[(k + 1) % rim.points.size()];
    if (!from || !to) continue;
    const Vec3 a = *from - centre;
    const Vec3 b = *to - centre;
    if ((a.y() < 0.0) == (b.y() < 0.0)) continue;
    const Vec3 x = a + a.y() / (a.y() - b.y()) * (b - a);
    if (!highest || x.z() > highest->z()) highest = x;
  }
  if (!highest) return std::nullopt;
  return std::atan2(lateral * highest->x(), highest->z()) / kDegree;
}

}  // namespace

AcetabulumMeasures measure_acetabulum(const TriangleMesh& socket, const SphereFit& head, Side side,
                                      const MeasureChoices& choices) {
  AcetabulumMeasures found;
  found.socket = fit_socket(socket, head, {.trim = choices.trim});
  const TriangleMesh near = near_socket(socket, found.socket);
  const RimProfile rim = rim_profile(near, found.socket.radius, choices);
  const Plane plane = rim_plane(rim, choices.plane_tolerance);
  const double out = plane.normal.dot(rim.pole) > 0.0 ? -1.0 : 1.0;
  found.opening = out * plane.normal;
  const double lateral = side == Side::left ? -1.0 : 1.0;
  const Vec3& o = found.opening;
  found.version = std::atan2(o.y(), lateral * o.x()) / kDegree;
  found.inclination = std::atan2(lateral * o.x(), -o.z()) / kDegree;
  const double height = std::clamp(-out * plane.distance / found.socket.radius, -1.0, 1.0);
  found.half_opening = std::acos(height) / kDegree;
  found.lateral_centre_edge = lateral_centre_edge(rim, head.centre - found.socket.centre, lateral);
  found.coverage = rim.coverage;
  found.at_mesh_end = at_mesh_end(near, rim);
  return found;
}

}  // namespace impinge
