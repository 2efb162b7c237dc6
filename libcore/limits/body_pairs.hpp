// SPDX-License-Identifier: GPL-3.0-or-later
// Are bones in contact: in a pose, in any or all of many poses, or first in a turn? Every body of the ball's
// side is asked about with every body of the socket's.
//
// Two bodies are in contact where their surfaces have a common point, or where a point of one is inside the
// other. Theorem 11 (contact); for many poses (limits/near_poses.hpp) Theorem 14 (volume). What is inside
// depends on the mesh:
//
//   closed           A point is inside if a ray from it crosses the surface an odd number of times. (Of a
//                    closed socket round the centre the bone is outside.)
//   with openings    Whatever closes an opening is taken to lie in the box of its border. Of 16 rays, those
//                    that pass such a box are left out. The point is inside if all others cross an odd number
//                    of times, outside if none does; else it is not known. Nor is it of what passes such a
//                    box, with a vertex there or not. A turn is searched for contact with these boxes too.
//   a sheet          such as a cropped acetabulum: it does not say where its bone ends behind. A mesh is a
//                    sheet if it has an opening wider than a tenth of it. A flat opening, as where a shaft is
//                    cut, makes no sheet if no side of its box has more than a tenth of the area of the faces
//                    (our choice). A point is inside a main sheet only if all rays cross it outwards more
//                    often than inwards; in the hollow of an acetabulum none does. Of any other sheet, such
//                    as cartilage round the head, inside is not known. A single pose in which radii overlap
//                    (gap/overlay.hpp) counts as contact if the socket is a sheet, and the answer says so.
//                    Without it only edge-on faces, which radii know nothing of, can be in contact, and
//                    what comes into a ball through an opening. A turn only asks where its surface is met.
//   surfaces alone   that were cut out of their bones have no inside: they are in contact where they meet.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "contact/culled_overlay.hpp"
#include "contact/moved_faces.hpp"
#include "files/fields.hpp"
#include "gap/pose.hpp"
#include "hip/motion.hpp"
#include "limits/near_poses.hpp"
#include "limits/turn_contact.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "mesh/mesh_parts.hpp"

namespace impinge {

/// Are bones in contact, or is a point inside one? `unknown` where that depends on an opening of a mesh.
enum class Contact : std::uint8_t { no, yes, unknown };
template <>
inline constexpr std::array<std::string_view, 3> words_of<Contact>{"no", "yes", "unknown"};

/// Why bodies count as in contact: surfaces meet, a point is inside, or radii overlap (see above).
enum class ContactRule : std::uint8_t { surfaces, inside, radii };
template <>
inline constexpr std::array<std::string_view, 3> words_of<ContactRule>{"surfaces", "inside", "radii"};

/// A box round the border of an opening.
struct Opening {
  Eigen::Matrix3d axes;  // rotation to the frame of the box; the border spreads least along its first axis
  Eigen::AlignedBox3d box;
  double distance(const Vec3& x) const { return box.exteriorDistance((axes * x).eval()); }
  /// How far a triangle is beside the box along the best of the axes that may separate them, mm: no more
  /// than their distance, and below 0 only if they meet.
  double beside(const Triangle& x) const;
};

/// The bodies of a joint. Meshes in one frame, mm. Several threads may ask at the same time.
class BodyPairs {
 public:
  BodyPairs(const BallSocketPair& main, const BoneParts& beside);
  /// A joint of surfaces alone (see above), without parts.
  static BodyPairs of_surfaces(const BallSocketPair& surfaces);

  /// Indices of two bodies: 0 is the bone with the main surface, k the kth part beside it.
  struct Pair {
    std::size_t ball = 0;
    std::size_t socket = 0;
  };
  struct Verdict {
    Contact contact = Contact::no;
    ContactRule rule = ContactRule::surfaces;  // why, where the contact is yes
    Pair pair{};                               // which bodies, where it is yes or unknown
    bool closed = false;                       // has the body that holds the point no opening?
  };

