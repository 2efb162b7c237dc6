// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of bones, and which bones of a joint can be in contact: all of the ball's side with all of the
// socket's.
//
// Two bodies are in contact where their surfaces have a common point, or where a point of one is inside the
// other. If the surfaces have none, each connected piece of one is inside the other as a whole or not at all,
// which one of its vertices tells. Of a piece that comes into a small opening of the other all vertices do.
//
// Inside. A closed surface has an inside: the points from which a ray crosses it an odd number of times. (Of
// a closed socket round the centre it is the outside that is bone.) A mesh with openings has one only as far
// as no opening can change it. Whatever closes an opening is taken to lie in the box of its border. Then rays
// that pass no such box cross what they would of the closed bone. If all of 16 such rays cross it an odd
// number of times the point is inside, if none does it is outside; else, or if no ray is left, it is not
// known. From a clear pose bodies move continuously, and what is not inside another comes to be so only
// through a pose in which surfaces meet, or through such a box: a turn is searched for both.
//
// A sheet, such as a cropped acetabulum, does not say where its bone ends behind. It is a mesh with an
// opening wider than a tenth of it, unless that is flat, as where a shaft is cut, and no side of its box has
// more than a tenth of the area of the faces (our choice). A point is inside only if all rays come from
// behind it on balance, crossings outwards less those inwards: in the hollow of an acetabulum none does. Of
// main surfaces only: they are wound by what they are, outwards or to the centre. Behind any other sheet, as
// one of cartilage round the head, it is not known. And a single pose in which a socket of that kind is not
// met, but radii overlap (gap/overlay.hpp), counts as contact; the answer says so. A turn asks of a sheet
// where its surface is met, and no more.
//
// Surfaces alone, such as a rim and a neck that were cut out of their bones, have no inside: they are in
// contact where they meet, in a pose as in a turn.
//
// Many poses at once (limits/near_poses.hpp). If surfaces meet in none of them, each connected piece of one
// is inside the other in all of them or in none, which one of its points tells. And where a point of a
// surface stays in an inner ball of the other body, they are in contact in all of them. Theorem 11 (contact),
// Theorem 14 (volume).
#pragma once

#include <cstdint>
#include <memory>
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

/// Are bones in contact, or a point inside one? `unknown` where only an opening of a mesh could tell.
enum class Contact : std::uint8_t { no, yes, unknown };
template <>
inline constexpr std::array<std::string_view, 3> words_of<Contact>{"no", "yes", "unknown"};

/// By what a contact was told: surfaces meet, a point is inside, or radii overlap (see above).
enum class ContactRule : std::uint8_t { surfaces, inside, radii };
template <>
inline constexpr std::array<std::string_view, 3> words_of<ContactRule>{"surfaces", "inside", "radii"};

/// A box round the border of an opening.
struct Opening {
  Eigen::Matrix3d axes;  // to the frame of the box, along which the border spreads, least first
  Eigen::AlignedBox3d box;
  double distance(const Vec3& x) const { return box.exteriorDistance((axes * x).eval()); }
};

/// The bodies of a joint. Meshes in one frame, mm. Several threads may ask at the same time.
class BodyPairs {
 public:
  /// With another one's ball, its inner balls included, it is for many poses at once: verdict() knows no
  /// radii.
  BodyPairs(const BallSocketPair& main, const BoneParts& beside, const BodyPairs* same_ball = nullptr);
  /// Of surfaces alone (see above), none of them with parts.
  static BodyPairs of_surfaces(const BallSocketPair& surfaces);

  /// Places of two bodies: 0 is the bone with the main surface, k the kth part beside it.
  struct Pair {
    std::size_t ball = 0;
    std::size_t socket = 0;
  };
  struct Verdict {
    Contact contact = Contact::no;
    ContactRule rule = ContactRule::surfaces;  // of yes
    Pair pair{};                               // of yes and of unknown
    bool closed = false;                       // the point is inside a body without an opening
  };

