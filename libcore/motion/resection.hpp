// SPDX-License-Identifier: GPL-3.0-or-later
// What of the ball has to go so that required motions are reached with a clearance c: the least radial cut,
// and the least cut of all.
//
// With E(u) the least radius of the socket that a direction u of the ball meets on its way
// (motion/swept_radius.hpp), a point of the ball at u may stay where its radius is at most E(u) - c. What is
// kept is min(B, E - c), B the ball. It leaves no undercut, and no larger part of the ball that is
// star-shaped about the centre keeps its radial gap at c or more in every required pose: a point beyond is
// nearer to the socket along its ray in some pose. Behind a rim it narrows the neck all the way out.
//
// The least cut of all is what the socket's bone, thickened by c, sweeps through (motion/swept_bone.hpp),
// where it is known how thick that bone is. It begins where the radial cut does, along the same rays, and
// ends where the rim has passed: bone beyond stays, over an undercut, and may be held by nothing. No surface
// with one radius a direction describes it. Cells do, each a face of the ball with the radii that may have to
// go there.
//
// Ends. Faces of the ball are cut in smaller ones (mesh/split_faces.hpp) where too little is known. Of each
// leaf, b the ends of its radii and K the radii that go along one ray, [E - c, B] of the radial cut, the bone
// that goes, integral of r^2 over K and [0, B], lies between that of the K which is certain in [0, b.low] and
// that of the K which is possible in [0, b.high]; and between the volume of the cone and what stays of it,
// the other way round. A leaf that looks to the centre counts below zero, as in any volume by cones, so that
// of a closed ball volumes are those of bone, star-shaped or not. The area is that of the ball's own surface
// which goes, the depth the most that goes along one ray.
//
// The cut surface. Each corner is drawn in to the least e.low - c of the leaves round it that may be cut. A
// flat face is nowhere farther from the centre than its farthest corner, so that no point of a leaf is beyond
// its own e.low - c: the mesh itself keeps the clearance. It takes a little more than the least.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "motion/swept_bone.hpp"
#include "motion/swept_radius.hpp"

namespace impinge {

/// What is asked of a cut.
struct CutQuestion {
  double clearance_mm = 0.5;            // c, above 0
  double closeness = 0.02;              // the ends of the volume are to be no farther apart, as a share of it
  double least_mm3 = 0.5;               // or no farther apart than this, mm^3
  std::size_t most_new_faces = 50'000;  // made by cutting: after that the ends stay as they are
};

/// How much has to go, between proven ends.
struct CutSize {
  Ends volume_mm3;  // of bone that has to go
  Ends area_mm2;    // of the ball's surface that has to go
  Ends depth_mm;    // the most along a ray
};

/// The least radial cut, and a mesh that makes it.
struct Resection : CutSize {
  TriangleMesh before;        // the ball, cut in leaves, its old vertices first
  TriangleMesh cut;           // the same with the bone gone
  std::vector<double> depth;  // of each vertex, along its ray, mm
  double cut_mm3 = 0.0;       // the volume that this mesh takes away
  std::size_t deepest = 0;    // vertex with the largest depth

  bool empty() const { return volume_mm3.high <= 0.0; }  // nothing has to go
};

/// ball in the frame of the legs, about the centre, mm. Numbers in double, rounded outwards.
/// std::runtime_error, one line, where nothing would be left along some ray.
Resection least_radial_cut(const TriangleMesh& ball, const SweptRadius& swept, const CutQuestion& question);

/// The least cut of all, as what may have to go: all other bone of the ball keeps the clearance.
struct LeastCut : CutSize {
  struct Cell {
    std::array<Vec3, 3> corners;  // of a part of the ball's surface, frame of the legs, mm
    RaySpans goes;                // along the rays through it, up to its farthest corner
  };
  std::vector<Cell> cells;
};

/// ball as above. The clearance is that of `swept`; the question's own is not used.
LeastCut least_cut(const TriangleMesh& ball, const SweptBone& swept, const CutQuestion& question);

}  // namespace impinge
