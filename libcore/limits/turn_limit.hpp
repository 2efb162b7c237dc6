// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How far can the ball turn before it touches the socket, or before a gap falls to a threshold? A bracket
/// [low, high], degrees, that no step can jump over. Theorem 12 (turn).
///
///   low    from the start to here there is no contact (limits/turn_contact.hpp)
///   high   here there is contact, decided exactly for the vertices as the pose rounds them; for a threshold,
///          contact or a vertex with that gap or less, in double
///
/// Contact means contact of bones: the ball's whole bone and its parts against the socket's
/// (limits/body_pairs.hpp). A threshold is about the vertices of both main surfaces without faces that are
/// edge-on at rest (mesh/surface_vertices.hpp), as the thesis' scans are: between vertices a gap may be
/// smaller by about the sagitta of a face. The limit of a threshold is no larger than the limit of contact.
///
/// The bracket is about 1e-7 degrees wide. It is wider where bones graze: they come so near that doubles
/// cannot tell whether they touch, and the exact test finds no contact. Then low stays at the first graze,
/// and the search goes on behind it with the same closed forms and with poses at most 0.05 degrees apart. A
/// contact that it finds there is certain, but an earlier one may lie between two poses. If it finds none the
/// limit is unknown beyond low.
///
/// The bracket is for the meshes about their origin. To first order the limit moves
///   by n . d / |n . (w x p)|               if the ball is shifted by d, or a surface by n . d
///   by t . (I - R)^T n / |n . (w x p)|     if the common centre is off by t
/// with n the normal and p the place of the contact, w the axis and R the rotation of the pose, all in the
/// socket's frame. A limit jumps where a graze becomes a contact; centre_interval() holds for every centre.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "contact/culled_overlay.hpp"
#include "files/fields.hpp"
#include "hip/motion.hpp"
#include "limits/body_pairs.hpp"
#include "limits/centre_interval.hpp"
#include "limits/mesh_end.hpp"
#include "limits/turn_contact.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/mesh_parts.hpp"

namespace impinge {

/// How a search for a limit ended.
enum class LimitState {
  limited,  // low and high as above
  free,     // no contact up to the largest angle asked for: low and high are that angle
  blocked,  // contact, or a gap at or below the threshold, at the start: low and high are 0
  unknown,  // no contact up to low; from there to high, the largest angle asked for, nothing is known
};
template <>
inline constexpr std::array<std::string_view, 4> words_of<LimitState>{"limited", "free", "blocked",
                                                                      "unknown"};
constexpr std::string_view name(LimitState state) { return word_of(state); }

/// The bracket of a limit, and where bodies touch there.
struct TurnLimit {
  LimitState state = LimitState::unknown;  // what the bracket means
  double low_deg = 0.0;                    // degrees from the start, see above
  double high_deg = 0.0;
  std::optional<TurnContact> contact;  // where limited: the last contact found up to high, socket's frame
  /// Where limited: how far the limit moves, to first order, for the worst d, or t, of 1 mm; infinite where
  /// the contact is tangential. The second is at most 2 sin(theta / 2) times the first, theta the angle of R.
  double deg_per_mm = 0.0;
  double centre_deg_per_mm = 0.0;
  /// If the ball's mesh has an opening: the first angle at which the ray through a vertex of the socket,
  /// which met the ball at the start, meets it no more; nothing where there is none. Beyond it
  /// the limit is about what is left of the mesh. If no contact is found, the state is `unknown` and low is
  /// no larger than this.
  std::optional<double> leaves_mesh_deg;
};

/// Surfaces that were cut out of the bones of a joint, to be asked about alone (body_pairs.hpp), mm.
struct CutSurfaces {
  BallSocketPair met;   // contact is asked of these
  BallSocketPair main;  // gaps are asked of these: the part of `met` that is of the main surfaces
  TriangleMesh uncut;   // the ball's main surface, whose mesh may end; without faces if its bone goes on
};

/// A joint whose turns are asked about. Meshes in one frame whose origin is the centre of both, mm: a caller
/// shifts the ball beforehand where it has another centre.
class TurnLimits {
 public:
  /// Prepares the meshes once for all turns.
  explicit TurnLimits(BallSocketPair joint, const BoneParts& beside = {});
  static TurnLimits of_surfaces(CutSurfaces surfaces);

  /// The bracket of the first contact. largest_deg in (0, 360], else std::invalid_argument.
  TurnLimit first_contact(const JointTurn& turn, double largest_deg) const;
  /// The bracket of the first angle at which some vertex has a gap of gap_mm or less, or bones touch; throws
  /// likewise.
  TurnLimit gap_of(const JointTurn& turn, double gap_mm, double largest_deg) const;

  /// Where the limit, as one of the two above returned it, may be for another centre (centre_interval.hpp).
  CentreInterval centre_interval(const JointTurn& turn, const TurnLimit& limit, double largest_deg,
                                 const CentreQuestion& question) const;

  /// The surfaces whose gaps are asked for.
  const BallSocketPair& meshes() const { return answers_->meshes; }

  /// The smallest gap of a vertex of the main surfaces at that angle; none if no vertex's ray meets the other
  /// surface.
  std::optional<LeastGap> smallest_gap(const JointTurn& turn, double angle_deg) const;

  /// Is there contact in the pose at that angle? Exact.
  BodyPairs::Verdict verdict(const JointTurn& turn, double angle_deg) const;

 private:
  template <class Next, class Reached>
  TurnLimit bracket(const JointTurn& turn, double largest_deg, const Next& next,
                    const Reached& reached) const;
  void make_limited(const JointTurn& turn, double angle, const TurnContact& contact, TurnLimit& limit) const;
  MeshEnd mesh_end(const JointTurn& turn) const;
  void end_of_mesh(const JointTurn& turn, double largest, const std::optional<double>& certain,
                   TurnLimit& limit) const;

  struct Answers {
    Answers(BallSocketPair joint, const BoneParts& beside);
    explicit Answers(CutSurfaces surfaces);
    const CulledJoint& vertices();  // made when first asked for
    const NearFaces& ball_faces() { return whole ? *whole : vertices().faces(Surface::ball); }
    BodyPairs bodies;               // made before the meshes are taken
    BallSocketPair meshes;          // the main surfaces, without their edge-on faces
    std::vector<Edge> ends;         // where the ball may end, if its bone is not closed (mesh_end.hpp)
    std::vector<VertexIndex> seen;  // vertices of the socket that have a face
    std::array<SweptParts, 2> own;  // faces of the main surfaces, where no body has just these
    const SweptParts& ball;         // faces of the main surfaces
    const SweptParts& socket;
    TriangleMesh uncut;              // of cut surfaces: the ball's main surface, if its mesh ends
    std::optional<NearFaces> whole;  // the faces of `uncut`
    std::mutex making;               // guards the following, which are made when they are first asked for
    std::optional<CulledJoint> culled;
    std::map<double, TurnGap> gaps;
    std::map<std::array<double, 3>, CentreIntervals> intervals;  // by doubt, distance and gap
  };

  explicit TurnLimits(std::unique_ptr<Answers> answers) : answers_(std::move(answers)) {}
  const TurnGap& gap(double gap_mm) const;
  const CentreIntervals& intervals(const CentreQuestion& question) const;

  std::unique_ptr<Answers> answers_;
};

}  // namespace impinge
