// SPDX-License-Identifier: GPL-3.0-or-later
// Which way the vertices are found that matter in the poses of a path: each one looked at, or whole caps of
// them decided at once.
//
// The caps are made once, in a time that grows with the faces; looking at each vertex takes a time that grows
// with vertices and poses. With f nanoseconds a face, v a vertex and k a pose with caps, they pay for more
// than
//   f faces / (v vertices - k)
// poses: for some 300, whatever the size of a closed mesh, which has half as many vertices as faces. With k /
// v vertices or fewer they never pay.
//
// Measured with generated joints of 600 to 200,000 faces in both surfaces and 361 poses: f lies between 2.4
// and 7, k is 1 to 4 us, and v is 23 to 50 along a path without contact, 18 to 27 along one that touches in
// most poses, which are decided as soon as a vertex is proven to touch. So the caps begin to pay at 210 to
// 390 poses, and the estimate costs at most a third of the time around there. Experiment 12 (scene_needs) has
// both ways.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace impinge {

inline constexpr double kCapsPerFace = 4000.0;  // f, ns: of both limits, trees included
inline constexpr double kLookPerVertex = 28.0;  // v, ns
inline constexpr double kCulledPerPose = 2e3;   // k, ns

/// What has to be looked at.
struct PathWork {
  std::size_t poses = 1;     // that differ
  std::size_t vertices = 0;  // of the surfaces that are scanned
  std::size_t faces = 0;     // of all surfaces that are met
};

/// Never: no number of poses pays.
inline constexpr std::size_t kNoPoses = std::numeric_limits<std::size_t>::max();

/// The way that is taken, and why.
struct PathChoice {
  bool culled = false;               // whole caps at once
  std::size_t pays_from = kNoPoses;  // so many poses or more pay for the caps
  std::string reason;                // one clause, with the numbers that it rests on
};

/// The cheaper way by that estimate.
PathChoice choose_path(const PathWork& work);

}  // namespace impinge
