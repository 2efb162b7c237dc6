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

#include "hip/clock.hpp"
#include "hip/hip_parameters.hpp"
#include "hip/joint.hpp"
#include "hip/motion.hpp"
#include "motion/turn_limit.hpp"
#include "surface_bounds.hpp"
#include "surface_table.hpp"
#include "table/near_faces.hpp"

namespace impinge {

struct Session;

// What a surface has in every pose.
struct SessionPart {
  explicit SessionPart(const TriangleMesh& mesh);

  ScannedVertices vertices;
  std::vector<double> area;        // vertex_areas(), mm^2
  std::vector<std::size_t> stray;  // vertices of no face: they have no gap
};

struct SessionJoint {
  explicit SessionJoint(Joint put_together, std::optional<Side> of, const std::string& axis_code);

  // Shifts the ball in the socket, mm, input frame: what follows from `seen` is made anew.
  void shift_to(const Vec3& to);

  Joint joint;
  std::optional<Side> side;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // input frame to joint frame
  std::optional<ClockFace> dial;                       // joint frame
  SessionPart ball;
  Vec3 shift = Vec3::Zero();                // of the ball's centre from that of the socket, mm, input frame
  TriangleMesh seen;                        // the socket about the centre of the ball
  SessionPart socket;                       // of `seen`
  std::optional<HipParameters> parameters;  // of a hip made from them
  // Points of the surfaces, for measure_tables().
  std::unique_ptr<const ScannedVertices> ball_probes;
  std::unique_ptr<const ScannedVertices> socket_probes;
  // Faces of both as measured_gap.hpp asks them, once near_faces() has made them.
  std::unique_ptr<const NearFaces> ball_faces;
  std::unique_ptr<const NearFaces> seen_faces;
};

// What a shift of the ball means. The ball turns about its own centre, which the shift moves in the socket.
// All gaps, tables, bounds and limits are then along rays from that centre, about which the socket is `seen`:
// there the pose has no translation, and the statements (1) and (2) of gap/overlay.hpp are one. Of the
// pose with its translation it is statement (2).
void shift_ball(Session& session, const Vec3& shift);

// Makes the faces of both surfaces ready to be measured.
void near_faces(SessionJoint& joint);

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
  // Made when first asked for: about the centre of the ball, and about that of the socket where it has one.
  std::unique_ptr<TurnLimits> limits;
  std::unique_ptr<TurnLimits> socket_limits;
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
