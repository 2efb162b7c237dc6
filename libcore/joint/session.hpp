// SPDX-License-Identifier: GPL-3.0-or-later
// One joint with its tables, bounds and limits. touch.hpp, gaps.hpp, limits.hpp and joint_files.hpp answer
// questions about it as plain structs. Angles in degrees, lengths in mm, times in ms. A function that fails
// throws a std::exception whose what() is one line for the user; the session can still be used.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hip/clock.hpp"
#include "hip/hip_parameters.hpp"
#include "hip/joint.hpp"
#include "hip/joint_places.hpp"
#include "hip/motion.hpp"
#include "joint/surface_table.hpp"
#include "limits/turn_limit.hpp"
#include "table/near_faces.hpp"

namespace impinge {

/// The data of a surface that do not depend on the pose.
struct SessionPart {
  SessionPart(const TriangleMesh& mesh, const std::vector<MeshPart>& parts);  // about the centre of the ball

  ScannedVertices vertices;  // of the mesh
  std::vector<double> area;  // vertex_areas(), mm^2
  std::vector<bool> used;    // by vertex: on the main surface (on_surface())? Other vertices have no gap
};

/// A joint, and the data that follow from its meshes.
struct SessionJoint {
  /// `axis_code` says where +x, +y and +z of the meshes point (hip/anatomy.hpp). The joint frame comes from
  /// the landmarks if put_together has some, else from the code.
  explicit SessionJoint(Joint put_together, std::optional<Side> of, const std::string& axis_code);

  /// Shifts the ball's centre in the socket by `to`, mm, in the axes of the input frame. The ball then turns
  /// about its shifted centre. All gaps, tables, bounds and limits are along rays from there; `seen` is the
  /// socket about that centre, and is made anew with all that follows from it. In that frame the pose has no
  /// translation and statements (1) and (2) of gap/overlay.hpp coincide; contact in the pose with its
  /// translation is statement (2).
  void shift_to(const Vec3& to);

  /// Data of the ball, or of the socket about the centre of the ball.
  const SessionPart& part(Surface of) const { return of == Surface::ball ? ball : socket; }
  /// The bone as it was put together.
  const JointPart& bone(Surface of) const { return of == Surface::ball ? joint.ball : joint.socket; }
  /// The mesh of the ball, or of the socket about the centre of the ball.
  const TriangleMesh& mesh(Surface of) const { return of == Surface::ball ? joint.ball.mesh : seen; }
  /// The mesh without its parts.
  TriangleMesh main(Surface of) const { return main_surface(mesh(of), bone(of).parts); }
  /// The bone of both sides beside the main surfaces.
  BoneParts beside() const {
    return bone_parts({joint.ball.mesh, joint.ball.parts}, {seen, joint.socket.parts});
  }
  /// Hours on the dial of a place in the centre frame of the socket; none without a dial.
  std::optional<double> hours(const Vec3& place) const {
    return dial ? std::optional(dial->hours(axes * place)) : std::nullopt;
  }
  /// The bodies of the joint about the centre of the ball; made at the first call.
  const BodyPairs& bodies();
  /// The faces of a main surface, for gap/measured_gap.hpp; made at the first call.
  const NearFaces& faces(Surface of);

  Joint joint;                                         // as it was put together
  std::optional<Side> side;                            // of the body
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // input frame to joint frame
  std::optional<ClockFace> dial;                       // joint frame
  SessionPart ball;                                    // about its centre
  Vec3 shift = Vec3::Zero();                           // see shift_to()
  TriangleMesh seen;                                   // the socket about the centre of the ball
  SessionPart socket;                                  // of `seen`
  std::optional<HipParameters> parameters;             // set if the hip was made from parameters
  /// Points of ball and socket, for measure_tables().
  std::array<std::unique_ptr<const ScannedVertices>, 2> probes;

 private:
  struct MainFaces {
    explicit MainFaces(TriangleMesh main) : mesh(std::move(main)), faces(mesh, 0.0) {}
    TriangleMesh mesh;
    NearFaces faces;
  };
  std::array<std::unique_ptr<const MainFaces>, 2> faces_;
  std::unique_ptr<const BodyPairs> bodies_;
};

/// A mesh of the joint in the axes of the joint frame, about the same origin.
TriangleMesh in_joint_frame(const SessionJoint& joint, TriangleMesh mesh);

/// Tables of both main surfaces.
struct SessionTables {
  TableSettings settings;                        // of both
  std::unique_ptr<SurfaceTable> ball;            // the socket's vertices are looked up in it
  std::unique_ptr<SurfaceTable> socket;          // the ball's vertices are looked up in it
  double fill_ms = 0.0;                          // for both
  std::optional<double> error_mm;                // largest measured error; set by measure_tables()
  std::unique_ptr<SurfaceBounds> ball_bounds;    // set by bound_tables()
  std::unique_ptr<SurfaceBounds> socket_bounds;  // set by bound_tables()
};

/// Turns of a joint about one centre, which is the origin of the meshes, in the axes of the joint frame.
struct CentredLimits {
  CentredLimits(const Joint& joint, BallSocketPair about, const Vec3& from_centre);
  /// For the rim alone (hip/joint_places.hpp). `ball_origin` is the origin of the ball's mesh, in mm from the
  /// joint's centre. Throws std::invalid_argument without a rim or a neck.
  CentredLimits(const Joint& joint, BallSocketPair about, const Vec3& from_centre, const Vec3& ball_origin,
                const JointPlaces& places);

  BallSocketPair meshes;  // mm
  Vec3 centre;            // mm from the joint's
  TurnLimits limits;
};

/// The bytes of a file of landmarks (landmark_file.hpp) and its name.
struct LandmarkBytes {
  std::string name;
  std::string bytes;
};

/// One joint with everything that was worked out about it.
struct Session {
  Session() = default;  // no joint yet
  /// A joint without tables.
  Session(Joint put_together, std::optional<Side> side, const std::string& axis_code)
      : joint(std::make_unique<SessionJoint>(std::move(put_together), side, axis_code)) {}

  std::unique_ptr<SessionJoint> joint;  // empty after Session()
  SessionTables tables;                 // filled by fill_tables() and use_*()
  /// Made when first needed: about the centre of the ball, and about the socket's centre where it has one.
  std::unique_ptr<CentredLimits> limits;
  std::unique_ptr<CentredLimits> socket_limits;
  bool limits_of_rim = false;         // are they for the rim alone?
  std::optional<JointPlaces> places;  // made when first needed; joint frame, about the joint's centre
};

/// Replaces the joint by a hip made from parameters; its tables have the present settings.
void use_hip(Session& session, const HipParameters& parameters);
/// Replaces the joint by one with a user's meshes; its tables have the present settings.
void use_meshes(Session& session, JointInput input, const std::optional<LandmarkBytes>& landmarks = {});

/// Fills the tables of both surfaces.
void fill_tables(Session& session, const TableSettings& settings);

/// Shifts the ball, together with the tables and limits; see SessionJoint::shift_to().
void shift_ball(Session& session, const Vec3& shift);

/// Sets tables.error_mm: the largest error of both tables at the vertices and edge middles of their own
/// meshes, where the exact radius has its kinks. Faster when called again for the same joint.
void measure_tables(Session& session);

/// Proves bounds for both tables, unless they have them. May take some seconds.
void bound_tables(Session& session);

/// The larger of both tables' bounds over all directions, mm. Call bound_tables() first.
double whole_bound(const SessionTables& tables);

}  // namespace impinge
