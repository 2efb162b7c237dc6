// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Is a joint free in all rotations near one, or blocked in all of them? Proven, for the surfaces and not
/// only their vertices. Theorem 14 (volume).
///
/// B is the ball's outermost radius along a direction, S the socket's innermost; a rotation R of the ball is
/// blocked if B(R^T u) + gap >= S(u) in some direction u of both (gap/overlay.hpp). A rotation within rho of
/// R moves no direction by more than rho. So of all rotations within rho of R
///   free     no pair of a ball face, turned by R, and a socket face has directions within rho of each other
///            along which B + gap >= S. Nodes of both trees first, then pairs of faces: with
///            1 / B = q . w and 1 / S = p . u it would take w in the cone of the ball's face, within rho of
///            the socket's, with q . w <= the most of p over the cap about w, a convex function of w less a
///            linear one, whose largest value over a polygon is at a corner of it.
///   blocked  some vertex of the ball, moved out by the gap, reaches the socket in all directions within rho
///            of its own, and socket faces cover these without a hole; or the same of a vertex of the socket
///   unknown  no pair touches, but some direction of the socket is within a hole of the ball's mesh in all
///            of them: that of a vertex, or one along the middle of a part of the hole that no face is
///            near
///   open     none of these could be shown
/// A gap above 0 adds to B. Along a face of the ball whose corners are moved out by gap / c, c the cosine of
/// its cap, 1 / (1 / r + gap / c) is concave in 1 / r, so that its radius is nowhere below B + gap.
///
/// With a common centre that is off by t, |t| <= r, a point p of the ball goes to X = R p + d with
/// d = (I - R) t and |d| <= D = 2 r sin(theta / 2), theta the angle of R, and rays start at t
/// (limits/centre_interval.hpp).
// Free. X is beyond y, X = t + s (y - t) with s >= 1, only if |X| >= |y|, which is more than r; X / s is y
// less (1 - 1 / s) t. So |p| + D >= |y|, and the angle from R p to y is at most
//   asin(D / |p|) + asin((1 - 1 / s) r / |y|),   s <= (|p| + D - r) / (|y| - r)
// of a gap g with |p| + g for |p| in s, and at least g / (|y| - r - g) for 1 - 1 / s: the end of the gap may
// be beyond y, and X before it. Faces that are edge-on about the origin are not about every t: they count
// with their caps. Blocked, a vertex of the ball. Let m be the least radius of the socket. Where the way from
// t to X is m and more from the origin it is within asin(r / m) of the direction of X. A patch that covers
// that, no farther than |X|, is crossed by it: the way begins before it and ends beyond. Blocked, a vertex of
// the socket, in the ball's frame y' = R^T (y - d): the ray from t through y' is within asin(r / |y'|) of the
// direction of y' from there on; it begins within a patch that is nowhere nearer than |y'|, and ends beyond.
// Excepted is a t in the planes of all faces at that vertex: about it the vertex counts for no surface
// (gap/overlay.hpp).
// A gap g moves the end of a way by g, along a ray that is turned by that angle: 2 g r / |x| more to D.
//
// With play the ball is shifted by any d, |d| <= D, and rays start at its centre d. The ball is seen as
// without: only the socket is shifted, by -d. A point y of it is nearer or farther by D at most, and no more
// than asin(D / |y|) from its direction. Free: |p| + D >= |y|, and the angle from R p to y is that. Blocked,
// a vertex of the socket: the ball has to cover that angle about it, no nearer than |y| + D. Blocked, a
// vertex of the ball: the way from d to d + R p is, m and more from the origin, within asin(D / m) of the
// direction of R p; a patch that covers that, no farther than |p| - D, is crossed by it. A gap turns no ray.
// Faces of the socket that are edge-on about the origin count with their caps.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

#include "contact/cap_limits.hpp"
#include "files/fields.hpp"
#include "gap/surface.hpp"
#include "limits/body_pairs.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "rotations/cap_floor.hpp"
#include "rotations/cell_part.hpp"
#include "rotations/mesh_holes.hpp"
#include "rotations/rotation_cells.hpp"
#include "rotations/seen_surface.hpp"

