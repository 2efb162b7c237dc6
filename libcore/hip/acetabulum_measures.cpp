// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "hip/hip_measures.hpp"
#include "mesh/sphere_section.hpp"

namespace impinge {
namespace {

constexpr double kOnPlane = 0.1;  // mm
constexpr int kTrials = 2000;
constexpr unsigned kSeed = 1;

bool looks_to(const TriangleMesh& mesh, const Face& face, const Vec3& centre) {
  return area_vector(mesh, face).dot(corner(mesh, face, 0) - centre) < 0.0;
}

// The sphere of the inner surface: a wall has an outer one about the same centre.
SphereFit fit_inside(const TriangleMesh& socket) {
  const Vec3 centre = fit_ball(socket).centre;
  TriangleMesh inside{socket.vertices, {}};
  std::ranges::copy_if(socket.faces, std::back_inserter(inside.faces),
                       [&](const Face& face) { return looks_to(socket, face, centre); });
  if (inside.faces.empty()) throw std::invalid_argument("no face of the socket looks to its centre");
  return fit_ball(inside);
}

// Edges of one face that looks to the centre and of no other such face.
std::vector<Segment> rim_of(const TriangleMesh& mesh, const Vec3& centre) {
  std::map<std::pair<VertexIndex, VertexIndex>, int> uses;
  for (const Face& face : mesh.faces) {
    if (!looks_to(mesh, face, centre)) continue;
    for (std::size_t k = 0; k < 3; ++k) ++uses[std::minmax(face[k], face[(k + 1) % 3])];
  }
  std::vector<Segment> rim;
  for (const auto& [edge, count] : uses) {
    if (count == 1) rim.push_back({mesh.vertices[edge.first], mesh.vertices[edge.second]});
  }
  return rim;
}

// Points of n.x = distance.
struct Plane {
  Vec3 normal = Vec3::Zero();
  double distance = 0.0;
  double from(const Vec3& x) const { return std::abs(normal.dot(x) - distance); }
};

// Least squares plane.
Plane plane_through(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& x : points) mean += x / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& x : points) spread += (x - mean) * (x - mean).transpose();
  const Vec3 normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  return {normal, normal.dot(mean)};
}

// The plane that most points lie on, refined over these.
Plane rim_plane(const std::vector<Vec3>& points) {
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
                         [&](const Vec3& x) { return trial.from(x) <= kOnPlane; });
    if (on.size() > best.size()) best = std::move(on);
  }
  return plane_through(best);
}

// Where the rim crosses the coronal plane through the head's centre, the upper of the crossings.
std::optional<double> lateral_centre_edge(const std::vector<Segment>& rim, const Vec3& centre,
                                          double lateral) {
  std::optional<Vec3> highest;
  for (const Segment& edge : rim) {
    const Vec3 a = edge[0] - centre;
    const Vec3 b = edge[1] - centre;
    if ((a.y() < 0.0) == (b.y() < 0.0)) continue;
    const Vec3 x = a + a.y() / (a.y() - b.y()) * (b - a);
    if (!highest || x.z() > highest->z()) highest = x;
  }
  if (!highest) return std::nullopt;
  return std::atan2(lateral * highest->x(), highest->z()) / kDegree;
}

}  // namespace

AcetabulumMeasures measure_acetabulum(const TriangleMesh& socket, const Vec3& head_centre, Side side) {
  AcetabulumMeasures found;
  found.socket = fit_inside(socket);
  const std::vector<Segment> rim = rim_of(socket, found.socket.centre);
  if (rim.size() < 3) throw std::invalid_argument("the socket has no rim to measure; give one that is open");
  std::vector<Vec3> points;
  Vec3 towards_pole = Vec3::Zero();
  for (const Segment& edge : rim) {
    for (const Vec3& x : edge) points.push_back(x - found.socket.centre);
  }
  for (const Face& face : socket.faces) {
    if (looks_to(socket, face, found.socket.centre)) towards_pole -= area_vector(socket, face);
  }
  const Plane plane = rim_plane(points);
  const double out = plane.normal.dot(towards_pole) > 0.0 ? -1.0 : 1.0;
  found.opening = out * plane.normal;
  const double lateral = side == Side::left ? -1.0 : 1.0;
  const Vec3& o = found.opening;
  found.version = std::atan2(o.y(), lateral * o.x()) / kDegree;
  found.inclination = std::atan2(lateral * o.x(), -o.z()) / kDegree;
  const double height = std::clamp(-out * plane.distance / found.socket.radius, -1.0, 1.0);
  found.half_opening = std::acos(height) / kDegree;
  found.lateral_centre_edge = lateral_centre_edge(rim, head_centre, lateral);
  return found;
}

}  // namespace impinge
