// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of the families of stiff and extreme cases (stress/families), for what is no method of
// experiment 11: the kernels and the culled answers.
#pragma once

#include <ostream>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"

namespace impinge::test {

using namespace lab;

inline constexpr double kStiffPrecision = 10.0;  // degrees, of the tables whose entries are aimed at

// A surface and where it is hardest to ask it.
struct StiffSurface {
  TriangleMesh mesh;             // centre frame, mm
  Layer layer = Layer::nearest;  // that counts
  std::vector<Vec3> aims = {};   // directions of any length above zero
};

// One parameter of a family. The name is also that of its test.
struct StiffFamily {
  const char* name;        // of the family, and its parameter
  StiffSurface (*make)();  // the surface
};
// One to three of each family of surfaces.
std::span<const StiffFamily> stiff_families();
// As ctest prints it.
inline std::ostream& operator<<(std::ostream& out, const StiffFamily& family) { return out << family.name; }
// As GoogleTest names a test.
inline std::string name_of(const testing::TestParamInfo<StiffFamily>& family) { return family.param.name; }

// Points that are floats, mm: along the aims, all corners and middles of edges (exactly on both, for corners
// that are floats), the axes, diagonals and seams, and at random; from 10^-9 to 10^9 mm away, most of them
// close to the surface.
std::vector<Vec3> stiff_points(const StiffSurface& surface);

}  // namespace impinge::test
