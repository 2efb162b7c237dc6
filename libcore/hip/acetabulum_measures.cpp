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
#include "mesh/sphere_section.hpp"
#include "sphere/schemes/fibonacci.hpp"
#include "table/near_faces.hpp"

namespace impinge {
namespace {

constexpr double kOnPlane = 0.1;       // mm
constexpr double kEnough = 1.0 / 3.0;  // of the points, on the plane
constexpr int kTrials = 2000;
constexpr unsigned kSeed = 1;
constexpr std::size_t kMeridians = 180;
constexpr double kFirst = 30.0 * kDegree;  // from the pole: within is the fossa
constexpr double kFloor = 75.0 * kDegree;  // before that a meridian has met the sphere
constexpr double kLast = 130.0 * kDegree;  // beyond is no rim
constexpr double kStep = 0.5 * kDegree;
constexpr double kAtEnd = 0.5;           // mm
constexpr double kDent = 3.0 * kDegree;  // of the rim, that is bridged

// The faces that may bound the socket, about its centre.
TriangleMesh near_socket(const TriangleMesh& socket, const SphereFit& sphere) {
  TriangleMesh near = relative_to({socket.vertices, {}}, sphere.centre);
  std::ranges::copy_if(socket.faces, std::back_inserter(near.faces),
                       [&](const Face& face) { return near.vertices[face[0]].norm() < 2.0 * sphere.radius; });
  return near;
}

// A socket about its centre, as rays from there meet it.
struct Sphere {
  const NearFaces& faces;
  double radius;  // mm
  double band;    // share of it

  bool covers(const Vec3& u) const {
    return std::abs(faces.radius(u, Layer::nearest) / radius - 1.0) < band;  // NaN where nothing is met
  }
};

// Into the socket: the mean of what is covered.
Vec3 pole_of(const Sphere& sphere) {
  const auto directions = Fibonacci::with_precision(4.0);
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < directions.size(); ++k) {
    if (sphere.covers(directions.direction(k))) sum += directions.direction(k);
  }
  if (sum.isZero(0.0))
    throw std::invalid_argument("the socket has no inside to measure; check that it is one");
  return sum.normalized();
}

// Where the surface leaves the sphere along a meridian, radians from the pole; none where it never meets it,
// or does not leave it.
std::optional<double> rim_on(const Sphere& sphere, const Vec3& pole, const Vec3& outward) {
  const auto at = [&](double polar) { return Vec3(std::cos(polar) * pole + std::sin(polar) * outward); };
  std::optional<double> last;
  for (double polar = kFirst; polar < kLast; polar += kStep) {
    if (sphere.covers(at(polar))) last = polar;
    if (!last && polar > kFloor) return std::nullopt;
    if (last && polar > *last + kDent) break;
  }
  if (!last || *last + kStep >= kLast) return std::nullopt;
  double high = *last + kStep;
  for (int k = 0; k < 12; ++k) {
    const double middle = 0.5 * (*last + high);
    (sphere.covers(at(middle)) ? *last : high) = middle;
  }
  return last;
}

// The rim about the socket's centre, mm; a meridian without one has no point. And the share of directions
// within.
struct Rim {
  std::vector<std::optional<Vec3>> points;
  double coverage = 0.0;
};

Rim rim_of(const Sphere& sphere, const Vec3& pole, double first_meridian) {
  const Vec3 across = pole.unitOrthogonal();
  const Vec3 third = pole.cross(across);
  Rim rim;
  std::size_t met = 0;
  for (std::size_t k = 0; k < kMeridians; ++k) {
    const double turn =
        2.0 * kPi * (static_cast<double>(k) + first_meridian) / static_cast<double>(kMeridians);
    const Vec3 outward = std::cos(turn) * across + std::sin(turn) * third;
    const auto polar = rim_on(sphere, pole, outward);
    rim.points.emplace_back();
    if (!polar) continue;
    const Vec3 u = std::cos(*polar) * pole + std::sin(*polar) * outward;
    rim.points.back() = sphere.faces.radius(u, Layer::nearest) * u;
    rim.coverage += 0.5 * (1.0 - std::cos(*polar));
    ++met;
  }
  if (2 * met < kMeridians)
    throw std::invalid_argument("the socket has no rim to measure; give one that is open");
  rim.coverage /= static_cast<double>(met);
  return rim;
}

double distance_to(const Segment& edge, const Vec3& x) {
  const Vec3 along = edge[1] - edge[0];
  const double share = std::clamp((x - edge[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (edge[0] + share * along - x).norm();
}

// Share of the rim where an edge of one face alone is near.
double at_mesh_end(const TriangleMesh& mesh, const Rim& rim) {
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

// Those points of the plane of three that has most of them.
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

// The plane that most points lie on, refined over these.
Plane rim_plane(const Rim& rim, double tolerance_times) {
  std::vector<Vec3> points;
  for (const auto& x : rim.points) {
    if (x) points.push_back(*x);
  }
  double tolerance = kOnPlane;
  const auto enough = static_cast<std::size_t>(kEnough * static_cast<double>(points.size()));
  while (most_on_a_plane(points, tolerance).size() < enough) tolerance *= 2.0;
  return plane_through(most_on_a_plane(points, tolerance_times * tolerance));
}

// Where the rim crosses the coronal plane through the head's centre, the upper of the crossings; `centre`
// from that of the socket.
std::optional<double> lateral_centre_edge(const Rim& rim, const Vec3& centre, double lateral) {
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
  const NearFaces faces(near, 0.0);
  const Sphere sphere{faces, found.socket.radius, choices.rim_band};
  const Vec3 pole = pole_of(sphere);
  const Rim rim = rim_of(sphere, pole, choices.first_meridian);
  const Plane plane = rim_plane(rim, choices.plane_tolerance);
  const double out = plane.normal.dot(pole) > 0.0 ? -1.0 : 1.0;
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