namespace impinge {

template <>
inline constexpr std::array<std::string_view, 4> words_of<CellState>{"free", "blocked", "unknown", "open"};
constexpr std::string_view name(CellState state) { return word_of(state); }

/// What counts as contact, and for which centres.
struct CellQuestion {
  double gap_mm = 0.0;  // a gap as small as that counts as contact; 0 or more. Along rays between the
                        // main surfaces; the distance of parts
  double centre_within_mm = 0.0;  // for every common centre within that of the meshes' origin; 0 or more
  double play_mm = 0.0;           // the most that searches ask for; not with centre_within_mm above 0
};

/// All rotations within `radius` of `rotation`, which takes directions of the ball to those of the socket.
struct RotationBall {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double radius = 0.0;  // radians
};
/// One that holds a cell, about the rotation in its middle.
RotationBall ball_about(const RotationCell& cell);

/// Where a cell may be blocked: the search of its eighths starts there. Indices of faces and vertices in the
/// surfaces of a CellTest (surface()).
struct CellHint {
  static constexpr std::uint32_t kNone = DirectionFace::kNone;
  std::uint32_t ball_face = kNone;    // these two may touch
  std::uint32_t socket_face = kNone;  // the same
  std::uint32_t vertex = kNone;       // that reached farthest into the other surface
  bool of_ball = true;                // is the vertex the ball's? Else the socket's
  std::uint8_t place = 0;             // of a shift with which the cell is free (rotations/play.hpp)
  std::uint32_t shut = 0;             // shifts with which it is blocked: the bits of places from 1 on
  bool operator==(const CellHint&) const = default;
};

struct CellVerdict {
  CellState state = CellState::open;
  CellHint hint;  // of open and blocked cells
};

/// A joint made ready for the test. Several threads may use it at the same time.
class CellTest {
 public:
  /// Meshes in one frame whose origin is the centre of both, mm: the main surfaces, and what else is bone
  /// (limits/body_pairs.hpp). std::invalid_argument for a gap or centre below 0, or a surface without a face.
  /// Of the same ball, parts and question as those of another test, what it made of the ball is shared.
  CellTest(const BallSocketPair& joint, const CellQuestion& question = {}, const BoneParts& beside = {},
           const CellTest* same_ball = nullptr);

  const CellQuestion& question() const { return question_; }
  /// Unit direction of the face of the ball that a hint names, as the ball lies at rest.
  Vec3 ball_axis(const CellHint& hint) const { return grown_ball().faces()[hint.ball_face].cap.axis; }
  const SeenSurface& surface(Surface of) const { return side(of).seen; }
  const BodyPairs& bodies() const { return bodies_; }
  /// All poses that these rotations stand for, with the doubt about the centre, or every shift within
  /// `play_mm`.
  NearPoses poses_near(const RotationBall& rotations, double play_mm = 0.0) const;

 private:
  friend class CellSearch;
  /// A surface, and of the ball what the gap makes of it.
  struct Side {
    Side(const TriangleMesh& mesh, Layer layer, const CellQuestion& question);
    SeenSurface seen;  // as it is
    std::unique_ptr<const SeenSurface>
        moved;         // its corners moved out by the gap; none where that is the same
    CapLimits limits;  // of that
    MeshHoles holes;   // of the ball
    CapFloor floor;    // of what is seen
    const SeenSurface& grown() const { return moved ? *moved : seen; }
  };
  const Side& side(Surface of) const { return *sides_[static_cast<std::size_t>(of)]; }
  const SeenSurface& grown_ball() const { return side(Surface::ball).grown(); }

