// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to fill the table of a surface, behind one interface.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "methods/embree_fill.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "table/layer.hpp"

namespace impinge::lab {

// A surface and the directions in which it is asked for.
struct FilledSurface {
  const TriangleMesh& mesh;                         // centre frame; outlives the methods
  Layer layer;                                      // that counts where there are several
  CubeGnomonic scheme;                              // whose entries are filled
  std::shared_ptr<const RayDirections> directions;  // of the entries
};

// One way to fill the table of one surface.
class TableFilling {
 public:
  TableFilling() = default;
  TableFilling(const TableFilling&) = delete;
  TableFilling& operator=(const TableFilling&) = delete;
  virtual ~TableFilling() = default;

  virtual void fill() = 0;                             // everything from the mesh to the table; what is timed
  virtual void forget() = 0;                           // gives the memory of the table back
  virtual double radius(std::size_t entry) const = 0;  // of the table that was filled, mm
  virtual double tolerance() const = 0;                // mm, of a radius; infinite: is it there?
};

// How a way comes to be, and what the results call it.
struct FillingMaker {
  std::string name;       // in the results
  std::string storage;    // double, float or uint16
  int threads = 1;        // that fill one table
  double most_off = 0.0;  // share of the entries that may be off: rays in float slip past edges
  // The surface outlives it.
  std::unique_ptr<TableFilling> (*make)(const FilledSurface& surface, int threads) = nullptr;
};

std::vector<FillingMaker> filling_methods();  // all of them

}  // namespace impinge::lab
