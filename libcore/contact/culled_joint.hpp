// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Tells whether a vertex of a joint impinges, and the smallest gap, without testing most vertices. In every
/// pose the answers are the same as from testing all of them: Theorem 8 (caps).
#pragma once

#include <array>
#include <optional>

#include "contact/culled_scan.hpp"
#include "table/near_faces.hpp"

namespace impinge {

/// The smallest gap; among equal ones the first, in the order of scans and vertices.
struct LeastGap {
  double gap_mm = 0.0;  // radial
  ScannedVertex at;     // where it is
  bool operator==(const LeastGap&) const = default;
};

class CulledJoint {
 public:
  /// Takes the meshes in their centre frames, mm; they must outlive this. O(faces + vertices), on two
  /// threads.
  explicit CulledJoint(const BallSocketPair& joint);
  explicit CulledJoint(const BallSocketPair&&) = delete;

  /// A vertex of either surface with a gap of 0 or less, by exact signs (gap/exact_side.hpp); std::nullopt if
  /// and only if there is none.
  std::optional<ScannedVertex> impinged(const Pose& pose) const;

  /// The smallest radial gap of all vertices to the other mesh; std::nullopt if no vertex meets it.
  std::optional<LeastGap> least_gap(const Pose& pose) const;

  /// Is a vertex of `scanned`, which a pose has at x (mm, frame of the other surface), impinged? Exact.
  bool exactly_impinged(Surface scanned, const Vec3& x) const;
  /// Gap of such a vertex to the faces in its direction, mm; NaN if there are none.
  double gap(Surface scanned, const Vec3& x) const;
  /// The gap is no less than this, mm, which takes a third of the time.
  double gap_bound(Surface scanned, const Vec3& x) const;
  /// The faces of a surface by direction.
  const NearFaces& faces(Surface of) const { return of == Surface::ball ? ball_ : socket_; }

  const std::array<CulledScan, 2>& scans() const { return scans_; }  // ball, socket
  const BallSocketPair& meshes() const { return joint_; }            // as given
  std::size_t bytes() const;                                         // of memory, the meshes not included

 private:
  struct Parts;
  CulledJoint(const BallSocketPair& joint, Parts&& parts);

  const BallSocketPair& joint_;
  NearFaces ball_;
  NearFaces socket_;
  std::array<CulledScan, 2> scans_;
};

}  // namespace impinge
