// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/centre_interval.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/surface_vertices.hpp"
#include "mesh/triangle_distance.hpp"
#include "motion/centre_walls.hpp"

namespace impinge {
namespace {

constexpr double kCertainMargin = 1e-9;    // of the radius: of lengths in the upper end
constexpr double kFirstStep = 0.1;         // degrees past a limit, where the upper end is looked for; doubled
constexpr int kHalvings = 5;               // of the last step
constexpr std::size_t kMostVertices = 40;  // that are tried in a pose, deepest first

Pose pose_of(const JointTurn& turn, double angle_deg) {
  const Eigen::AngleAxisd about(angle_deg * kDegree, turn.axis);
  return {turn.outer * about.toRotationMatrix() * turn.inner, Vec3::Zero()};
}

// The least of a sinusoid in a span of angles.
double least_in(const Sinusoid& f, const AngleSpan& span) {
  const auto at = [&](double t) { return f.cosine * std::cos(t) + f.sine * std::sin(t) + f.constant; };
  double lowest = std::atan2(-f.sine, -f.cosine);
  if (lowest < span.from) lowest += 2.0 * kPi;
  if (lowest >= span.from && lowest <= span.to) return f.constant - std::hypot(f.cosine, f.sine);
  return std::min(at(span.from), at(span.to));
}

// The smallest angle between a direction and the arc over an edge.
double angle_to_arc(const Vec3& u, const Vec3& a, const Vec3& b) {
  const Vec3 across = a.cross(b);
  const double ends = std::min(angle_between(u, a), angle_between(u, b));
  const bool beside = a.cross(u).dot(across) > 0.0 && u.cross(b).dot(across) > 0.0;
  return beside ? std::min(ends, std::asin(std::min(1.0, std::abs(across.dot(u)) / across.norm()))) : ends;
}

// Does no jump edge come that near the direction of x?
bool clear_of_jumps(const TriangleMesh& mesh, const std::vector<JumpEdge>& jumps, const Vec3& x,
                    double angle) {
  const Vec3 u = x.stableNormalized();
  return std::ranges::all_of(jumps, [&](const JumpEdge& jump) {
    return angle_to_arc(u, mesh.vertices[jump.from], mesh.vertices[jump.to]) > angle;
  });
}

// The shift of the ball over r, as a bound for spans of the angle of a turn.
Sinusoid trace_of(const JointTurn& turn) {
  const Eigen::Matrix3d upright = rotation_to_z(turn.axis);
  const Eigen::Matrix3d m = upright * turn.inner * turn.outer * upright.transpose();
  return {m(0, 0) + m(1, 1), m(0, 1) - m(1, 0), m(2, 2)};
}

std::vector<TurnFace> faces_of(const TriangleMesh& mesh) {
  std::vector<TurnFace> faces;
  faces.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces)
    faces.push_back(turn_face(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)));
  return faces;
}

std::vector<TurnFace> points_of(const TriangleMesh& mesh, const std::vector<VertexIndex>& chosen) {
  std::vector<TurnFace> points;
  points.reserve(chosen.size());
  for (const VertexIndex v : chosen)
    points.push_back(turn_face(mesh.vertices[v], mesh.vertices[v], mesh.vertices[v]));
  return points;
}

// Ends of edges, each once; or all vertices of the surface.
std::vector<VertexIndex> asked_of(const TriangleMesh& mesh, const std::vector<Edge>& edges, bool all) {
  if (all) return surface_vertices(mesh);
  std::vector<VertexIndex> ends;
  for (const Edge& edge : edges) ends.insert(ends.end(), edge.begin(), edge.end());
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

}  // namespace

CentreIntervals::CentreIntervals(const CulledJoint& joint, const CentreQuestion& question,
                                 const BodyPairs* beside)
    : joint_(joint),
      question_(question),
      beside_(beside),
      ball_(side(joint.meshes().ball, joint.meshes().socket, false)),
      socket_(side(joint.meshes().socket, joint.meshes().ball, true)) {}

CentreIntervals::Side CentreIntervals::side(const TriangleMesh& mesh, const TriangleMesh& other,
                                            bool is_socket) const {
  const double r = question_.within_mm;
  const bool all = question_.gap_mm > 0.0;
  const std::vector<Edge> edges = possible_jumps(mesh, r);
  const std::vector<VertexIndex> facing = asked_of(other, possible_jumps(other, r), all);
  WallQuestion walls{is_socket, question_.doubt == CentreDoubt::common, r, question_.gap_mm, HUGE_VAL, 0.0};
  for (const VertexIndex v : facing) {
    walls.nearest = std::min(walls.nearest, other.vertices[v].norm());
    walls.farthest = std::max(walls.farthest, other.vertices[v].norm());
  }
  Side made{SweptParts(faces_of(mesh)),
            SweptParts(facing.empty() ? std::vector<TurnFace>{} : shells(mesh, edges, walls)),
            SweptParts(points_of(mesh, asked_of(mesh, edges, all))), jump_edges(mesh), HUGE_VAL};
  for (const TurnFace& face : made.faces.parts()) {
    const auto& [a, b, c] = face.corner;
    made.nearest = std::min(made.nearest, std::sqrt(squared_distance_to_triangle(Vec3::Zero(), a, b, c)));
  }
  return made;
}

