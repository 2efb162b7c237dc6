// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How far can the ball turn before it touches the socket, or before a gap falls to a threshold? A bracket
/// [low, high] that no step can jump over.
///
///   low    no angle from the start to here has a contact (limits/turn_contact.hpp has the proof, and how
///   near
///          parts may come before they count as touching)
///   high   here there is one, decided exactly for the vertices as the pose rounds them (body_pairs.hpp); for
///          a threshold, it may be that a vertex has that gap or less, in double
/// Contact is that of bones: of the ball's whole bone and its parts with those of the socket. A threshold of
/// the gap is about the vertices of both main surfaces, as the thesis' scans are: between vertices a gap may
/// be smaller by about the sagitta of a face. These are the meshes without faces that are edge-on at rest
/// (mesh/surface_vertices.hpp). The limit of a threshold is no larger than that of contact. Both may be asked
/// of surfaces alone that were cut out of the bones.
///
/// The bracket is about 1e-7 degrees wide, and wider only after a graze: parts come so near that doubles
/// cannot tell whether they touch, and the exact test finds no contact. Then low stays at the
/// first of these places. The search goes on behind it in growing steps, with the same closed forms and with
/// poses at most a twentieth of a degree apart. A contact that it finds there is certain, though perhaps not
/// the first: one may lie between two poses. If it finds none the limit is unknown: none up to low, and
/// nothing is said of what follows.
///
/// How far to trust it. The bracket is that of the meshes about their origin. To first order, with n the
/// normal of the contact, p its place, w the axis and R the rotation of the pose, all in the socket's frame,
///   the ball shifted by d, or a surface by n . d across the contact    n . d / |n . (w x p)|
///   the common centre of both surfaces off by t: d = (I - R) t         t . (I - R)^T n / |n . (w x p)|
/// move the limit by that. The largest of either for d or t of 1 mm are `deg_per_mm` and `centre_deg_per_mm`;
/// the second is at most 2 sin(theta / 2) times the first, theta the angle of R. But a limit jumps where a
/// graze becomes a contact: centre_interval() holds for every centre. Theorem 12 (turn).
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
#include "limits/turn_contact.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/mesh_parts.hpp"

namespace impinge {

/// How a search for a limit ended.
enum class LimitState {
  limited,  // low and high as above
  free,     // nowhere impinged up to the largest angle asked for: low and high are that angle
  blocked,  // contact, or a gap at or below the threshold, at the start: low and high are 0
  unknown,  // none up to low; from there to high, the largest angle asked for, nothing is certain
};
template <>
inline constexpr std::array<std::string_view, 4> words_of<LimitState>{"limited", "free", "blocked",
                                                                      "unknown"};
constexpr std::string_view name(LimitState state) { return word_of(state); }

/// The bracket of a limit, and where the surfaces touch there.
struct TurnLimit {
  LimitState state = LimitState::unknown;  // says what the bracket means
  double low_deg = 0.0;                    // from the start, see above
  double high_deg = 0.0;
  std::optional<TurnContact> contact;  // where limited, the last place up to `high` where parts touch
  double deg_per_mm = 0.0;             // where limited, see above; infinite where the contact is tangential
  double centre_deg_per_mm = 0.0;
  /// Of a ball whose mesh has an opening, the first angle at which a vertex of the socket leaves it: its ray
  /// met the ball so far and does not any more. From there on the limit is that of what is left of the mesh.
  /// Nothing where no vertex does. Where no contact is found, the state is then `unknown` and low no larger
  /// than this angle.
  std::optional<double> leaves_mesh_deg;
};

/// Surfaces that were cut out of the bones of a joint, to be asked about alone (body_pairs.hpp).
struct CutSurfaces {
  BallSocketPair met;   // of which contact is
  BallSocketPair main;  // of which gaps are: what of these is of the main surfaces
  TriangleMesh uncut;   // the ball's main surface, whose mesh may end; no faces: its bone goes on
};

/// A joint whose turns are asked for. Meshes in one frame whose origin is the centre of both, mm: shift the
/// ball beforehand where needed, as to the socket's own centre.
class TurnLimits {
 public:
  /// Takes the meshes, and sorts their parts once.
  explicit TurnLimits(BallSocketPair joint, const BoneParts& beside = {});
  static TurnLimits of_surfaces(CutSurfaces surfaces);

  /// The bracket of the first contact. largest_deg in (0, 360], else std::invalid_argument.
  TurnLimit first_contact(const JointTurn& turn, double largest_deg) const;
  /// The bracket of the turn at which some vertex has a gap of gap_mm or less, or bones touch; throws
  /// likewise.
  TurnLimit gap_of(const JointTurn& turn, double gap_mm, double largest_deg) const;

  /// Where the limit, one of the above, may be for another centre.
  CentreInterval centre_interval(const JointTurn& turn, const TurnLimit& limit, double largest_deg,
                                 const CentreQuestion& question) const;

  /// The surfaces that gaps are of.
  const BallSocketPair& meshes() const { return answers_->meshes; }

  /// Smallest gap of a vertex of the main surfaces at that angle; none where no vertex meets the other
  /// surface.
  std::optional<LeastGap> smallest_gap(const JointTurn& turn, double angle_deg) const;

  /// Is there contact in the pose at that angle? Exact.
  BodyPairs::Verdict verdict(const JointTurn& turn, double angle_deg) const;

 private:
  template <class Next, class Reached>
  TurnLimit bracket(const JointTurn& turn, double largest_deg, const Next& next,
                    const Reached& reached) const;
  void make_limited(const JointTurn& turn, double angle, const TurnContact& contact, TurnLimit& limit) const;
  void end_of_mesh(const JointTurn& turn, double largest, const std::optional<double>& certain,
                   TurnLimit& limit) const;

  struct Answers {
    Answers(BallSocketPair joint, const BoneParts& beside);
    explicit Answers(CutSurfaces surfaces);
    const CulledJoint& vertices();  // made when first asked for
    const NearFaces& ball_faces() { return whole ? *whole : vertices().faces(Surface::ball); }
    BodyPairs bodies;               // made before the meshes are taken
    BallSocketPair meshes;          // the main surfaces, without their edge-on faces
    std::vector<Edge> ends;         // of the ball's mesh, where its bone is not closed
    std::vector<VertexIndex> seen;  // of the socket: those of its faces
    TurnBody ball;                  // of the main surfaces
    TurnBody socket;
    TriangleMesh uncut;              // of cut surfaces: the ball's, if its mesh ends
    std::optional<NearFaces> whole;  // that
    std::mutex making;               // of what follows, when it is first asked for
    std::optional<CulledJoint> culled;
    std::map<double, TurnGap> gaps;
    std::map<std::array<double, 3>, CentreIntervals> intervals;  // by doubt, reach and gap
  };

  explicit TurnLimits(std::unique_ptr<Answers> answers) : answers_(std::move(answers)) {}
  const TurnGap& gap(double gap_mm) const;
  const CentreIntervals& intervals(const CentreQuestion& question) const;

  std::unique_ptr<Answers> answers_;
};

}  // namespace impinge
