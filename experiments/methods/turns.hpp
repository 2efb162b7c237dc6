// SPDX-License-Identifier: GPL-3.0-or-later
// When do two features, or two meshes, first meet while one turns about an axis through the origin?
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/triangle_mesh.hpp"
#include "methods/method.hpp"

namespace impinge::lab {

/// A question about a turn.
struct TurnQuery {
  enum class Kind { vertex_face, edge_edge, face_face, mesh };
  Kind kind = Kind::mesh;
  TriangleMesh turning;  // a point or an edge is a face that repeats corners
  TriangleMesh resting;  // likewise
  Vec3 axis;             // unit vector
  double largest = 0.0;  // radians, at most pi
};

/// The first angle, radians; none if they do not meet up to the largest.
struct TurnAnswer {
  std::optional<double> angle;
  bool certain = true;  // else there is no contact up to the angle, and nothing is known beyond
};
using FindTurn = std::function<TurnAnswer()>;

/// One setting of a method, and how it is prepared.
struct TurnCase : Case {
  std::vector<TurnQuery::Kind> kinds;                   // kinds of queries that it can answer
  std::function<FindTurn(const TurnQuery&)> make = {};  // done once for both; the query must outlive it
  bool takes(TurnQuery::Kind kind) const { return std::ranges::find(kinds, kind) != kinds.end(); }
};

/// The pose after a turn by `angle` radians.
inline Pose turned_pose(const TurnQuery& query, double angle) {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(angle, query.axis).toRotationMatrix();
  return pose;
}

/// Steps, radians, until a pose touches, then halves the last step to 1e-7.
inline TurnAnswer stepped(const TurnQuery& query, const Touch& touches, double step) {
  constexpr double kResolution = 1e-7;
  if (touches(turned_pose(query, 0.0))) return {0.0};
  for (double free = 0.0; free < query.largest;) {
    double touching = std::min(free + step, query.largest);
    if (!touches(turned_pose(query, touching))) {
      free = touching;
      continue;
    }
    while (touching - free > kResolution) {
      const double middle = 0.5 * (free + touching);
      (touches(turned_pose(query, middle)) ? touching : free) = middle;
    }
    return {touching};
  }
  return {};
}

}  // namespace impinge::lab
