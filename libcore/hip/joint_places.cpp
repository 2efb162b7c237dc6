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
constexpr double kSocketDepth = 1.25;  // radii of the socket from its centre to its deepest place
constexpr double kRimAlone = 0.1;      // radii of the socket from the rim, for "the rim alone"
constexpr double kLeastOff = 0.005;    // head radii by which the neck is off the sphere, at least and at most
constexpr double kMostOff = 0.04;
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

static Vec3 nearest_of_rim(const RimProfile& rim, const Vec3& from_centre) {
  Vec3 nearest = Vec3::Constant(std::numeric_limits<double>::infinity());
  for (const auto& point : rim.points) {
    if (point && (*point - from_centre).norm() < (nearest - from_centre).norm()) nearest = *point;
  }
  return nearest;
}

std::string place_on_socket(const JointPlaces& places, const Vec3& y) {
  if (!places.rim) return "socket";
  const Vec3 from_centre = y - places.socket->centre;
  const double radius = places.socket->radius;
  const Vec3 nearest = nearest_of_rim(*places.rim, from_centre);
  if ((nearest - from_centre).norm() <= kOfRim * radius) return "rim";
  const auto along = [&](const Vec3& of) { return places.rim->pole.dot(of.stableNormalized()); };
  const bool inside = along(from_centre) > along(nearest) && from_centre.norm() <= kSocketDepth * radius;
  return inside ? kInside : "bone beyond the rim";
}

// Keeps the faces that have a corner x with is_of(x).
template <class IsOf>
static void leave_faces(TriangleMesh& mesh, const IsOf& is_of) {
  std::vector<bool> of;
  for (const Vec3& x : mesh.vertices) of.push_back(is_of(x));
  std::erase_if(mesh.faces, [&](const Face& face) { return !of[face[0]] && !of[face[1]] && !of[face[2]]; });
}

void leave_rim(const JointPlaces& places, const Vec3& origin, TriangleMesh& socket) {
  leave_faces(socket, [&](const Vec3& y) {
    if (!places.rim) return false;
    const Vec3 from_centre = origin + y - places.socket->centre;
    return (nearest_of_rim(*places.rim, from_centre) - from_centre).norm() <=
           kRimAlone * places.socket->radius;
  });
  if (socket.faces.empty())
    throw std::invalid_argument(
        "the socket shows no rim; give one that is open, with a ball that has a head");
}

void leave_off_head(const JointPlaces& places, const Vec3& origin, TriangleMesh& ball) {
  const auto from_centre = [&](const Vec3& x) -> Vec3 { return origin + x - places.head->centre; };
  const auto share = [&](const Vec3& x) { return from_centre(x).norm() / places.head->radius; };
  double off = kLeastOff;
  for (const Vec3& x : ball.vertices) {
    if (share(x) <= kJointEnds && from_centre(x).dot(places.neck) <= 0.0) off = std::max(off, share(x) - 1.0);
  }
  off = std::min(off, kMostOff);
  leave_faces(ball, [&](const Vec3& x) {
    return share(x) > kJointEnds || (share(x) > 1.0 + off && from_centre(x).dot(places.neck) > 0.0);
  });
  if (ball.faces.empty())
    throw std::invalid_argument("the ball has nothing but a head; give it with its neck");
}

std::optional<double> rim_in_head(const JointPlaces& places) {
  double deepest = 0.0;
  for (const auto& point : places.rim->points) {
    if (!point) continue;
    const Vec3 from_head = places.socket->centre + *point - places.head->centre;
    deepest = std::max(deepest, places.head->radius - from_head.norm());
  }
  return deepest > 0.0 ? std::optional(deepest) : std::nullopt;
}

std::string meeting_words(const std::string& ball, const std::string& socket) {
  return socket == kInside ? ball + " within the socket" : socket + " and " + ball;
}

}  // namespace impinge
