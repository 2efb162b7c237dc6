// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to fill the table of a surface, behind one interface.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "contenders/embree_fill.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sampling/layer.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"

namespace impinge {

// A surface and the directions in which it is asked for.
struct FilledSurface {
  const TriangleMesh& mesh;  // centre frame; outlives the methods
  Layer layer;
  CubeGnomonic scheme;
  std::shared_ptr<const RayDirections> directions;  // of the entries
};

class TableFilling {
 public:
  TableFilling() = default;
  TableFilling(const TableFilling&) = delete;
  TableFilling& operator=(const TableFilling&) = delete;
  virtual ~TableFilling() = default;

  virtual void fill() = 0;
  virtual void forget() = 0;                           // gives the memory of the table back
  virtual double radius(std::size_t entry) const = 0;  // of the table that was filled, mm
  virtual double tolerance() const = 0;                // mm, of a radius; infinite: is it there?
};

struct FillingMaker {
  std::string name;
  std::string storage;
  int threads = 1;
  double most_off = 0.0;  // share of the entries that may be off: rays in float slip past edges
  std::unique_ptr<TableFilling> (*make)(const FilledSurface& surface, int threads) = nullptr;
};

std::vector<FillingMaker> filling_methods();

}  // namespace impinge
