// SPDX-License-Identifier: GPL-3.0-or-later
// One joint with its tables, bounds and limits. What is asked of it is answered as plain structs, which a
// program writes, a page draws: pose_answer.hpp, measurement.hpp, limits.hpp, joint_files.hpp. Angles in
// degrees, lengths in mm, times in ms. Every function that fails throws a std::exception whose what() is one
// line for the reader, and leaves the session as it was.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hip/clock.hpp"
#include "hip/hip_parameters.hpp"
#include "hip/joint.hpp"
#include "hip/motion.hpp"
#include "motion/turn_limit.hpp"
#include "session/surface_table.hpp"
#include "table/near_faces.hpp"

namespace impinge {

/// What a surface has in every pose.
struct SessionPart {
  SessionPart(const TriangleMesh& mesh, const std::vector<MeshPart>& parts);  // about the centre of the ball

  ScannedVertices vertices;  // of the mesh
  std::vector<double> area;  // vertex_areas(), mm^2
  std::vector<bool> used;    // on_surface(), of the main one: the others have no gap
};

/// A joint, and what follows from its meshes.
struct SessionJoint {
  /// `axis_code` says where +x, +y and +z of the meshes point (hip/anatomy.hpp); frames of landmarks go
  /// before it.
  explicit SessionJoint(Joint put_together, std::optional<Side> of, const std::string& axis_code);

  /// What a shift of the ball's centre in the socket means, mm, input frame. The ball turns about its own
  /// centre, which the shift moves. All gaps, tables, bounds and limits are then along rays from that centre,
  /// about which the socket is `seen`: there the pose has no translation, and the statements (1) and (2) of
  /// gap/overlay.hpp are one. Of the pose with its translation it is statement (2). What follows from `seen`
  /// is made anew.
  void shift_to(const Vec3& to);

  /// Of the ball, or of the socket about the centre of the ball.
  const SessionPart& part(Surface of) const { return of == Surface::ball ? ball : socket; }
  /// The mesh of that.
  const TriangleMesh& mesh(Surface of) const { return of == Surface::ball ? joint.ball.mesh : seen; }
  /// The same without its parts.
  TriangleMesh main(Surface of) const {
    return main_surface(mesh(of), (of == Surface::ball ? joint.ball : joint.socket).parts);
  }
  /// The parts of both.
  BoneParts beside() const {
    return {part_surfaces(joint.ball.mesh, joint.ball.parts), part_surfaces(seen, joint.socket.parts)};
  }
  /// Its faces, as gap/measured_gap.hpp asks them; made when first asked for.
  const NearFaces& faces(Surface of);

  Joint joint;                                         // as it was put together
  std::optional<Side> side;                            // of the body
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // input frame to joint frame
  std::optional<ClockFace> dial;                       // joint frame
  SessionPart ball;                                    // about its centre
  Vec3 shift = Vec3::Zero();                           // see shift_to()
  TriangleMesh seen;                                   // the socket about the centre of the ball
  SessionPart socket;                                  // of `seen`
  std::optional<HipParameters> parameters;             // of a hip made from them
  /// Points of ball and socket, for measure_tables().
  std::array<std::unique_ptr<const ScannedVertices>, 2> probes;

 private:
  std::array<std::unique_ptr<const NearFaces>, 2> faces_;
};

/// A mesh of the joint in the axes of the joint frame, about the same origin.
TriangleMesh in_joint_frame(const SessionJoint& joint, TriangleMesh mesh);

/// Tables of both main surfaces.
struct SessionTables {
  TableSettings settings;                        // of both
  std::unique_ptr<SurfaceTable> ball;            // looked up by the socket's vertices
  std::unique_ptr<SurfaceTable> socket;          // looked up by the ball's
  double fill_ms = 0.0;                          // both
  std::optional<double> error_mm;                // largest measured, once measure_tables() has
  std::unique_ptr<SurfaceBounds> ball_bounds;    // once bound_tables() has found them
  std::unique_ptr<SurfaceBounds> socket_bounds;  // the same
};

/// Everything about one joint.
struct Session {
  Session() = default;  // no joint yet
  /// A joint without tables.
  Session(Joint put_together, std::optional<Side> side, const std::string& axis_code)
      : joint(std::make_unique<SessionJoint>(std::move(put_together), side, axis_code)) {}

  std::unique_ptr<SessionJoint> joint;  // that everything is about
  SessionTables tables;                 // filled where fill_tables() or use_*() has
  /// Made when first asked for: about the centre of the ball, and about that of the socket where it has one.
  std::unique_ptr<TurnLimits> limits;
  std::unique_ptr<TurnLimits> socket_limits;
};

/// A hip made from parameters, with tables of the settings that there were.
void use_hip(Session& session, const HipParameters& parameters);
/// A joint of a user's meshes, the same.
void use_meshes(Session& session, JointInput input);

/// Fills the tables of both surfaces.
void fill_tables(Session& session, const TableSettings& settings);

/// Shifts the ball, with the tables and limits; see SessionJoint::shift_to().
void shift_ball(Session& session, const Vec3& shift);

/// The largest error of the tables along every vertex and the middle of every edge of their own meshes, where
/// the exact radius has its kinks. What takes long is remembered for the joint.
void measure_tables(Session& session);

/// Proves bounds for both tables, unless they have some. May take some seconds.
void bound_tables(Session& session);

/// The larger of both tables' bounds over all directions, mm, once there are some.
double whole_bound(const SessionTables& tables);

}  // namespace impinge
