// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a map of cartilage thickness.
#pragma once

#include <filesystem>

#include "hip/cartilage_map.hpp"

namespace impinge {

/// A CSV with the header x,y,z,thickness_mm and one point a line: a place in the frame of the meshes (mm),
/// such as a vertex of the socket, and the thickness of both layers together there (mm, 0 or more). Its
/// direction from `centre` counts. FileError with the line for what cannot be read, and where a point is at
/// the centre.
CartilageMap read_cartilage(const std::filesystem::path& file, const Vec3& centre);

}  // namespace impinge
