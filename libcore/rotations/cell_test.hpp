// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Is a joint free in all rotations near a given one, or blocked in all of them? Proven for the whole
/// surfaces, not only for their vertices. Theorem 14 (volume).
///
///   free     nothing touches in any of the rotations; behind openings of a ball radii leave a case that is
///            not excluded, which the theorem names
///   blocked  something touches in every one of them
///   unknown  nothing touches in any, but in all of them the ball's mesh has a hole under the socket, and its
///            whole bone was not given
///   open     none of these could be shown
///
/// Contact means contact of bones (limits/body_pairs.hpp). Radii along rays decide instead about main
/// surfaces where a gap counts as contact, or where the socket is a sheet: blocked then means B + gap >= S in
/// some direction, with B the ball's outermost radius and S the socket's innermost one (gap/overlay.hpp).
///
/// If the common centre is known only to within a distance, the answers hold for every such centre t; but a
/// vertex blocks nothing about a t that lies in the planes of all its faces.
///
/// With play the ball may be shifted in each rotation: free means free with one shift in all of the
/// rotations, blocked means blocked with every shift (rotations/play.hpp). Radii overlap as the socket's
/// centre sees them or as the ball's does; a gap is along rays from that of the ball. A vertex blocks nothing
/// about a shift that takes the ball's centre to the planes of all its faces.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "contact/cap_limits.hpp"
#include "files/fields.hpp"
#include "gap/surface.hpp"
#include "limits/body_pairs.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "rotations/cap_floor.hpp"
#include "rotations/cell_part.hpp"
#include "rotations/mesh_holes.hpp"
#include "rotations/play.hpp"
#include "rotations/rotation_cells.hpp"
#include "rotations/seen_surface.hpp"

namespace impinge {

template <>
inline constexpr std::array<std::string_view, 4> words_of<CellState>{"free", "blocked", "unknown", "open"};
constexpr std::string_view name(CellState state) { return word_of(state); }

/// What counts as contact, and for which centres.
struct CellQuestion {
  double gap_mm = 0.0;  // a gap of this or less counts as contact; 0 or more. Between main surfaces it is
                        // along rays, between parts the distance
  double centre_within_mm = 0.0;  // for every common centre as near to the meshes' origin; 0 or more
  double play_mm = 0.0;           // shifts of the ball that are allowed; 0 if centre_within_mm is above 0
  Eigen::Matrix3d rest =
      Eigen::Matrix3d::Identity();  // that the ball's mesh has from its scan (hip/motion.hpp)
};

/// All rotations within `radius` of `rotation`, which takes the ball's frame to the socket's.
struct RotationBall {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double radius = 0.0;  // radians
};
/// Rotations that hold a cell, about the rotation in its middle.
RotationBall ball_about(const RotationCell& cell);

/// Where a cell may be blocked: the search of its eighths starts there. Indices are those of the surfaces of
/// a CellTest (surface()).
struct CellHint {
  static constexpr std::uint32_t kNone = DirectionFace::kNone;
  std::uint32_t ball_face = kNone;    // may touch socket_face
  std::uint32_t socket_face = kNone;  // may touch ball_face
  std::uint32_t vertex = kNone;       // the vertex that reaches farthest into the other surface
  bool of_ball = true;                // is the vertex the ball's? Else the socket's
  /// A shift of the ball in parts of the play / kShiftSteps: with it the cell is free, or nearest to it.
  ShiftSteps shift{};
  bool operator==(const CellHint&) const = default;
};
/// The shift in a hint, mm, no longer than the play.
inline Vec3 shift_of(const CellHint& hint, double play_mm) { return shift_of(hint.shift, play_mm); }

struct CellVerdict {
  CellState state = CellState::open;
  CellHint hint;  // where open or blocked; its shift where free
};

/// A joint, prepared for the test. Several threads may use it at the same time.
class CellTest {
 public:
  /// Meshes in one frame whose origin is the centre of both, mm: the main surfaces, and the rest of the bones
  /// (limits/body_pairs.hpp). Throws std::invalid_argument if the gap or the distance of the centre is below
  /// 0, a surface has no face that the centre sees, or the play takes the ball out of the socket.
  CellTest(const BallSocketPair& joint, const CellQuestion& question = {}, const BoneParts& beside = {});

