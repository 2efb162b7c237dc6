// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels that read a table, and what their headers promise, behind one interface.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gap/simd/packed_vertices.hpp"
#include "mesh/triangle_mesh.hpp"
#include "table/layer.hpp"

namespace impinge::test {

// A kernel with the table of a mesh, and the library's scalar look-up of the numbers that are stored in it.
class TableKernel {
 public:
  virtual ~TableKernel() = default;

  virtual std::string name() const = 0;  // scheme and storage
  virtual double unit() const = 0;       // u of the kernel's arithmetic
  // Of the kernel, mm.
  virtual std::vector<double> gaps(const std::vector<Vec3>& vertices, const Pose& pose,
                                   Surface scanned) const = 0;
  // Of the scalar look-up, mm; NaN where it has no answer.
  virtual double radius_at(const Vec3& x) const = 0;
  // What a gap at x may be off from that of the scalar look-up, whose radius it is, mm.
  virtual double rounding(const Vec3& x, double radius) const = 0;
  // What a radius of the scalar look-up may be off from that of the mesh, mm: proven, before any search, and
  // storage.
  virtual double bound() const = 0;
};

// All of them, with the bounds or 0 instead: cube in float and 16 bits; the RSID grid and
// the USID helix in double, float and 16 bits. std::invalid_argument for what one of them refuses.
std::vector<std::unique_ptr<TableKernel>> table_kernels(const TriangleMesh& mesh, Layer layer,
                                                        double precision_deg, bool bounded = false);

}  // namespace impinge::test
