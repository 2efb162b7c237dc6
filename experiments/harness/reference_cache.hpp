// SPDX-License-Identifier: GPL-3.0-or-later
// Exact distances kept on the disk between runs: they depend on nothing but the mesh and the query.
//
// A file is named by the SHA-256 of its kind, version, mesh and query. It ends in the SHA-256 of its
// contents, so that a damaged file is recognised and made again. Files are written whole or not at all;
// several programs may share a folder. The folder is no part of the results and may be removed at any time.
#pragma once

#include <filesystem>
#include <vector>

#include "reference/closest_point.hpp"
#include "reference/exact_radius.hpp"

namespace impinge::lab {

// exact_radii() from the folder, else computed and stored there. The folder is created if it is missing;
// FileError if it cannot be written. With an empty path nothing is kept.
std::vector<double> cached_exact_radii(const std::filesystem::path& folder, const TriangleMesh& mesh,
                                       const RadiusQuery& query);

// closest_distances() in the same way.
std::vector<double> cached_closest_distances(const std::filesystem::path& folder, const TriangleMesh& mesh,
                                             const DistanceQuery& query);

}  // namespace impinge::lab
