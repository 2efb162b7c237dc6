// SPDX-License-Identifier: GPL-3.0-or-later
// One joint and its tables, as the page asks for them. Angles in degrees, lengths in mm, times in ms. Every
// function that fails throws a std::exception whose what() is one line for the reader, and leaves the session
// as it was.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "joint/clock.hpp"
#include "joint/hip_parameters.hpp"
#include "joint/joint.hpp"
#include "joint/motion.hpp"
#include "limits/turn_limit.hpp"
#include "surface_bounds.hpp"
#include "surface_table.hpp"

namespace impinge {

// What a surface has in every pose.
struct SessionPart {
  explicit SessionPart(const TriangleMesh& mesh);

  ScannedVertices vertices;
  std::vector<double> area;        // vertex_areas(), mm^2
  std::vector<std::size_t> stray;  // vertices of no face: they have no gap
};

struct SessionJoint {
  explicit SessionJoint(Joint put_together, std::optional<Side> of, const std::string& axis_code);

  Joint joint;
  std::optional<Side> side;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // input frame to joint frame
  std::optional<ClockFace> dial;                       // joint frame
  SessionPart ball;
  SessionPart socket;
  std::optional<HipParameters> parameters;  // of a hip made from them
  // Points of the surfaces, for measure_tables().
  std::unique_ptr<const ScannedVertices> ball_probes;
  std::unique_ptr<const ScannedVertices> socket_probes;
};

struct SessionTables {
  TableSettings settings;
  std::unique_ptr<SurfaceTable> ball;
  std::unique_ptr<SurfaceTable> socket;
  double fill_ms = 0.0;            // both
  std::optional<double> error_mm;  // largest measured, once measure_tables() has
  // Once bound_tables() has found them.
  std::unique_ptr<SurfaceBounds> ball_bounds;
  std::unique_ptr<SurfaceBounds> socket_bounds;
};

struct Session {
  std::unique_ptr<SessionJoint> joint;
  SessionTables tables;
  std::unique_ptr<TurnLimits> limits;  // made when first asked for
};

// A hip made from parameters, and a joint of a user's meshes. The tables are then filled anew, with the
// settings that there were.
void use_hip(Session& session, const HipParameters& parameters);
void use_meshes(Session& session, JointInput input);

// Fills the tables of both surfaces.
void fill_tables(Session& session, const TableSettings& settings);

// The largest error of the tables along every vertex and the middle of every edge of their own meshes, where
// the exact radius has its kinks. What takes long is remembered for the joint.
void measure_tables(Session& session);

// Proves bounds for both tables (surface_bounds.hpp), unless they have some. Takes some seconds.
void bound_tables(Session& session);

// The larger of both tables' bounds over all directions, mm, once there are some.
double whole_bound(const SessionTables& tables);

}  // namespace impinge
