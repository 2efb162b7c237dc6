// SPDX-License-Identifier: GPL-3.0-or-later
// Do the surfaces of two meshes meet when one of them is moved? Any meshes: open ones, slivers, faces that
// are there twice. Faces without area meet nothing.
//
// The answer is that of faces_meet() (mesh/meeting_faces.hpp) of all pairs of faces with an area, of the
// corners that to_socket() gives (gap/pose.hpp). Balls round runs of the moved faces are left out where they
// are clear of the other surface for certain, in floats rounded outwards:
//   by the grid of distances about it (contact/near_cells.hpp), or
//   because they are nearer to the centre than it is along all rays near them (contact/least_radii.hpp),
// and of what is left each face is tested with those whose boxes overlap its own. Runs whose middle is in a
// cell of the surface come first, so that a pair that meets is soon found. Theorem 9 (near).
//
// A pose of whole hip bones of 125,000 faces takes microseconds, where trees of boxes on both take hundreds:
// next to none of the thousands of faces of the head that are a millimetre from the socket is looked at.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "contact/face_runs.hpp"
#include "contact/least_radii.hpp"
#include "contact/near_cells.hpp"
#include "gap/pose.hpp"
#include "mesh/triangle_distance.hpp"

namespace impinge {

/// A mesh that is moved, prepared once: 23 bytes a face and itself.
class MovedFaces {
 public:
  /// Eight balls, each round the points of a run.
  struct Balls {
    std::array<float, FaceRuns::kWidth> x, y, z;  // middle, mm
    std::array<float, FaceRuns::kWidth> radius;   // mm, with what floats lose; negative of none
    std::array<float, FaceRuns::kWidth> square;   // mm^2: no point is farther from the centre
  };
  explicit MovedFaces(const TriangleMesh& mesh);  // in the centre frame, mm

  const FaceRuns& runs() const& { return runs_; }
  const std::vector<Balls>& balls() const& { return balls_; }

 private:
  FaceRuns runs_;
  std::vector<Balls> balls_;  // a block each
};

/// A mesh that stays where it is, prepared once: 27 bytes a face, itself, and at most 2.2 MB.
class FixedFaces {
 public:
  /// Eight boxes, each round the points of a run.
  struct Boxes {
    std::array<std::array<float, FaceRuns::kWidth>, 3> low, high;  // mm, rounded outwards; of none empty
  };
  explicit FixedFaces(const TriangleMesh& mesh);  // in its centre frame, mm

  /// Does a triangle meet one of the faces?
  bool meet(const Triangle& triangle) const;

  const FaceRuns& runs() const& { return runs_; }
  const std::optional<NearCells>& cells() const& { return cells_; }  // none without faces
  const std::optional<LeastRadii>& radii() const& { return radii_; }

 private:
  FaceRuns runs_;
  std::vector<Boxes> boxes_;  // a block each
  std::optional<NearCells> cells_;
  std::optional<LeastRadii> radii_;
};

/// Have the two a common point in this pose? May be called from several threads at once. Coordinates are up
/// to 1e15 mm and as plane_side() wants them, and the rotation is orthogonal to 1e-7. Adds to `looked_at` the
/// moved faces that are tested one by one.
bool surfaces_meet(const MovedFaces& moved, const FixedFaces& fixed, const Pose& pose,
                   std::size_t* looked_at = nullptr);

}  // namespace impinge
