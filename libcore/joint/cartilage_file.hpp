// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a map of cartilage thickness.
#pragma once

#include <array>
#include <filesystem>

#include "hip/cartilage_map.hpp"

namespace impinge {

/// Reads a CSV with the header x,y,z,thickness_mm and one point a line: a place in the frame of the meshes
/// (mm), such as a vertex of the socket, and the thickness of both layers together there (mm, 0 or more).
/// Only its direction from `centre` is used. FileError names the line that cannot be read, or whose point is
/// at the centre.
CartilageMap read_cartilage(const std::filesystem::path& file, const Vec3& centre);

/// Adds a point to a map; x, y, z and the thickness as in the file. std::invalid_argument says what is wrong
/// with it, as "has a negative thickness".
void add_cartilage(const std::array<double, 4>& point, const Vec3& centre, CartilageMap& map);

}  // namespace impinge
