// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/rim_profile.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "sphere/schemes/fibonacci.hpp"
#include "table/near_faces.hpp"

namespace impinge {
namespace {

constexpr std::size_t kMeridians = 180;
constexpr double kFirst = 30.0 * kDegree;  // from the pole: the fossa lies within
constexpr double kFloor = 75.0 * kDegree;  // a meridian meets the sphere before this, or not at all
constexpr double kLast = 130.0 * kDegree;  // there is no rim beyond
constexpr double kStep = 0.5 * kDegree;
constexpr double kDent = 3.0 * kDegree;  // dents of the rim up to this size are bridged

// A socket about its centre, as rays from there meet it.
struct Sphere {
  const NearFaces& faces;
  double radius;  // mm
  double band;    // share of it

  bool covers(const Vec3& u) const {
    return std::abs(faces.radius(u, Layer::nearest) / radius - 1.0) < band;  // NaN where nothing is met
  }
};

// Points into the socket: the mean of the directions that it covers.
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

// Where the surface leaves the sphere along a meridian, radians from the pole. None if it never meets the
// sphere, or never leaves it.
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

}  // namespace

TriangleMesh near_socket(const TriangleMesh& socket, const SphereFit& sphere) {
  TriangleMesh near = relative_to({socket.vertices, {}}, sphere.centre);
  std::ranges::copy_if(socket.faces, std::back_inserter(near.faces),
                       [&](const Face& face) { return near.vertices[face[0]].norm() < 2.0 * sphere.radius; });
  return near;
}

RimProfile rim_profile(const TriangleMesh& near, double radius, const MeasureChoices& choices) {
  const NearFaces faces(near, 0.0);
  const Sphere sphere{faces, radius, choices.rim_band};
  const Vec3 pole = pole_of(sphere);
  const Vec3 across = pole.unitOrthogonal();
  const Vec3 third = pole.cross(across);
  RimProfile rim{pole, {}, 0.0};
  std::size_t met = 0;
  for (std::size_t k = 0; k < kMeridians; ++k) {
    const double turn =
        2.0 * kPi * (static_cast<double>(k) + choices.first_meridian) / static_cast<double>(kMeridians);
    const Vec3 outward = std::cos(turn) * across + std::sin(turn) * third;
    const auto polar = rim_on(sphere, pole, outward);
    rim.points.emplace_back();
    if (!polar) continue;
    const Vec3 u = std::cos(*polar) * pole + std::sin(*polar) * outward;
    rim.points.back() = faces.radius(u, Layer::nearest) * u;
    rim.coverage += 0.5 * (1.0 - std::cos(*polar));
    ++met;
  }
  if (2 * met < kMeridians)
    throw std::invalid_argument("the socket has no rim to measure; give one that is open");
  rim.coverage /= static_cast<double>(met);
  return rim;
}

}  // namespace impinge
