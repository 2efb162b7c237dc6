// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/session.hpp"

#include <algorithm>
#include <cmath>

#include "files/stopwatch.hpp"
#include "hip/hip.hpp"
#include "joint/landmark_file.hpp"
#include "joint/touch.hpp"
#include "mesh/surface_vertices.hpp"
#include "table/probe_directions.hpp"
#include "table/surface_index.hpp"

namespace impinge {
namespace {

std::optional<ClockFace> dial_of(TriangleMesh socket, const Eigen::Matrix3d& axes) {
  socket.vertices = mapped(axes, socket.vertices);
  return clock_face(socket);
}

std::unique_ptr<const ScannedVertices> probes_of(const TriangleMesh& mesh, Layer layer) {
  constexpr double kReach = 1e-3;  // caps are not used
  const SurfaceIndex surface(mesh, layer, kReach);
  std::vector<Vec3> points;
  for (const Vec3& u : feature_directions(mesh)) {
    const double radius = surface.radius(u);
    if (!std::isnan(radius)) points.emplace_back(radius * u);
  }
  return std::make_unique<const ScannedVertices>(points);
}

// The gap of a point of the surface from the table of the same surface is the error of the table.
double measured_error(const ScannedVertices& probes, SurfaceTable& table) {
  std::vector<double> error(probes.points.size());
  table.scan(probes, Pose{}, Surface::ball, error);
  double largest = 0.0;
  for (const double e : error) largest = std::isnan(e) ? largest : std::max(largest, std::abs(e));
  return largest;
}

SessionTables filled(const SessionJoint& joint, const TableSettings& settings) {
  SessionTables tables;
  tables.settings = settings;
  Stopwatch watch;
  tables.ball = fill_table(settings, joint.main(Surface::ball), Layer::farthest);
  tables.socket = fill_table(settings, joint.main(Surface::socket), Layer::nearest);
  tables.fill_ms = watch.lap_ms();
  return tables;
}

// Everything is made before the session changes.
void use(Session& session, std::unique_ptr<SessionJoint> joint) {
  session.tables = filled(*joint, session.tables.settings);
  session.joint = std::move(joint);
  session.limits.reset();
  session.socket_limits.reset();
  session.places.reset();
}

}  // namespace

SessionPart::SessionPart(const TriangleMesh& mesh, const std::vector<MeshPart>& parts)
    : vertices(mesh.vertices), area(vertex_areas(mesh)), used(on_surface(mesh)) {
  if (!parts.empty())
    std::fill(used.begin() + static_cast<std::ptrdiff_t>(parts.front().first_vertex), used.end(), false);
}

SessionJoint::SessionJoint(Joint put_together, std::optional<Side> of, const std::string& axis_code)
    : joint(std::move(put_together)),
      side(of),
      axes(joint.frames ? joint.frames->pelvis : input_to_joint(axis_code)),
      dial(dial_of(joint.socket.main(), axes)),
      ball(joint.ball.mesh, joint.ball.parts),
      seen(joint.socket.mesh),
      socket(seen, joint.socket.parts) {
  joint.axes = axis_code;
}

TriangleMesh in_joint_frame(const SessionJoint& joint, TriangleMesh mesh) {
  mesh.vertices = mapped(joint.axes, mesh.vertices);
  return mesh;
}

void SessionJoint::shift_to(const Vec3& to) {
  TriangleMesh moved = relative_to(joint.socket.mesh, to);
  socket = SessionPart(moved, joint.socket.parts);
  faces_[1].reset();
  bodies_.reset();
  probes[1].reset();
  seen = std::move(moved);
  shift = to;
}

const NearFaces& SessionJoint::faces(Surface of) {
  auto& made = faces_[of == Surface::ball ? 0 : 1];
  if (!made) made = std::make_unique<const MainFaces>(main(of));
  return made->faces;
}

const BodyPairs& SessionJoint::bodies() {
  if (!bodies_)
    bodies_ = std::make_unique<const BodyPairs>(BallSocketPair{main(Surface::ball), main(Surface::socket)},
                                                beside());
  return *bodies_;
}

void shift_ball(Session& session, const Vec3& shift) {
  SessionJoint& joint = *session.joint;
  if (shift == joint.shift) return;
  SessionTables& tables = session.tables;
  auto socket = fill_table(tables.settings, relative_to(joint.joint.socket.main(), shift), Layer::nearest);
  joint.shift_to(shift);
  tables.socket = std::move(socket);
  tables.socket_bounds.reset();
  session.limits.reset();
}

void use_hip(Session& session, const HipParameters& parameters) {
  Hip hip = make_hip(parameters);
  JointInput input;
  input.ball = {"ball", std::move(hip.ball), std::move(hip.ball_parts)};
  input.socket = {"socket", std::move(hip.socket), std::move(hip.socket_parts)};
  input.centre = Vec3::Zero();
  input.side = parameters.side;
  auto joint = std::make_unique<SessionJoint>(assemble_joint(std::move(input)), parameters.side, "RAS");
  joint->parameters = parameters;
  use(session, std::move(joint));
}

void use_meshes(Session& session, JointInput input, const std::optional<LandmarkBytes>& landmarks) {
  const std::optional<Side> side = input.side;
  const std::string axes = input.axes;
  Joint assembled = assemble_joint(std::move(input));
  if (landmarks)
    use_landmarks(read_landmarks(landmarks->name, landmarks->bytes, input_to_joint(axes)), landmarks->name,
                  side, assembled);
  auto joint = std::make_unique<SessionJoint>(std::move(assembled), side, axes);
  warn_of_contact(*joint);
  use(session, std::move(joint));
}

void fill_tables(Session& session, const TableSettings& settings) {
  session.tables = filled(*session.joint, settings);
}

void measure_tables(Session& session) {
  SessionJoint& joint = *session.joint;
  auto& [ball, socket] = joint.probes;
  if (!ball) ball = probes_of(joint.main(Surface::ball), Layer::farthest);
  if (!socket) socket = probes_of(joint.main(Surface::socket), Layer::nearest);
  session.tables.error_mm =
      std::max(measured_error(*ball, *session.tables.ball), measured_error(*socket, *session.tables.socket));
}

void bound_tables(Session& session) {
  SessionTables& tables = session.tables;
  const SessionJoint& joint = *session.joint;
  if (!tables.ball_bounds)
    tables.ball_bounds = tables.ball->bounds(tables.settings, joint.main(Surface::ball), Layer::farthest);
  if (!tables.socket_bounds)
    tables.socket_bounds =
        tables.socket->bounds(tables.settings, joint.main(Surface::socket), Layer::nearest);
}

double whole_bound(const SessionTables& tables) {
  return std::max(tables.ball_bounds->everywhere(), tables.socket_bounds->everywhere());
}

}  // namespace impinge
