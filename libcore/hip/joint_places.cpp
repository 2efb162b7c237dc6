// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/joint_places.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "hip/hip_surface.hpp"
#include "hip/whole_bone.hpp"
#include "mesh/sphere_section.hpp"

namespace impinge {
namespace {

constexpr double kOfRim = 0.2;         // radii of the socket from the rim
constexpr double kSocketDepth = 1.25;  // of its deepest place from its centre, the same
constexpr const char* kInside = "inside of the socket";

}  // namespace

JointPlaces joint_places(const BallSocketPair& main) {
  JointPlaces places;
  try {
    places.head = fit_ball(main.ball);
    const double section = MeasureChoices{}.neck_section * places.head->radius;
    const auto neck = sphere_section(relative_to(main.ball, places.head->centre), section);
    if (!neck.empty()) places.neck = neck_axis(neck);
    places.socket = fit_socket(main.socket, *places.head);
    places.rim = rim_profile(near_socket(main.socket, *places.socket), places.socket->radius);
  } catch (const std::invalid_argument&) {
    return places;  // what there is
  }
  return places;
}

std::string place_on_ball(const JointPlaces& places, const Vec3& x) {
  if (!places.head) return "ball";
  const Vec3 from_centre = x - places.head->centre;
  const double share = from_centre.norm() / places.head->radius;
  if (share > kJointEnds) return "trochanter or shaft";
  return share > 1.0 + kAlphaShare && from_centre.dot(places.neck) > 0.0 ? "neck" : "head";
}

std::string place_on_socket(const JointPlaces& places, const Vec3& y) {
  if (!places.rim) return "socket";
  const Vec3 from_centre = y - places.socket->centre;
  const double radius = places.socket->radius;
  double least = std::numeric_limits<double>::infinity();
  Vec3 nearest = Vec3::Zero();
  for (const auto& point : places.rim->points) {
    if (!point || (*point - from_centre).norm() >= least) continue;
    least = (*point - from_centre).norm();
    nearest = *point;
  }
  if (least <= kOfRim * radius) return "rim";
  const auto along = [&](const Vec3& of) { return places.rim->pole.dot(of.stableNormalized()); };
  const bool inside = along(from_centre) > along(nearest) && from_centre.norm() <= kSocketDepth * radius;
  return inside ? kInside : "bone beyond the rim";
}

std::string meeting_words(const std::string& ball, const std::string& socket) {
  return socket == kInside ? ball + " within the socket" : socket + " and " + ball;
}

}  // namespace impinge