  /// Do the main bones have an inside? Else they are surfaces alone, or radii decide about single poses.
  bool has_inside() const { return inside_ && !radial_; }
  /// Do radii decide about the main surfaces?
  bool has_radial() const { return radial_ != nullptr; }
  /// The main surfaces if they do; null if they do not. Made when it is first asked for, which takes a while.
  const CulledJoint* radial() const { return radial_ ? &radial_->joint() : nullptr; }
  /// The faces of a side's bone, without faces of no area and each once.
  const SweptParts& bone(Surface of) const { return (of == Surface::ball ? ball_ : socket_)[0]->faces(); }
  /// Is no body open?
  bool closed() const;
  /// Two bodies, not both main surfaces alone, of neither of which it is known what is inside: that they are
  /// in contact in all of many poses cannot be shown. None if there are no two.
  std::optional<Pair> without_inside() const;
  /// Does the ball's mesh end where its bone goes on?
  bool ball_ends() const { return !ball_is_whole_ && !ball_[0]->openings.empty(); }
  /// Are any bodies in contact? Exact, for the ball's vertices as the pose rounds them. Without `radii`,
  /// radial overlap is passed over.
  Verdict verdict(const Pose& pose, bool radii = true) const;
  /// Are any in contact, whatever radii say? For poses that a motion from a clear pose reaches.
  bool meet(const Pose& pose) const;
  struct Nearest {
    Pair pair;
    double distance_mm;  // of the surfaces, rounded down; 0 in contact
    Contact touch;       // are they in contact? Exact
  };
  /// The two bodies whose surfaces are nearest to each other (contact/part_distance.hpp), among pairs with at
  /// least one part; none where there is no part.
  std::optional<Nearest> nearest_part(const Pose& pose) const;
  /// For each pair of bodies the nodes of faces that may meet in some poses. Empty: all may.
  using Left = std::vector<NodePairs>;
  /// Which faces may meet in some of the poses? Questions about poses that are all among these are quicker
  /// with it. by_radii: as of may_meet().
  Left left(const NearPoses& poses, bool by_radii) const;
  /// Two bodies that may be in contact in one of the poses; std::nullopt proves that no two are, in any pose.
  /// by_radii: the caller decides about the main surfaces by radii; only their edge-on faces are asked about
  /// here.
  std::optional<Pair> may_meet(const NearPoses& poses, bool by_radii = false, const Left& left = {}) const;
  /// Calls take() for the pairs of faces that may meet in one of the poses (NearBodies::each_close()). True
  /// if take() was, and no body holds a point of another in the middle pose, if no such pair meets there.
  /// Then the bodies are apart on all ways from there through poses in which no such pair meets.
  bool each_close(const NearPoses& poses, bool by_radii, const TakeClose& take, const Left& left = {}) const;
  /// Makes overlap() and deepest() ready, which takes a while. `main` as given to the constructor, `by_radii`
  /// as these will be asked.
  void find_inner_balls(const BallSocketPair& main, bool by_radii = false);
  /// Is a point of one body inside another one, or within the gap of it, in all of the poses? Yes is proven;
  /// no is not. Always no before find_inner_balls().
  bool overlap(const NearPoses& poses, bool by_radii = false) const;
  /// Points that are in contact in the middle of the poses, at most `most` of each pair of bodies.
  std::vector<WithinReach> deepest(const NearPoses& poses, bool by_radii, std::size_t most) const;
  /// A vertex of one of two bodies.
  struct Vertex {
    Pair pair;
    bool of_ball;
    Vec3 x;  // mm, as its body lies at rest
  };
  /// The vertices of two bodies that are within `within` mm of a place in the socket's frame.
  std::vector<Vertex> near(const Pair& pair, const Pose& pose, const Vec3& place, double within) const;
  /// Is the vertex inside the other body, farther than depth_mm from its surface and its openings? Yes is
  /// proven. No where the other body is a sheet, or an opening is as near to the sphere about the centre on
  /// which the vertex turns.
  bool is_inside_by(const Vertex& vertex, const Pose& pose, double depth_mm) const;
  /// The first contact of any two bodies in these angles of a turn, radians, if there is one. It may be with
  /// the box of an opening: then meet() has to be asked beyond it.
  std::optional<TurnContact> first_contact(const JointTurn& turn, AngleSpan angles) const;
  /// The least first_within() (swept_parts.hpp) of all pairs of bodies, radians. `ball` and `socket` are the
  /// rotations to the frame whose +z is the axis of the turn.
  double first_within(const Eigen::Matrix3d& ball, const Eigen::Matrix3d& socket, const WithinSpan& within,
                      double largest) const;

