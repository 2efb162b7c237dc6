// SPDX-License-Identifier: GPL-3.0-or-later
// Decides exactly whether the surfaces of two meshes meet when one of them is moved. The meshes may be open,
// and may have slivers and faces that are there twice. Faces without area meet nothing.
//
// The answer is the same as from faces_meet() (mesh/meeting_faces.hpp) for all pairs of faces with an area,
// with the corners that to_socket() gives (gap/pose.hpp). By Theorem 9 (near) runs of moved faces are left
// out if a sphere round them is clear of the other surface by the grid of distances about it
// (contact/near_cells.hpp), or nearer to the centre than the surface along all rays near it
// (contact/least_radii.hpp), in floats rounded outwards. Each face that is left is tested with the faces
// whose boxes overlap its own. Runs whose middle is in a cell of the surface come first, so that a pair that
// meets is soon found.
//
// A pose of whole hip bones of 125,000 faces takes microseconds; with trees of boxes on both it takes
// hundreds.
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

/// A mesh that is moved, prepared once. Takes 23 bytes a face beside the mesh.
class MovedFaces {
 public:
  /// Eight spheres, each round the points of a run.
  struct Balls {
    std::array<float, FaceRuns::kWidth> x, y, z;  // middle, mm
    std::array<float, FaceRuns::kWidth> radius;   // mm, rounded up; negative if there is no run
    std::array<float, FaceRuns::kWidth> square;   // mm^2; no point is farther from the centre
  };
  explicit MovedFaces(const TriangleMesh& mesh);  // takes a mesh in its centre frame, mm

  const FaceRuns& runs() const& { return runs_; }
  const std::vector<Balls>& balls() const& { return balls_; }

 private:
  FaceRuns runs_;
  std::vector<Balls> balls_;  // one for each block
};

/// A mesh that stays where it is, prepared once. Takes 27 bytes a face and at most 2.2 MB beside the mesh.
class FixedFaces {
 public:
  /// Eight boxes, each round the points of a run.
  struct Boxes {
    std::array<std::array<float, FaceRuns::kWidth>, 3> low, high;  // mm, rounded outwards; empty if unused
  };
  explicit FixedFaces(const TriangleMesh& mesh);  // takes a mesh in its centre frame, mm

  /// Does a triangle meet one of the faces?
  bool meet(const Triangle& triangle) const;

  const FaceRuns& runs() const& { return runs_; }
  const std::optional<NearCells>& cells() const& { return cells_; }  // std::nullopt without faces
  const std::optional<LeastRadii>& radii() const& { return radii_; }

 private:
  FaceRuns runs_;
  std::vector<Boxes> boxes_;  // one for each block
  std::optional<NearCells> cells_;
  std::optional<LeastRadii> radii_;
};

/// Do the two surfaces have a common point in this pose? Exact. May be called from several threads at once.
/// Coordinates must be up to 1e15 mm and as plane_side() needs them, and the rotation orthogonal to 1e-7.
/// Adds to `looked_at` the number of moved faces that are tested one by one.
bool surfaces_meet(const MovedFaces& moved, const FixedFaces& fixed, const Pose& pose,
                   std::size_t* looked_at = nullptr);

}  // namespace impinge
