// SPDX-License-Identifier: GPL-3.0-or-later
// Limits in closed form: a neck at a rim, a sphere at a torus; and the same limit of bodies with slivers,
// doubled faces, a face missing, a screw inside, and cut open.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limits/turn_limit.hpp"
#include "mesh/bodies.hpp"
#include "mesh/icosphere.hpp"
#include "phantoms/phantom.hpp"
#include "support/joined.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

constexpr std::size_t kSides = 240;      // of round bodies, whose sagitta is below 7e-4 mm then
constexpr double kRoundness = 0.01;      // degrees, of what that makes of a limit
constexpr double kNeckRadius = 8.0;      // mm
constexpr double kRimRadius = 26.0;      // mm from the centre
constexpr double kRim = 75.0 * kDegree;  // from +z

// A head with a round neck about +z in a cup that opens there.
BallSocketPair round_neck() {
  Revolution ball;
  ball.sides = kSides;
  ball.rings = {{0.0, 60.0}, {std::atan(kNeckRadius / 60.0), std::hypot(kNeckRadius, 60.0)}};
  for (double polar = std::asin(kNeckRadius / 20.0); polar < kPi; polar += 0.15)
    ball.rings.push_back({polar, 20.0});
  ball.rings.push_back({kPi, 20.0});
  Revolution socket;
  socket.sides = kSides;
  socket.axis = -Vec3::UnitZ();
  socket.rings = sphere_rings(kRimRadius, kPi - kRim, 0.1);
  return {revolve(ball), test::inside_out(revolve(socket))};
}

// The neck touches where its axis comes as near to a point of the rim as asin(neck / rim), seen from the
// centre: at the nearest one, when the axis has tilted by the rest, b. A turn by t about an axis at an angle
// a to the neck tilts it by b with cos b = cos^2 a + sin^2 a cos t.
TEST(LimitForms, OfANeckAtARimIsAnArcCosine) {
  const TurnLimits limits(round_neck());
  const double tilt = kRim - std::asin(kNeckRadius / kRimRadius);
  for (const double to_axis : {90.0, 65.0, 40.0}) {
    const double c = std::cos(to_axis * kDegree);
    const double s = std::sin(to_axis * kDegree);
    for (const double azimuth : {0.0, 100.0}) {
      const JointTurn turn{.axis = Eigen::AngleAxisd(azimuth * kDegree, Vec3::UnitZ()) * Vec3(s, 0.0, c)};
      const TurnLimit limit = limits.first_contact(turn, 180.0);
      ASSERT_EQ(limit.state, LimitState::limited) << to_axis;
      EXPECT_NEAR(limit.low_deg, std::acos((std::cos(tilt) - c * c) / (s * s)) / kDegree, kRoundness)
          << to_axis;
    }
  }
  // No turn about an axis nearer to the neck than half of that tilts it so far.
  const JointTurn about{.axis = Vec3(std::sin(0.49 * tilt), 0.0, std::cos(0.49 * tilt))};
  EXPECT_EQ(limits.first_contact(about, 180.0).state, LimitState::free);
}

// About +z, of a tube.
TriangleMesh torus(double radius, double tube) {
  constexpr std::size_t kRound = 240;
  constexpr std::size_t kAcross = 120;
  TriangleMesh mesh;
  const auto at = [](std::size_t k, std::size_t l) {
    return static_cast<VertexIndex>(k % kRound * kAcross + l % kAcross);
  };
  for (std::size_t k = 0; k < kRound; ++k) {
    for (std::size_t l = 0; l < kAcross; ++l) {
      const double azimuth = 2.0 * kPi * static_cast<double>(k) / kRound;
      const double height = 2.0 * kPi * static_cast<double>(l) / kAcross;
      const double far = radius + tube * std::cos(height);
      mesh.vertices.emplace_back(far * std::cos(azimuth), far * std::sin(azimuth), tube * std::sin(height));
      mesh.faces.push_back({at(k, l), at(k + 1, l), at(k + 1, l + 1)});
      mesh.faces.push_back({at(k, l), at(k + 1, l + 1), at(k, l + 1)});
    }
  }
  return mesh;
}

// The middle of a sphere turns from +z in a plane through the torus' axis, d from the centre, and touches
// where it is as far from the tube's middle, m from the centre, as both radii: where
// d^2 + m^2 - 2 d m sin t is the square of their sum.
TEST(LimitForms, OfASphereAtATorusIsAnArcSine) {
  const BallSocketPair main{icosphere(20.0, 2), cup(28.0, 60.0, 400)};
  const double m = 42.0;
  const double sum = 9.0;
  for (const double d : {34.5, 38.0, 42.0, 47.0, 50.5, 52.0}) {
    const TurnLimits limits(main, {{test::moved(icosphere(4.0, 5), {0.0, 0.0, d})}, {torus(m, sum - 4.0)}});
    const double sine = (d * d + m * m - sum * sum) / (2.0 * d * m);
    const TurnLimit limit = limits.first_contact({.axis = -Vec3::UnitX()}, 180.0);
    EXPECT_EQ(limit.state, sine < 1.0 ? LimitState::limited : LimitState::free) << d;
    EXPECT_NEAR(limit.low_deg, sine < 1.0 ? std::asin(sine) / kDegree : 180.0, 0.05) << d;
  }
}

