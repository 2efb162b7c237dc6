// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Does a vertex impinge, in one pose of a motion after another? What is proven in a pose has some margin,
/// and is looked at again only when the motion has used it up. Answers are those of CulledJoint, in every
/// pose, however far apart.
///
/// A cap of vertices that is clear by S mm, by a limit that holds for directions A radians beyond those of
/// its vertices, stays clear while each direction has turned by no more than A and each length changed by
/// less than S. From one pose to the next, R by the angle q and o (contact/gap_bounds.hpp) by d mm, the
/// vertices R (v + o) change
///   their lengths by no more than          d
///   their directions by no more than       q + d / (r - T)
/// r being the least |v| and T the longest |o| in between, on a straight way. A clock adds up both,
///   L (q + d / (r - T)) + d
/// so that a proof is due L A or S later, whichever is less. Where T reaches r the motion has no bound and
/// all is looked at anew. The vertex that impinged last is asked first.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/culled_joint.hpp"
#include "contact/gap_bounds.hpp"

namespace impinge {

class CoherentContact {
 public:
  /// The joint must outlive this.
  explicit CoherentContact(const CulledJoint& joint);
  explicit CoherentContact(const CulledJoint&&) = delete;

  /// As CulledJoint::impinged(); which vertex is found may differ.
  std::optional<ScannedVertex> impinged(const Pose& pose);

  /// By how many mm the clock above may go on before anything has to be looked at again. 0 where the last
  /// pose was impinged.
  double certified_step() const;

  static constexpr double kLever = 8.0;  // L, mm a radian: what the clock counts for a turn

 private:
  /// That the nodes of a block which are not `open` are clear, or else that the vertices of the leaf are.
  struct Proof {
    double due;
    std::uint32_t block;
    std::uint32_t open;  // a bit a lane; those have proofs of their own
    bool leaf;
    std::uint32_t lane;
  };
  struct Scan {
    const CulledScan* culled;
    double least_radius;  // r
    Vec3 own;             // o of the last pose
    double clock = 0.0;
    double due = 0.0;  // of the proof that is due first
    std::vector<Proof> proofs;
  };

  static void advance(Scan& scan, const Pose& pose, double turn);
  static void begin(Scan& scan);
  /// Both return the vertex that impinges, if they come across one.
  std::optional<std::uint32_t> look_at_due(Scan& scan, const CapMove& move) const;
  std::optional<std::uint32_t> prove_vertices(Scan& scan, const CapMove& move, Proof& proof) const;
  static void prove_nodes(Scan& scan, const CapMove& move, Proof& proof);

  const CulledJoint& joint_;
  std::array<Scan, 2> scans_;
  std::optional<Pose> last_;                // whose proofs are kept; none after an impinged one
  std::size_t most_proofs_ = 0;             // with more it begins anew, with wide caps
  std::optional<ScannedVertex> impinging_;  // in the last pose
};

}  // namespace impinge