  const CellQuestion& question() const { return question_; }
  /// Unit direction of the ball's face in a hint, as the ball lies at rest.
  Vec3 ball_axis(const CellHint& hint) const { return grown_ball().faces()[hint.ball_face].cap.axis; }
  const SeenSurface& surface(Surface of) const { return side(of).seen; }
  const BodyPairs& bodies() const { return bodies_; }
  /// All poses of these rotations, for every centre that the question allows; the ball shifted, mm.
  NearPoses poses_near(const RotationBall& rotations, const Vec3& shift = Vec3::Zero()) const;

  static constexpr double kTolerance = 1e-12;  // share of 1 / r and of lengths
  static constexpr double kTurnSlack = 2e-9;   // radians

 private:
  friend class CellSearch;
  /// One of the two surfaces.
  struct Side {
    /// ends: may it be a ball's that ends where its bone goes on?
    Side(const TriangleMesh& mesh, Layer layer, const CellQuestion& question, bool ends);
    SeenSurface seen;  // as it is
    std::unique_ptr<const SeenSurface>
        moved;         // the ball with its corners moved out for the gap; none where it is the same
    CapLimits limits;  // of the grown surface
    MeshHoles holes;   // of a ball that ends
    CapFloor floor;    // of `seen`
    std::vector<SeenBorder> borders{};  // of `seen`, with play
    const SeenSurface& grown() const { return moved ? *moved : seen; }
  };
  const Side& side(Surface of) const { return *sides_[static_cast<std::size_t>(of)]; }
  const SeenSurface& grown_ball() const { return side(Surface::ball).grown(); }

  CellQuestion question_;
  std::array<std::unique_ptr<const Side>, kSurfaces.size()> sides_;  // built in parallel
  double growth_;        // mm, the farthest that a corner of the ball was moved for the gap
  double least_ball_;    // mm, least radius of the ball, without the gap
  double least_socket_;  // mm, least radius of the socket
  bool edge_on_;         // do edge-on faces count? The limits do not have them
  BodyPairs bodies_;
};

/// Asks a test about one cell after the other. Each thread has its own.
class CellSearch {
 public:
  /// The test must outlive this object.
  explicit CellSearch(const CellTest& test) : test_(test) {}
  explicit CellSearch(const CellTest&&) = delete;

  /// The state of all these rotations. A hint, such as that of the parent cell, saves time.
  CellVerdict decide(const RotationBall& rotations, const CellHint& hint = {});
  CellVerdict decide(const RotationCell& cell, const CellHint& hint = {});
  /// Finds what holds in all of a cell of a level below kFinestCells, so that it is not asked again of its
  /// eighths. These come next.
  void enter(const RotationCell& parent);
  /// What is known of parts of a cell whose verdict is open; nothing where the centre is in doubt, or with
  /// play. `free`: are free parts asked for, which take the longest?
  CellPart part_of(const RotationCell& cell, const CellHint& hint, bool free = true);

 private:
  /// The rotations, with what the doubt about the centre adds (sigma, eta, rho as in the theorem).
  struct Asked {
    Eigen::Matrix3d rotation;  // R
    Eigen::Matrix3d inverse;
    double shift;    // sigma, mm
    CapAngle angle;  // rho + asin(sigma / least radius of the ball) + asin(eta / least radius of the socket)
    double turn;     // rho, radians
    Vec3 offset;     // mm, a shift of the ball that all of them have
    double aside;    // radians, by which that may change the direction of a point of the socket
    double hole;     // rho + asin(sigma / least radius of the socket) + asin(eta / least radius of the ball)
  };
  /// A face of the socket in the ball's frame, as the ball's centre sees it.
  struct PosedFace {
    std::array<Vec3, 3> corner;
    std::array<Vec3, 3> inward;
    Vec3 plane;
    Vec3 axis;
    RadiusRange range;
    double radius, doubt;  // of its cap, radians; of its plane
  };
  /// What the other surface has to do so that a vertex blocks: cover the cap, a socket nowhere farther than
  /// the radius, a ball nowhere nearer.
  struct Reach {
    DirectionCap cap;
    double radius = 0.0;                        // mm
    std::uint32_t face = DirectionFace::kNone;  // face of the other surface along the axis
    double angle = -1.0;  // radians: how far from the axis the plane of that face does so
  };
  static constexpr std::size_t kMostVertices = 64;  // that are tried for a surface and a cell

