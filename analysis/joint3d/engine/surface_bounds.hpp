// SPDX-License-Identifier: GPL-3.0-or-later
// What is proven about the table of one surface, whatever its scheme and storage, behind one type.
#pragma once

#include <memory>

#include "surface_table.hpp"

namespace impinge {

class SurfaceBounds {
 public:
  SurfaceBounds() = default;
  SurfaceBounds(const SurfaceBounds&) = delete;
  SurfaceBounds& operator=(const SurfaceBounds&) = delete;
  virtual ~SurfaceBounds() = default;

  // On the error of an answer along x, in the frame of the table, mm: of the interpolation there
  // (table/direction_bounds.hpp) and of the storage (sphere/stored_table.hpp). The kernels' own
  // roundings, below a micrometre, come on top (kernels/gap_kernels.hpp). NaN where there is no answer,
  // infinite where nothing is proven.
  virtual double at(const Vec3& x) const = 0;

  // The same over all directions.
  virtual double everywhere() const = 0;
};

// Of the table that fill_table() makes. Takes some seconds.
std::unique_ptr<SurfaceBounds> bound_table(const TableSettings& settings, const TriangleMesh& mesh,
                                           Layer layer);

}  // namespace impinge
