// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a map of cartilage thickness.
#pragma once

#include <array>
#include <filesystem>

#include "hip/cartilage_map.hpp"

namespace impinge {

/// Reads a CSV with the header x,y,z,thickness_mm and one point per line: a place in the frame of the meshes
/// (mm), such as a vertex of the socket, and the thickness of both layers together there (mm, 0 or more).
/// Only the direction of the place from `centre` is used. Throws FileError with the number of a line that
/// cannot be read, or whose point is at the centre.
CartilageMap read_cartilage(const std::filesystem::path& file, const Vec3& centre);

/// Adds a point to a map: x, y, z and the thickness as in the file. Throws std::invalid_argument that says
/// what is wrong with it, such as "has a negative thickness".
void add_cartilage(const std::array<double, 4>& point, const Vec3& centre, CartilageMap& map);

}  // namespace impinge
