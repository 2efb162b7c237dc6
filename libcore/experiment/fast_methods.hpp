// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to find the gap at every vertex of one surface in a pose, behind one interface: kernels, the library's
// scalar scan, Embree's rays, and the least that a look-up can do.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "contenders/radius_method.hpp"
#include "kernels/certified_table.hpp"
#include "kernels/vertex_lanes.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sampling/layer.hpp"

namespace impinge {

// Points to ask, as every method wants them.
struct AskedPoints {
  explicit AskedPoints(std::vector<Vec3> asked);

  std::vector<Vec3> points;
  VertexLanes<float> floats;
  VertexLanes<double> doubles;
};

class GapMethod {
 public:
  GapMethod() = default;
  GapMethod(const GapMethod&) = delete;
  GapMethod& operator=(const GapMethod&) = delete;
  virtual ~GapMethod() = default;

  // Threads may ask at the same time, each with its own `scratch`, which is enlarged on its first use.
  struct Scratch {
    std::vector<Vec3> moved;
    std::vector<double> doubles;
    std::vector<float> floats;
    CertifiedGaps certified;
  };
  virtual void scan(const AskedPoints& asked, const Pose& pose, Scratch& scratch) = 0;

  // Answer i of the scratch, mm; NaN where there is none.
  virtual double gap(const Scratch& scratch, std::size_t i) const = 0;
  virtual std::size_t undecided(const Scratch& /*scratch*/) const { return 0; }  // answers by a slower way
  virtual double bytes() const = 0;
  virtual bool answers() const { return true; }  // does gap() mean something?
  virtual Measure measure() const { return Measure::radial; }
};

// The surface that is asked, and by whom. The mesh outlives the methods.
struct AskedSurface {
  const TriangleMesh& mesh;  // centre frame
  Layer layer;
  Scan scan;  // whose vertices ask
};

struct GapMethodMaker {
  std::string name;
  std::string setting;  // precision or quality
  std::string storage;  // double, float, uint16 or none
  bool kernel = false;  // does its time depend on the instruction set?
  std::function<std::unique_ptr<GapMethod>()> make;
  bool few = false;  // so slow that few points are asked
};

// Cells along an edge of a cube map of which 16 bits an entry take just less than 1 MiB, and than half of
// what RSID takes in double at half a degree.
inline constexpr std::size_t kMainCells = 291;

// All of them. Kernels of the cube map at the precisions of a quarter turn divided by `cube_cells`, of RSID
// at `rsid_degrees` and of USID at `usid_degrees`. A certified table takes seconds to prove for 100,000
// triangles.
struct FastSizes {
  std::vector<std::size_t> cube_cells;
  std::vector<double> rsid_degrees;
  std::vector<double> usid_degrees = {};
  bool certified = true;
};
std::vector<GapMethodMaker> fast_methods(const AskedSurface& surface, const FastSizes& sizes);

}  // namespace impinge
