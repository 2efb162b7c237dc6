// SPDX-License-Identifier: GPL-3.0-or-later
// The first contact in a turn about an axis through the centre, in closed form: no step, so no tunnelling.
//
// The ball turns about an axis, the socket rests. Start from a pose in which their surfaces have no common
// point. Two triangles that were apart and now meet do so, at the first angle, in a convex set whose extreme
// points are a corner of one in the other or a crossing of their edges. (An edge that pierces the inside of a
// face across its plane did so before.)
// Corner and plane, edge and edge each give a sinusoid (limits/sinusoid.hpp). Only pairs
// that are at one height, distance and azimuth can meet, and those that may do so first are looked at
// first (limits/swept_parts.hpp). Where a sinusoid is near zero, the angle steps on by the distance of the
// two parts, less the tolerance, over that of the turning one from the axis: no point comes nearer by more.
// The first angle at which they are within twice the tolerance counts as touching, and so does the one that
// 10,000 steps reach.
//
// A threshold of the gap t > 0 in place of contact: some vertex of the ball has S - |x| <= t, or some of the
// socket |y| - B <= t, when x (|x| + t) / |x| meets the socket or is beyond it, or y (|y| - t) / |y| meets
// the ball or is within it. If none did, it is first beyond or within where it meets the surface, corners and
// faces again, or passes a jump edge (mesh/jump_edges.hpp) as the centre sees it: then it comes into the wall
// { k y : k >= 1 } beyond one of the socket, or { k x : 0 <= k <= 1 } within one of the ball. A vertex of the
// socket with |y| <= t has such a gap as soon as its ray meets the ball at all: it is looked for no nearer to
// the centre than half the way to the nearest point of the ball, where only walls are. What it finds is the
// first angle at which the two scans of vertices have a gap of t or less. Theorem 12 (turn).
//
// What rounding may do. With u = 2^-53 and R the largest radius: vertices are turned to the frame of the axis
// and by the angle, within 20 u R each; distances of parts that are not thin are right to 24 u D / 1e-2 with
// D <= 2 R, others are not above the true ones (contact/part_distance.hpp); a pose that is rounded has its
// vertices within 20 u R: 4920 u R = 6e-13 R together. The coefficients of a sinusoid are right to 20 u R
// times the lengths that it is a product of. So `tolerance()`, 1e-12 R, is above what rounding may hide, and
// a sinusoid is asked for at twice of it. Parts nearer than twice the tolerance count as touching: no contact
// comes before the angle that is returned, but it may be a false one where the parts pass as closely as that
// and do not meet: turn_limit.hpp verifies it. The wall beyond an edge, q the ratio of the
// least to the largest distance of the edge from the centre, has 64 u / q of its reach as further tolerance.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "files/fields.hpp"
#include "hip/motion.hpp"
#include "limits/sinusoid.hpp"
#include "limits/swept_parts.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge {

/// Which of the parts touch: a corner of one and a face of the other, two edges, or, for a threshold, a
/// vertex and a rim as the centre sees them.
enum class ContactKind { ball_vertex, socket_vertex, edges, rims };
template <>
inline constexpr std::array<std::string_view, 4> words_of<ContactKind>{"ball vertex", "socket vertex",
                                                                       "edges", "rims"};
constexpr std::string_view name(ContactKind kind) { return word_of(kind); }

struct TurnContact {
  double angle = 0.0;                     // radians; nothing touches before
  ContactKind kind = ContactKind::edges;  // what touches
  Vec3 place = Vec3::Zero();              // mm, see TurnScene
  Vec3 normal = Vec3::UnitX();            // unit vector across both parts there, either way
  std::array<std::size_t, 2> body{};      // of ball and socket (limits/body_pairs.hpp)
};

/// What of a surface is asked for in turns about any axis.
struct TurnBody {
  TurnBody() = default;
  explicit TurnBody(const TriangleMesh& mesh);  // in its centre frame, mm, without faces that have no area

  SweptParts faces;                               // of the mesh, in its order
  std::vector<std::array<bool, 3>> first_corner;  // of each face: is it the first face of this corner?
  std::vector<std::array<bool, 3>> first_side;    // the same of the side from each corner to the next
};

/// The ball x goes to inner x, turns about the axis, and outer takes it to the socket's frame
/// (hip/motion.hpp); both about one centre. Places of a contact are in
/// the frame of the axis, the socket at rest, before `outer` takes them to the socket's.
struct TurnScene {
  const TurnBody& ball;    // borrowed
  const TurnBody& socket;  // borrowed
  const JointTurn& turn;   // borrowed
};

/// The first contact of the surfaces in these angles (radians, 0 <= from <= to <= 2 pi), if there is one.
std::optional<TurnContact> first_contact(const TurnScene& scene, const AngleSpan& angles);

/// What a threshold of the gap asks for besides faces, whatever the axis: vertices moved by it, and walls.
struct TurnGap {
  /// Both meshes about one centre, mm, without edge-on faces. gap_mm: 0 or more.
  TurnGap(const BallSocketPair& meshes, double gap_mm);

  double gap_mm;
  SweptParts ball_points;
  SweptParts socket_points;
  SweptParts ball_walls;
  SweptParts socket_walls;
};

/// The first angle in these at which a vertex of either surface has that gap or less; none must have it at
/// `from`.
std::optional<TurnContact> first_gap(const TurnScene& scene, const TurnGap& gap, const AngleSpan& angles);

}  // namespace impinge
