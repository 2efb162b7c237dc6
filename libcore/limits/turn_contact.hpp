// SPDX-License-Identifier: GPL-3.0-or-later
// The first contact in a turn about an axis through the centre, in closed form: no angle is stepped over. The
// ball turns about the axis, the socket rests. They must not touch at the start.
//
// Nothing touches before the angle that is returned. Surfaces that come within about 2e-12 of the largest
// radius count as touching there, so that what is found may be a near miss; turn_limit.hpp decides that
// exactly.
//
// Instead of contact, a threshold t > 0 of the gap may be asked for: the first angle at which a vertex of
// either scan has a gap of t or less, that is S - |x| <= t for a vertex x of the ball or |y| - B <= t for a
// vertex y of the socket. Theorem 12 (turn).
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

/// What touches: a corner of one body and a face of the other, two edges, or, for a threshold, a vertex
/// and a rim as the centre sees them.
enum class ContactKind { ball_vertex, socket_vertex, edges, rims };
template <>
inline constexpr std::array<std::string_view, 4> words_of<ContactKind>{"ball vertex", "socket vertex",
                                                                       "edges", "rims"};
constexpr std::string_view name(ContactKind kind) { return word_of(kind); }

struct TurnContact {
  double angle = 0.0;                     // radians; nothing touches before
  ContactKind kind = ContactKind::edges;  // what touches
  Vec3 place = Vec3::Zero();              // mm, see TurnScene
  Vec3 normal = Vec3::UnitX();            // unit normal of the contact; its sign has no meaning
  std::array<std::size_t, 2> body{};      // indices of the ball's and the socket's body (body_pairs.hpp)
};

/// A surface, prepared for turns about any axis.
struct TurnBody {
  TurnBody() = default;
  explicit TurnBody(const TriangleMesh& mesh);  // in its centre frame, mm, without faces that have no area

  SweptParts faces;                               // of the mesh, in its order
  std::vector<std::array<bool, 3>> first_corner;  // of each face: is it the first face of this corner?
  std::vector<std::array<bool, 3>> first_side;    // is it the first face of the side from corner k to k + 1?
};

/// A point x of the ball goes to outer R(axis, angle) inner x (hip/motion.hpp); both surfaces are about one
/// centre. Places and normals of a contact are in the frame of the axis, before `outer` takes them to the
/// socket's frame.
struct TurnScene {
  const TurnBody& ball;    // borrowed
  const TurnBody& socket;  // borrowed
  const JointTurn& turn;   // borrowed
};

/// The first contact of the surfaces in these angles (radians, 0 <= from <= to <= 2 pi), if there is one.
std::optional<TurnContact> first_contact(const TurnScene& scene, const AngleSpan& angles);

/// What a threshold of the gap needs besides the faces, for any axis: the vertices of both surfaces moved
/// along their rays, and the walls beyond and within their jump edges (contact/turn_surface.hpp).
struct TurnGap {
  /// Both meshes about one centre, mm, without edge-on faces. gap_mm is 0 or more.
  TurnGap(const BallSocketPair& meshes, double gap_mm);

  double gap_mm;
  SweptParts ball_points;
  SweptParts socket_points;
  SweptParts ball_walls;
  SweptParts socket_walls;
};

/// The first of these angles at which a vertex of either surface has that gap or less. At angles.from no
/// vertex may have it. Takes the faces of both meshes.
std::optional<TurnContact> first_gap(const SweptParts& ball, const SweptParts& socket, const JointTurn& turn,
                                     const TurnGap& gap, const AngleSpan& angles);

}  // namespace impinge
