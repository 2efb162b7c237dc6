// SPDX-License-Identifier: GPL-3.0-or-later
// What of the ball, or of the socket, has to go so that required motions are reached with a clearance c: the
// least radial cut, and of the ball the least cut of all.
//
// With E(u) the least radius of the socket that a direction u of the ball meets on its way
// (change/swept_radius.hpp), a point of the ball at u may stay where its radius is at most E(u) - c. What is
// kept is min(B, E - c), B the ball. It leaves no undercut, and no larger part of the ball that is
// star-shaped about the centre keeps its radial gap at c or more in every required pose: a point beyond is
// nearer to the socket along its ray in some pose. Behind a rim it narrows the neck all the way out.
//
// The least cut of all is what the socket's bone, thickened by c, sweeps through (change/swept_bone.hpp),
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
// which goes, the depth the most that goes along one ray. A leaf that the centre sees edge-on has no volume,
// but an area, and is moved like any other: a wall along rays does not stay where all round it goes.
//
// The rim. With F(v) the largest radius of the ball in a direction v of the socket, a point of the socket at
// v may stay where its radius is at least K = F(v) + c. What is kept is all bone beyond, and no more of the
// socket keeps its radial gap at c. Of each leaf, b the ends of its radii, the ray gives way from b to K. In
// a closed mesh the bone that goes along a ray is the sum of (K^3 - b^3)_+ / 3 over the faces that look to
// the centre, where the ray comes into bone, less that over those that look away, where it leaves bone.
// There are as many of both, so that K may be taken no larger than the radius of the outermost layer, beyond
// which is none. Of a leaf with the solid angle w this is w max(K, b)^3 / 3 less the volume of its cone. Bone
// of two shells that overlap counts twice. An open mesh does not say how thick the bone is, nor does one of
// several shells if along some ray more faces leave bone than came into it: one of the shells is inside out.
// Where the neck passes, K is as far out as the ball is, and all of a wall goes.
//
// The cut surface. Each corner is drawn in to the least e.low - c of the leaves round it that may be cut. A
// flat face is nowhere farther from the centre than its farthest corner, so that no point of a leaf is beyond
// its own e.low - c: the mesh itself keeps the clearance. It takes a little more than the least. A corner of
// the socket is moved out to the largest K.high / cos(angle) of its leaves: of a leaf within `angle` about an
// axis a, whose corners x all have |x| >= K / cos(angle), each point has a . x >= K. Where a cut comes out at
// the back of a wall, the back may so be moved beyond the bone that there was, by as much as leaves are wide:
// clear of the ball, but cut_mm3 counts it as added. Leaves along whose rays all bone goes are taken out:
// there the cut mesh is open, a crack as wide as leaves are long. Theorem 17 (resection).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "change/swept_bone.hpp"
#include "change/swept_radius.hpp"
#include "sphere/infinity.hpp"

namespace impinge {

/// What is asked of a cut.
struct CutQuestion {
  double clearance_mm = 0.5;            // c, above 0
  double closeness = 0.02;              // the ends of the volume are to be no farther apart, as a share of it
  double least_mm3 = 0.5;               // or no farther apart than this, mm^3
  double depth_mm = kInfinity;          // nor those of the depth, which says more where a steep neck passes
  std::size_t most_new_faces = 50'000;  // made by cutting: after that the ends stay as they are
};

/// How much has to go, between proven ends.
struct CutSize {
  Ends volume_mm3;  // of bone that has to go; of an open socket nothing is known: 0 to infinity
  Ends area_mm2;    // of the surface that has to go
  Ends depth_mm;    // the most along a ray: of a socket as far as the ball is clear of it, or its bone ends
};

/// The least radial cut, and a mesh that makes it.
struct Resection : CutSize {
  Surface of = Surface::ball;  // which one is cut
  TriangleMesh before;         // the surface, cut in leaves, its old vertices first
  TriangleMesh cut;            // the same with the bone gone
  std::vector<double> depth;   // of each vertex, along its ray, mm
  double cut_mm3 = 0.0;        // the volume that this mesh takes away; NaN where it is open
  std::size_t deepest = 0;     // vertex with the largest depth

  bool empty() const { return depth_mm.high <= 0.0; }  // nothing has to go
};

/// Of the surface that `swept` is for, about the centre, mm: the ball in the frame of the legs, the socket in
/// the joint frame. Numbers in double, rounded outwards. std::runtime_error, one line, where nothing of the
/// ball would be left along some ray, or a face of the socket is too wide to be moved out.
Resection least_radial_cut(const TriangleMesh& surface, const SweptRadius& swept,
                           const CutQuestion& question);

/// The least cut of all, as what may have to go: all other bone of the ball keeps the clearance.
struct LeastCut : CutSize {
  struct Cell {
    std::array<Vec3, 3> corners;  // of a part of the ball's surface, frame of the legs, mm
    RaySpans goes;                // along the rays through it, up to its farthest corner
  };
  std::vector<Cell> cells;
};

/// Of the ball, as above. The clearance is that of `swept`; the question's own is not used.
LeastCut least_cut(const TriangleMesh& ball, const SweptBone& swept, const CutQuestion& question);

}  // namespace impinge
