// SPDX-License-Identifier: GPL-3.0-or-later
// Filling the table of a surface.
#pragma once

#include <memory>

#include "methods/method.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "table/layer.hpp"

namespace impinge::lab {

/// The directions of a scheme's entries in float, in the order of the entries.
struct FloatDirections {
  explicit FloatDirections(const CubeGnomonic& scheme) {  // of its entries
    for (auto* axis : {&x, &y, &z}) axis->reserve(scheme.size());
    for (std::size_t e = 0; e < scheme.size(); ++e) {
      const Vec3 u = scheme.direction(e);
      x.push_back(static_cast<float>(u.x()));
      y.push_back(static_cast<float>(u.y()));
      z.push_back(static_cast<float>(u.z()));
    }
  }

  std::vector<float> x, y, z;  // of each direction
};

/// A surface and the entries to fill from it.
struct FilledSurface {
  const TriangleMesh& mesh;                           // centre frame; outlives the methods
  Layer layer;                                        // which one is kept where a ray meets several
  CubeGnomonic scheme;                                // whose entries are filled
  std::shared_ptr<const FloatDirections> directions;  // of the entries
};

/// The table of one surface, filled again and again.
struct TableFilling {
  std::function<void()> fill;                 // everything from the mesh to the table; what is timed
  std::function<void()> forget;               // gives the memory of the table back
  std::function<double(std::size_t)> radius;  // of an entry of the table that was filled, mm
  std::function<double()> tolerance;          // mm, of a radius
};

/// One setting, and how it comes to be.
struct FillCase : Case {
  std::string storage;    // double, float or uint16
  int threads = 1;        // that fill one table
  double most_off = 0.0;  // share of the entries that may be wrong: rays in float slip past edges
  std::function<TableFilling(const FilledSurface&, int threads)> make;
};

}  // namespace impinge::lab
