// SPDX-License-Identifier: GPL-3.0-or-later
// A joint and all that says whether it touches.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "contenders/contender.hpp"
#include "contenders/fcl_distance.hpp"
#include "culling/coherent_contact.hpp"
#include "kernels/gap_kernels.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge {

// One joint and all that answers. It stays where it is made: some of its members keep references to others.
struct ContactStage {
  using CubeTable = LaneTable<CubeGnomonic, std::uint16_t>;  // the kernels' table

  explicit ContactStage(std::size_t triangles);  // of each model
  ContactStage(const ContactStage&) = delete;
  ContactStage& operator=(const ContactStage&) = delete;

  void scan_all(const Pose& pose);  // the gaps of all vertices, by the kernels
  bool any_at_most_zero() const;    // of the gaps that were scanned last

  BallSocketPair pair;             // both meshes, mm
  CulledJoint culled;              // pose by pose
  CoherentContact coherent;        // from one pose to the next
  std::unique_ptr<Contender> fcl;  // contact of faces
  FclDistance distance;            // of faces
  std::unique_ptr<Contender> vtk;  // contact of faces
  CubeTable ball_table;            // of radii
  CubeTable socket_table;          // likewise
  VertexLanes<float> ball;         // vertices
  VertexLanes<float> socket;       // likewise
  std::vector<float> ball_gaps;    // of the last scan, mm
  std::vector<float> socket_gaps;  // likewise
};

// Compares answers in some of the poses. std::runtime_error where the culled ones are not those of all
// vertices, or those of VTK not those of FCL.
void compare(ContactStage& stage, const std::vector<Pose>& poses);

}  // namespace impinge