// Each fifth face is cut in three at a point a billionth of a millimetre from its first side.
TriangleMesh with_slivers(TriangleMesh mesh) {
  for (std::size_t f = 0, faces = mesh.faces.size(); f < faces; f += 5) {
    const auto [a, b, c] = mesh.faces[f];
    const Vec3 middle = 0.5 * (mesh.vertices[a] + mesh.vertices[b]);
    const auto next = static_cast<VertexIndex>(mesh.vertices.size());
    mesh.vertices.push_back(middle + 1e-9 * (mesh.vertices[c] - middle).normalized());
    mesh.faces[f] = {a, b, next};
    mesh.faces.push_back({b, c, next});
    mesh.faces.push_back({c, a, next});
  }
  return mesh;
}

TriangleMesh doubled(TriangleMesh mesh) {
  for (std::size_t f = 0, faces = mesh.faces.size(); f < faces; ++f) {
    Face again = mesh.faces[f];
    if (f % 2 == 0) std::swap(again[0], again[1]);
    mesh.faces.push_back(again);
  }
  return mesh;
}

TEST(LimitForms, OfDamagedBodiesAreThoseOfSoundOnes) {
  const BallSocketPair main{icosphere(20.0, 2), cup(28.0, 60.0, 400)};
  const double apart = 75.0;  // degrees
  const std::array<double, 2> radius{5.0, 8.0};
  // From the centre to a sphere about +x that turns to the other, or to the other as it lies.
  const auto place = [&](TriangleMesh mesh, bool of_socket) {
    return test::turned(test::moved(std::move(mesh), {40.0, 0.0, 0.0}), of_socket ? apart * kDegree : 0.0,
                        Vec3::UnitZ());
  };
  const auto limit = [&](const TriangleMesh& ball, const TriangleMesh& socket) {
    const TurnLimits limits(main, {{place(ball, false)}, {place(socket, true)}});
    return limits.first_contact({.axis = Vec3::UnitZ()}, 180.0);
  };
  const TriangleMesh ball = icosphere(radius[0], 4);
  const TriangleMesh socket = icosphere(radius[1], 4);
  const TurnLimit sound = limit(ball, socket);
  const double sum = radius[0] + radius[1];
  ASSERT_EQ(sound.state, LimitState::limited);
  EXPECT_NEAR(sound.low_deg, apart - 2.0 * std::asin(sum / 80.0) / kDegree, 0.1);
  // What is met comes first along the way: +y of the ball's, -y of the socket's. The rest is cut off.
  const auto cut = [](double side) {
    return [side](TriangleMesh mesh) {
      std::erase_if(mesh.faces, [&](const Face& face) {
        return std::ranges::any_of(face, [&](VertexIndex v) { return side * mesh.vertices[v].y() < -1.0; });
      });
      return mesh;
    };
  };
  const auto missing = [](TriangleMesh mesh) {
    mesh.faces.erase(std::ranges::max_element(mesh.faces, {}, [&](const Face& face) {
      return std::abs(corner(mesh, face, 0).x());  // neither +y nor -y
    }));
    return mesh;
  };
  const auto screwed = [](const TriangleMesh& mesh) { return test::joined(mesh, icosphere(2.0, 2)); };
  using Does = std::function<TriangleMesh(TriangleMesh)>;
  for (const auto& [name, of_ball, of_socket] :
       {std::tuple<const char*, Does, Does>{"slivers", with_slivers, with_slivers},
        {"doubled", doubled, doubled},
        {"a face missing", missing, missing},
        {"a screw inside", screwed, screwed},
        {"cut open", cut(1.0), cut(-1.0)}}) {
    for (const int which : {1, 2, 3}) {
      const TurnLimit found =
          limit((which & 1) != 0 ? of_ball(ball) : ball, (which & 2) != 0 ? of_socket(socket) : socket);
      EXPECT_EQ(found.state, LimitState::limited) << name << which;
      EXPECT_NEAR(found.low_deg, sound.low_deg, 1e-6) << name << which;
      EXPECT_LT(found.high_deg - found.low_deg, 1e-6) << name << which;
    }
  }
}

}  // namespace
}  // namespace impinge