  /// Do all bones with main surfaces have an inside? Else radii decide about single poses of a sheet.
  bool has_inside() const { return inside_ && !socket_[0]->sheet; }
  /// Main surfaces of which radii decide; null if they have an inside.
  const CulledJoint* radial() const { return radial_ ? &radial_->joint : nullptr; }
  /// Has none of them an opening?
  bool closed() const;
  /// Does the ball's mesh end where its bone goes on?
  bool ball_ends() const { return main_only_ && !ball_[0]->openings.empty(); }
  /// Are any in contact? Exact, for the ball's vertices as the pose rounds them.
  Verdict verdict(const Pose& pose) const;
  /// The same without the rule of radii: for what a motion from a clear pose comes to.
  bool meet(const Pose& pose) const;
  struct Nearest {
    Pair pair;
    double distance_mm;  // of the surfaces, up to rounding and never above the true one; 0 in contact
    bool touch;          // exact
  };
  /// The bodies whose surfaces are nearest to each other (contact/part_distance.hpp), of which one at least
  /// is a part; none without a part.
  std::optional<Nearest> nearest_part(const Pose& pose) const;
  /// Bodies that may be in contact in one of the poses; std::nullopt proves that none are, in any of them.
  /// by_radii: what the main surfaces do is told by radii, and not asked.
  std::optional<Pair> may_meet(const NearPoses& poses, bool by_radii = false) const;
  /// The faces that may meet in one of them, where bodies are apart in the middle; none if that is not
  /// proven, or they are more than `most`.
  std::optional<std::vector<ClosePair>> close(const NearPoses& poses, bool by_radii, std::size_t most) const;
  /// Makes overlap() ready, which takes a while. `main` as given before, `by_radii` as it will be asked.
  void find_inner_balls(const BallSocketPair& main, bool by_radii = false);
  /// Is a point of one inside another body, or within the gap of it, in all of the poses? Yes is proven. No
  /// before find_inner_balls().
  bool overlap(const NearPoses& poses, bool by_radii = false) const;
  /// Points that are in contact in the middle of the poses, `most` of each pair of bodies at most.
  std::vector<WithinReach> deepest(const NearPoses& poses, bool by_radii, std::size_t most) const;
  /// A vertex, as its body lies at rest, mm.
  struct Vertex {
    Pair pair;
    bool of_ball;
    Vec3 x;
  };
  /// The vertices of two bodies within that distance, mm, of a place in the socket's frame.
  std::vector<Vertex> near(const Pair& pair, const Pose& pose, const Vec3& place, double within) const;
  /// Is it inside the other body, farther than that from its surface, and did it come there through that,
  /// about whatever centre, if this shifts it by no more? No of a sheet, and of what an opening may let in.
  bool is_inside_by(const Vertex& vertex, const Pose& pose, double depth_mm) const;
  /// The first contact of all pairs in these angles of a turn, radians, if there is one; or with what may
  /// close a body, behind which inside is to be asked for.
  std::optional<TurnContact> first_contact(const JointTurn& turn, AngleSpan angles) const;
  /// The least first_within() (swept_parts.hpp) of all pairs, radians. `ball` and `socket` are the rotations
  /// to the frame whose +z is the axis.
  double first_within(const Eigen::Matrix3d& ball, const Eigen::Matrix3d& socket, const WithinSpan& within,
                      double largest) const;

 private:
  struct Body {
    enum class Is : std::uint8_t { main, whole, part, surface };
    Body(const TriangleMesh& of, bool turns, Is what);
    TurnBody turn;                    // each face once, none without area
    std::optional<MovedFaces> moved;  // the same, of the ball's side
    std::optional<FixedFaces> fixed;  // of the socket's
    bool alone = false;               // a surface without an inside
    std::vector<Opening> openings;
    TurnBody lids;  // these boxes, of a body that is no sheet
    bool sheet = false;
    int wound = 0;              // of a main sheet: 1, or -1 if its faces are seen from the bone's inside
    std::vector<Vec3> pieces;   // a vertex of each connected piece
    bool hollow = false;        // a closed socket round the centre: bone is outside of it
    std::vector<bool> of_main;  // of each node of faces: are all of them of the main surface, none edge-on?
    InnerBalls inner;
    Contact holds(const Vec3& x) const;
    Contact encloses(const Vec3& x) const;
    template <class Place>
    Contact holds_of(const Body& other, double reach, const Place& place) const;
    const SweptParts& faces() const { return turn.faces; }
    std::optional<int> crossings(const Vec3& from, const Vec3& to) const;
    void find_openings(const TriangleMesh& all);
    void find_pieces(const TriangleMesh& mesh);
    void find_main(const TriangleMesh& main);
  };
  /// Of main surfaces, where the socket's has no inside.
  struct Radial {
    explicit Radial(BallSocketPair main) : meshes(std::move(main)), joint(meshes), overlay(joint) {}
    BallSocketPair meshes;
    CulledJoint joint;
    CulledOverlay overlay;
  };
  BodyPairs() = default;
  bool is_main(const Pair& pair) const { return pair.ball + pair.socket == 0; }
  Verdict verdict(const Pair& pair, const Pose& pose) const;
  template <class Ask>
  Verdict first_of(const Ask& ask) const;
  static bool may_hold(const Body& ball, const Body& socket, const NearPoses& poses);
  template <class Meet>
  std::optional<Pair> first_that(const NearPoses& poses, bool by_radii, const Meet& meet) const;
  template <class Visit>
  bool any_near(const NearPoses& poses, bool by_radii, const Visit& visit) const;
  template <class Visit>
  void for_each_turned(const Visit& visit) const;

  std::vector<std::shared_ptr<Body>> ball_;
  std::vector<std::shared_ptr<Body>> socket_;
  std::vector<Pair> pairs_;
  bool main_only_ = true;  // are the bones no more than the main surfaces?
  bool inside_ = true;     // are they more than surfaces alone?
  bool same_ball_ = false;
  std::unique_ptr<const Radial> radial_;
};

}  // namespace impinge
