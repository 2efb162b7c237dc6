// SPDX-License-Identifier: GPL-3.0-or-later
// What of the ball, or of the socket, has to be removed so that required motions are reached with a clearance
// c? The least radial cut, and of the ball also the least cut of all. Sizes lie between proven ends:
// Theorem 17 (resection). Bone of two shells that overlap counts twice.
//
// Radial cut of the ball. Along u it keeps bone up to the radius E(u) - c, E the least radius of the socket
// that u meets on the required paths (change/swept_radius.hpp). No larger star-shaped part keeps the
// clearance. There is no undercut: behind a rim the neck is narrowed all the way out. The volume, of the
// least cut too, needs a ball that is closed, or at least whose faces along each ray of the cut go on, and
// come into bone once more than they leave it, as those of a star-shaped one do. Else it is not known.
//
// Radial cut of the socket. Along v it keeps bone from the radius F(v) + c on, F the largest radius of the
// ball there. The volume needs a closed mesh with the centre outside of its bone, which says how thick the
// bone is. If one of several shells is inside out, so that along some ray more faces leave bone than came
// into it, the volume is not known.
//
// Least cut of all. It takes what the socket's bone, thickened by c, sweeps through (change/swept_bone.hpp).
// It begins where the radial cut does and ends where the rim has passed: bone beyond stays over an undercut,
// and may be held by nothing. It is given as cells: parts of the ball's faces, with the radii that go.
//
// Faces are divided into leaves (mesh/split_faces.hpp) until enough is known. The mesh after a radial cut
// keeps the clearance and has lost a little more than the least. In a socket's, the back of a wall may be
// moved beyond the old bone, by the width of a leaf, where the cut comes out there; and leaves along whose
// rays all bone goes are taken out, so that the mesh is open there.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "change/swept_bone.hpp"
#include "change/swept_radius.hpp"
#include "sphere/infinity.hpp"

namespace impinge {

/// How large the clearance is, and how close the ends have to be.
struct CutQuestion {
  double clearance_mm = 0.5;            // c, above 0
  double closeness = 0.02;              // the ends of the volume may be this share of it apart,
  double least_mm3 = 0.5;               // or this, mm^3
  double depth_mm = kInfinity;          // and the ends of the depth this, mm
  std::size_t most_new_faces = 50'000;  // after so many new faces the ends stay as they are
};

/// How much has to go, between proven ends.
struct CutSize {
  Ends volume_mm3;  // of the bone that has to go; 0 to infinity where it is not known
  Ends area_mm2;    // of the part of the surface that has to go
  Ends depth_mm;  // the most that goes along one ray, to where a socket is clear of the ball or its bone ends
};

/// The least radial cut, and a mesh that makes it.
struct Resection : CutSize {
  Surface of = Surface::ball;  // which surface is cut
  TriangleMesh before;         // the surface, divided into leaves, its old vertices first
  TriangleMesh cut;            // the surface after the cut
  std::vector<double> depth;   // how far each vertex has moved along its ray, mm
  double cut_mm3 = 0.0;        // volume of `before` less that of `cut`; NaN where it is not known
  std::size_t deepest = 0;     // index of the vertex with the largest depth

  bool empty() const { return depth_mm.high <= 0.0; }  // nothing has to go
};

/// The least radial cut of the surface that `swept` is for, about the centre, mm: the ball in the frame of
/// the legs, the socket in the joint frame. Ends are rounded outwards. Throws std::runtime_error, one line,
/// if nothing of the ball would be left along some ray, or a face of the socket is too wide to be moved out.
Resection least_radial_cut(const TriangleMesh& surface, const SweptRadius& swept,
                           const CutQuestion& question);

/// The least cut of all, as the bone that may have to go: all other bone of the ball keeps the clearance.
struct LeastCut : CutSize {
  struct Cell {
    std::array<Vec3, 3> corners;  // of a leaf of the ball's surface, frame of the legs, mm
    RaySpans goes;                // radii that may go along its rays, mm, up to its farthest corner
  };
  std::vector<Cell> cells;
};

/// The least cut of the ball, with frames as above and the clearance of `swept`, not the question's.
LeastCut least_cut(const TriangleMesh& ball, const SweptBone& swept, const CutQuestion& question);

}  // namespace impinge