double CentreIntervals::low_deg(const JointTurn& turn, double to_deg) const {
  const double nearest = std::min(ball_.nearest, socket_.nearest);
  if (!(nearest > question_.within_mm * (1.0 + kCertainMargin))) return 0.0;
  const Sinusoid trace = trace_of(turn);
  const bool common = question_.doubt == CentreDoubt::common;
  const WithinSpan within = [&](const AngleSpan& span) {
    const double turned = common ? std::sqrt(std::max(0.0, 3.0 - least_in(trace, span))) : 1.0;
    return question_.gap_mm + question_.within_mm * turned;
  };
  const Eigen::Matrix3d upright = rotation_to_z(turn.axis);
  const Eigen::Matrix3d ball = upright * turn.inner;
  const Eigen::Matrix3d socket = upright * turn.outer.transpose();
  double first = to_deg * kDegree;
  first = first_within(ball_.points.rotated(ball), socket_.walls.rotated(socket), within, first);
  first = first_within(ball_.walls.rotated(ball), socket_.points.rotated(socket), within, first);
  first = first_within(ball_.faces.rotated(ball), socket_.faces.rotated(socket), within, first);
  if (beside_ != nullptr) first = beside_->first_within(ball, socket, within, question_.within_mm, first);
  return std::min(first / kDegree, to_deg);
}

double CentreIntervals::shift(const Pose& pose) const {
  if (question_.doubt == CentreDoubt::play) return question_.within_mm;
  return question_.within_mm * std::sqrt(std::max(0.0, 3.0 - pose.rotation.trace()));
}

// See the header. x is the vertex in the frame of the other surface.
bool CentreIntervals::is_certain(const Pose& pose, const ScannedVertex& at, double shift) const {
  const bool of_ball = at.scanned == Surface::ball;
  const Side& facing = of_ball ? socket_ : ball_;
  const BallSocketPair& meshes = joint_.meshes();
  const Vec3 x = to_other(at.scanned, pose, mesh_of(meshes, at.scanned).vertices[at.vertex]);
  const double r = question_.within_mm;
  const double length = x.norm() + (of_ball ? question_.gap_mm : -question_.gap_mm);
  if (!(x.norm() > 4.0 * r) || !(length > 4.0 * r)) return false;
  const double rounding = kCertainMargin * (x.norm() + facing.nearest);
  const double moved = shift + 2.0 * question_.gap_mm * r / std::min(length, x.norm()) + rounding;
  const double sine = of_ball ? std::max(r, moved) / facing.nearest : (r + moved) / length;
  if (!(sine < 0.5)) return false;
  const Vec3 p = length / x.norm() * x;
  return facing.faces.farther_than(moved, p) &&
         clear_of_jumps(mesh_of(meshes, other(at.scanned)), facing.jumps, p,
                        std::asin(sine) + kCertainMargin);
}

bool CentreIntervals::always(const JointTurn& turn, double angle_deg) const {
  const Pose pose = pose_of(turn, angle_deg);
  const double moved = shift(pose);
  const double certain = moved * (1.0 + kCertainMargin) + kCertainMargin;
  if (beside_ != nullptr && beside_->vertex_inside_by(pose, certain, question_.within_mm)) return true;
  const double enough = question_.gap_mm - moved;
  const auto least = joint_.least_gap(pose);
  if (!least || !(least->gap_mm < enough)) return false;
  if (is_certain(pose, least->at, moved)) return true;
  std::vector<std::pair<double, ScannedVertex>> deep;
  for (const CulledScan& scan : joint_.scans()) {
    const TriangleMesh& mesh = mesh_of(joint_.meshes(), scan.scanned());
    for (const VertexIndex v : surface_vertices(mesh)) {
      const double gap = joint_.gap(scan.scanned(), to_other(scan.scanned(), pose, mesh.vertices[v]));
      if (gap < enough) deep.emplace_back(gap, ScannedVertex{scan.scanned(), v});
    }
  }
  std::ranges::sort(deep, [](const auto& a, const auto& b) { return a.first < b.first; });
  deep.resize(std::min(deep.size(), kMostVertices));
  return std::ranges::any_of(deep, [&](const auto& at) { return is_certain(pose, at.second, moved); });
}

std::optional<double> CentreIntervals::high_deg(const JointTurn& turn, double from_deg) const {
  double before = from_deg;
  if (always(turn, before)) return before;
  for (double step = kFirstStep; before < question_.largest_deg; step *= 2.0) {
    double at = std::min(from_deg + step, question_.largest_deg);
    if (always(turn, at)) {
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (before + at);
        (always(turn, middle) ? at : before) = middle;
      }
      return at;
    }
    before = at;
  }
  return std::nullopt;
}

}  // namespace impinge
