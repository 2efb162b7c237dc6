// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include "17_limit_time/limit_times.hpp"
#include "mesh/bodies.hpp"

namespace impinge::lab {
namespace {

constexpr int kTurns = 12;
constexpr double kTop = 26.0;          // mm, from the centre to the needle's tip
constexpr double kLength = 8.0;        // mm: its base is within the ball
constexpr double kWidth = 2.0;         // mm, radius of its base
constexpr double kSpikeBase = 34.0;    // mm, from the centre to the spikes' base
constexpr double kSpikeWidth = 0.3;    // mm, radius of their base: they are sharper than the needle
constexpr double kDeepest = 5.0;       // mm, by which the first spike's tip is nearer than the needle's
constexpr double kShallowest = 0.05;   // the same for the last spike
constexpr double kFirstSpike = 35.0;   // degrees from the needle
constexpr double kNextSpike = 2.37;    // degrees from one to the next
constexpr double kLargest = 120.0;     // degrees
constexpr double kBallRadius = 20.0;   // mm
constexpr double kCupRadius = 23.0;    // mm
constexpr double kCupOpening = 80.0;   // degrees from its pole, which is opposite the needle
constexpr std::size_t kFaces = 3'000;  // faces of ball and cup, each

Vec3 outward(int turn) {
  const double azimuth = 2.0 * kPi * turn / kTurns;
  return {std::cos(azimuth), std::sin(azimuth), 0.0};
}
Vec3 axis(int turn) { return Vec3::UnitZ().cross(outward(turn)); }
double tip_radius(int turn) {
  return kTop - kDeepest * std::pow(kShallowest / kDeepest, turn / (kTurns - 1.0));
}
double spike_deg(int turn) { return kFirstSpike + kNextSpike * turn; }

// The tip of a spike meets the point of the needle's side that is s mm below the top and w s across it, w the
// slope of the side: (w s)^2 + (top - s)^2 = r^2.
double meeting_deg(int turn) {
  const double r = tip_radius(turn);
  const double slope = kWidth / kLength;
  const double squared = 1.0 + slope * slope;
  const double s = (kTop - std::sqrt(kTop * kTop - squared * (kTop * kTop - r * r))) / squared;
  return spike_deg(turn) - std::atan2(slope * s, kTop - s) / kDegree;
}

// Joins a tip with a ring of corners, counter-clockwise as seen from it.
void add_pyramid(const Vec3& tip, const std::vector<Vec3>& ring, TriangleMesh& mesh) {
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  const auto corners = static_cast<VertexIndex>(ring.size());
  mesh.vertices.push_back(tip);
  mesh.vertices.insert(mesh.vertices.end(), ring.begin(), ring.end());
  for (VertexIndex k = 0; k < corners; ++k)
    mesh.faces.push_back({first, first + 1 + k, first + 1 + (k + 1) % corners});
  for (VertexIndex k = 2; k < corners; ++k) mesh.faces.push_back({first + 1, first + 1 + k, first + k});
}

TriangleMesh ball_with_needle() {
  TriangleMesh ball = sphere(kBallRadius, kFaces);
  std::vector<Vec3> base;
  base.reserve(kTurns);
  for (int k = 0; k < kTurns; ++k) base.push_back(kWidth * outward(k) + (kTop - kLength) * Vec3::UnitZ());
  add_pyramid(kTop * Vec3::UnitZ(), base, ball);
  return ball;
}

TriangleMesh cup_with_spikes() {
  TriangleMesh socket = cup(kCupRadius, kCupOpening, kFaces);
  for (Vec3& x : socket.vertices) x = Vec3(-x.x(), x.y(), -x.z());
  for (int k = 0; k < kTurns; ++k) {
    const double angle = spike_deg(k) * kDegree;
    const Vec3 up = std::sin(angle) * outward(k) + std::cos(angle) * Vec3::UnitZ();
    const Vec3 across = axis(k);
    const Vec3 along = up.cross(across);
    const Vec3 foot = kSpikeBase * up;
    add_pyramid(tip_radius(k) * up,
                {foot + kSpikeWidth * across, foot - kSpikeWidth * along, foot - kSpikeWidth * across,
                 foot + kSpikeWidth * along},
                socket);
  }
  return socket;
}

}  // namespace

TurnedJoint needle_past_spikes() {
  TurnedJoint joint;
  joint.name = "needle past spikes";
  joint.bones = {ball_with_needle(), cup_with_spikes()};
  joint.main = joint.bones;
  for (int k = 0; k < kTurns; ++k) {
    JointTurn turn;
    turn.axis = axis(k);
    joint.motions.push_back({"spike " + std::to_string(k + 1), turn, kLargest, meeting_deg(k)});
  }
  return joint;
}

}  // namespace impinge::lab