 private:
  /// How far a point may be from where it lies, mm.
  struct Reach {
    Reach() = default;
    explicit Reach(const NearPoses& poses);
    double turn = 0.0;  // share of its distance from the centre
    double shift = 0.0;
    double at(double distance) const { return turn * distance + shift; }
  };
  struct Body {
    enum class Is : std::uint8_t { main, whole, part, surface };
    Body(const TriangleMesh& of, bool turns, Is what);
    TurnBody turn;                    // each face once, none without area
    std::optional<MovedFaces> moved;  // these faces, if the body is of the ball's side
    std::optional<FixedFaces> fixed;  // these faces, if it is of the socket's
    bool alone = false;               // a surface without an inside
    std::vector<Opening> openings;
    TurnBody lids;  // the boxes of the openings, if the body is no sheet
    bool sheet = false;
    int wound = 0;             // of a main sheet: 1, or -1 if its normals point into the bone
    Eigen::AlignedBox3d box;   // round its vertices and openings
    std::vector<Vec3> pieces;  // a vertex of each connected piece
    bool hollow = false;       // a closed socket round the centre: bone is outside of it
    bool has_inside() const { return !alone && (!sheet || wound != 0); }
    std::vector<bool> of_main;  // for each node of faces: are they all of the main surface, and none edge-on?
    InnerBalls inner;
    Contact holds(const Vec3& x) const;
    Contact encloses(const Vec3& x) const;
    template <class Place>
    Contact holds_pieces(const Body& other, const Reach& reach, const Place& place) const;
    template <class Place>
    Contact holds_of(const Body& other, const Reach& reach, const Place& place) const;
    const SweptParts& faces() const { return turn.faces; }
    std::optional<int> crossings(const Vec3& from, const Vec3& to) const;
    void find_openings(const TriangleMesh& all);
    void find_pieces(const TriangleMesh& mesh);
    void find_main(const TriangleMesh& main);
  };
  /// The main surfaces, where the socket is a sheet. A joint that leaves out faces is made only for many
  /// poses.
  class Radial {
   public:
    explicit Radial(BallSocketPair main) : meshes_(std::move(main)), overlay_(meshes_) {}
    const CulledJoint& joint() const;
    bool impinged(const Pose& pose) const;

   private:
    BallSocketPair meshes_;
    CulledOverlay overlay_;
    mutable std::mutex making_;  // no call_once: glibc cannot pass an exception on where memory has ended
    mutable std::optional<CulledJoint> joint_;
    mutable std::atomic<int> poses_ = 0;
  };
  BodyPairs() = default;
  bool is_main(const Pair& pair) const { return pair.ball + pair.socket == 0; }
  static std::unique_ptr<Body> edge_on_of(const TriangleMesh& main, bool turns);
  template <class Ask>
  bool any_edge_on(const Ask& ask) const;
  Verdict beside_radii(const Pair& pair, const Pose& pose) const;
  static Verdict verdict(const Body& ball, const Body& socket, const Pair& pair, const Pose& pose);
  Verdict verdict(const Pair& pair, const Pose& pose) const {
    return verdict(*ball_[pair.ball], *socket_[pair.socket], pair, pose);
  }
  template <class Ask>
  Verdict first_of(const Ask& ask) const;
  static bool is_open_bone(const Body& body) { return !body.openings.empty() && !body.sheet; }
  static bool may_hold(const Body& ball, const Body& socket, const NearPoses& poses);
  bool may_have_come_in(const NearPoses& poses) const;
  struct Asking;
  template <class Meet>
  std::optional<Pair> first_that(const NearPoses& poses, bool by_radii, const Left& left,
                                 const Meet& meet) const;
  template <class Visit>
  bool any_near(const NearPoses& poses, bool by_radii, const Visit& visit) const;
  template <class Visit>
  void for_each_turned(const Visit& visit) const;

  std::vector<std::unique_ptr<Body>> ball_;
  std::vector<std::unique_ptr<Body>> socket_;
  std::vector<Pair> pairs_;
  bool ball_is_whole_ = false;  // is the ball's bone more than its main surface?
  bool main_only_ = true;       // is neither of the main bones?
  /// Faces of ball and socket that radii know nothing of, as bodies without an inside; null if there are none
  /// or if bones have more than their main surfaces.
  std::array<std::unique_ptr<const Body>, 2> edge_on_;
  bool inside_ = true;  // false for surfaces alone
  std::unique_ptr<const Radial> radial_;
};

}  // namespace impinge
