// SPDX-License-Identifier: GPL-3.0-or-later
// How long it takes to know all rotations of a joint at once (rotations/volume.hpp), beside asking pose after
// pose.
//
// A grid of poses that leaves nothing farther from a pose than a cell of the volume reaches has as many as
// there are cells of its finest level: 4 * 8^level. No peer is given them all; it is timed on random
// rotations and its time for the grid is extrapolated. Even then it has looked at points, and proves nothing
// between them.
#pragma once

#include <string>
#include <vector>

#include "17_motion/limit_study.hpp"
#include "files/csv.hpp"
#include "rotations/volume.hpp"

namespace impinge::lab {

// What is asked.
struct VolumeStudyOptions {
  std::vector<double> widths;  // of the bracket, shares of all rotations, the finest last
  std::size_t poses = 0;       // random rotations that a peer is asked in
  std::size_t few_poses = 0;   // those that a slow one is
  std::size_t threads = 2;     // of the volume; peers have one
  std::uint64_t seed = 0;      // of the rotations
};

// The results of all joints.
struct VolumeTables {
  Table volumes;    // a row a joint and width
  Table methods;    // a row a joint and way to ask one pose after the other
  Table rotations;  // internal rotation by flexion, a row a joint and flexion
};

VolumeTables make_volume_tables();  // with their columns, and no row

// Adds the rows of a joint. With peers, pose after pose is asked too. std::runtime_error where the library's
// own test of a pose contradicts a cell: a time means nothing until that is resolved.
void add_volume(const StudiedJoint& joint, const VolumeStudyOptions& options, bool peers,
                VolumeTables& tables);

}  // namespace impinge::lab