  CellQuestion question_;
  std::array<std::shared_ptr<const Side>, kSurfaces.size()> sides_;  // made at the same time
  double growth_;        // mm: no corner of the grown ball was moved farther
  double least_ball_;    // mm, radius of all faces, without the gap
  double least_socket_;  // the same
  bool edge_on_;         // do edge-on faces count, of which the limits know nothing?
  BodyPairs bodies_;
};

/// Asks a test, one cell at a time; each thread has its own.
class CellSearch {
 public:
  /// The test must outlive this. For every shift of the ball within `play_mm`, that of its question at most.
  explicit CellSearch(const CellTest& test, double play_mm = 0.0) : test_(test), play_mm_(play_mm) {}
  explicit CellSearch(const CellTest&&, double = 0.0) = delete;

  /// The state of all these rotations. `hint`, as of the cell that this one is an eighth of, saves time.
  CellVerdict decide(const RotationBall& rotations, const CellHint& hint = {});
  CellVerdict decide(const RotationCell& cell, const CellHint& hint = {}) {
    return decide(ball_about(cell), hint);
  }
  /// What is known of parts of a cell whose verdict is open.
  CellPart part_of(const RotationCell& cell, const CellHint& hint);

 private:
  /// What follows from the question for these rotations.
  struct Asked {
    Eigen::Matrix3d rotation;  // R
    Eigen::Matrix3d inverse;
    double shift;    // D
    CapAngle angle;  // rho and what D turns directions by
    double turn;     // rho
  };
  /// A face of the socket as the ball's frame has it.
  struct PosedFace {
    const DirectionFace* face;
    std::array<Vec3, 3> corner;
    std::array<Vec3, 3> inward;
    Vec3 plane;
    Vec3 axis;
    RadiusRange range;
  };
  /// What a vertex would have to do to block.
  struct Reach {
    DirectionCap cap;                           // the directions that the other surface has to cover
    double radius = 0.0;                        // mm, to which, and not beyond, or from which on
    std::uint32_t face = DirectionFace::kNone;  // of the other surface, along the axis
    double angle = -1.0;  // radians: how far from the axis the plane of that face does so
  };
  static constexpr std::size_t kMostVertices = 64;  // asked of a surface and a cell

  /// A cell that is taken apart.
  struct Parted;
  /// Half-spaces in which two faces are apart.
  struct PairForms;
  Asked asked_of(const NearPoses& poses, const RotationBall& rotations) const;
  std::optional<FormOverCell> block_form(const Parted& at, Surface of, const Reach& reach);
  void find_witnesses(const Parted& at, Surface of, std::vector<Reach>& found);
  std::vector<FormOverCell> blocked_by_radii(const Parted& at, const CellHint& hint);
  std::vector<FormOverCell> blocked_by_bodies(const Parted& at, const NearPoses& poses, bool by_radii) const;
  static bool take_blocked(Parted& at, const std::vector<FormOverCell>& forms);
  bool keep_apart(Parted& at, const PosedFace& socket, const DirectionFace& ball) const;
  bool keep_bodies_apart(Parted& at, const NearPoses& poses, bool by_radii) const;
  bool take_free(Parted& at, const CellHint& hint) const;

  CellVerdict facing(const Asked& asked, const CellHint& from);  // of the main surfaces, by radii
  CellState state_of_free(const Asked& asked) const;
  CapAngle angle_of(const Asked& asked, const PosedFace& socket, const DirectionFace& ball) const;
  PosedFace posed(const Asked& asked, std::uint32_t socket_face) const;
  bool may_touch(const Asked& asked, const PosedFace& socket, const DirectionFace& ball) const;
  bool find_pair(const Asked& asked, CellHint& hint) const;
  bool find_pair_of(const Asked& asked, std::uint32_t socket_face, CellHint& hint) const;
  Reach reach_at(const Asked& asked, Surface of, std::uint32_t vertex) const;
  bool blocks(const Reach& reach, Surface of);
  bool find_reach(const Asked& asked, Surface of, CellHint& hint, double& best);
  bool may_leave(const Asked& asked) const;
  bool leaves(const Asked& asked) const;

  const CellTest& test_;
  double play_mm_;
  PatchMemory memory_;
};

}  // namespace impinge