  /// A cell that is taken apart.
  struct Parted;
  /// The half-spaces of a cell that cut least off, of those in which two faces do not overlap.
  struct LeastCut {
    std::array<FormOverCell, 16> forms;
    std::size_t count = 0;
    double cut = HUGE_VAL;  // how deep they cut, in half sides; 0 if not at all
  };
  Asked asked_of(const NearPoses& poses, const RotationBall& rotations) const;
  std::optional<FormOverCell> block_form(const Parted& at, Surface of, const Reach& reach);
  void find_witnesses(const Parted& at, Surface of, std::vector<Reach>& found);
  std::vector<FormOverCell> blocked_by_radii(const Parted& at, const CellHint& hint);
  std::vector<FormOverCell> blocked_by_bodies(const Parted& at, const NearPoses& poses) const;
  static bool take_blocked(Parted& at, const std::vector<FormOverCell>& forms);
  LeastCut least_cut(Parted& at, const PosedFace& socket, const DirectionFace& ball) const;
  bool keep_apart(Parted& at, const PosedFace& socket, const DirectionFace& ball) const;
  bool keep_bodies_apart(Parted& at, const NearPoses& poses, bool by_radii, const RotationCell& cell) const;
  bool take_free(Parted& at, const CellHint& hint);

  /// What is known of bones with an inside, in all rotations about a cell.
  struct Seen {
    Contact middle = Contact::unknown;  // are they in contact in its middle?
    bool apart = false;                 // do radii show that the main surfaces do not meet?
    std::shared_ptr<Parted> clear;      // where the bodies are apart, if looked for and found
  };
  const BodyPairs::Left& left_of(const RotationCell* cell) const;
  Seen see(const Asked& asked, const NearPoses& poses, const RotationCell* cell, CellHint& hint) const;
  bool may_be_parted() const {
    return test_.question_.centre_within_mm == 0.0 && test_.question_.play_mm == 0.0;
  }
  bool parts_of_bodies(const RotationCell& cell) const;
  bool by_radii() const { return test_.question_.gap_mm > 0.0 || !test_.bodies_.has_inside(); }
  CellVerdict decide(const RotationBall& rotations, const CellHint& hint, const RotationCell* cell);
  bool clear_of_bodies(const Asked& asked, const NearPoses& poses, const RotationCell* cell, CellHint& hint);
  CellVerdict of_bodies(const Asked& asked, const NearPoses& poses, const CellHint& from,
                        const RotationCell* cell);
  struct Playing;  // a cell and all shifts of the ball
  CellVerdict decide_with_play(const RotationBall& rotations, const CellHint& from, const RotationCell* cell);
  CellVerdict facing(const Asked& asked, const CellHint& from);  // about the main surfaces, by radii
  CellState state_of_free(const Asked& asked);
  CapAngle angle_of(const Asked& asked, const PosedFace& socket, const DirectionFace& ball) const;
  const DirectionFace& seen_face(const Asked& asked, std::uint32_t socket_face, DirectionFace& room) const;
  PosedFace posed(const Asked& asked, std::uint32_t socket_face) const;
  bool may_touch(const Asked& asked, const PosedFace& socket, const DirectionFace& ball) const;
  template <class Found>
  bool any_socket_face(const Asked& asked, const Found& found) const;
  bool find_pair(const Asked& asked, CellHint& hint) const;
  bool may_pass(const Asked& asked, const DirectionFace& socket, std::uint32_t ball_face) const;
  bool may_overlap(const Asked& asked) const;
  bool find_pair_of(const Asked& asked, std::uint32_t socket_face, CellHint& hint) const;
  Reach reach_at(const Asked& asked, Surface of, std::uint32_t vertex) const;
  bool blocks(const Reach& reach, Surface of);
  bool find_reach(const Asked& asked, Surface of, CellHint& hint, double& best);
  template <class Found>
  bool any_hole(const Asked& asked, const Found& found) const;
  bool keep_covered(Parted& at) const;
  bool may_leave(const Asked& asked) const;
  bool leaves(const Asked& asked);

  static constexpr double kTolerance = CellTest::kTolerance;
  static constexpr double kTurnSlack = CellTest::kTurnSlack;

  const CellTest& test_;
  PatchMemory memory_;
  /// Of a vertex of the ball and the face of the socket asked about last: is it below the face's plane (bit
  /// 0), or beyond its sides (1 to 3)?
  struct Below {
    std::uint64_t face = 0;
    std::uint8_t asked = 0;
    std::uint8_t is = 0;
  };
  std::vector<Below> below_;
  std::uint64_t faces_asked_ = 0;
  std::optional<RotationCell> parent_;  // whose eighths come next
  BodyPairs::Left left_;                // what may meet in it
  std::optional<RotationCell> last_;    // the last open cell whose bones were looked at
  Seen seen_;                           // what was seen there
};

}  // namespace impinge
