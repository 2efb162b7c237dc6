// SPDX-License-Identifier: GPL-3.0-or-later
// Exact distances kept on the disk between runs: they depend on nothing but the mesh and the query.
//
// A file is named by the SHA-256 of its kind, version, mesh and query. It ends in the SHA-256 of what it
// holds, so that one that was cut off or changed is made again. Files are written whole or not at all;
// several programs may share a folder. The folder is part of a build, never of the results: it may be removed
// at any time. Without a folder nothing is kept.
#pragma once

#include <filesystem>
#include <vector>

#include "reference/closest_point.hpp"
#include "reference/exact_radius.hpp"

namespace impinge::lab {

// exact_radii() from the folder, which is made when it is missing, or measured and put there. FileError where
// the folder cannot be written. An empty path stands for no folder.
std::vector<double> cached_exact_radii(const std::filesystem::path& folder, const TriangleMesh& mesh,
                                       const RadiusQuery& query);

// closest_distances() in the same way.
std::vector<double> cached_closest_distances(const std::filesystem::path& folder, const TriangleMesh& mesh,
                                             const DistanceQuery& query);

}  // namespace impinge::lab
