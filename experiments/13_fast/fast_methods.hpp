// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to find the gap at every vertex of one surface in a pose, behind one interface: kernels, the library's
// scalar scan, Embree, CGAL, VTK and OpenVDB, and the least that a look-up can do.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "kernels/certified_table.hpp"
#include "kernels/packed_vertices.hpp"
#include "mesh/triangle_mesh.hpp"
#include "methods/radius_method.hpp"
#include "table/layer.hpp"

namespace impinge::lab {

// Points to ask, as every method wants them.
struct AskedPoints {
  explicit AskedPoints(std::vector<Vec3> asked);  // rounds them to float as well

  std::vector<Vec3> points;        // mm, in the frame of the mesh that they are of
  PackedVertices<float> floats;    // the same points
  PackedVertices<double> doubles;  // the same points
};

// One way to find all gaps of a pose.
class GapMethod {
 public:
  GapMethod() = default;
  GapMethod(const GapMethod&) = delete;
  GapMethod& operator=(const GapMethod&) = delete;
  virtual ~GapMethod() = default;

  // Threads may ask at the same time, each with its own `scratch`, which is enlarged on its first use.
  // Memory of one thread: the points as moved, and the answers.
  struct Scratch {
    std::vector<Vec3> moved;      // mm, in the frame of the surface
    std::vector<double> doubles;  // answers of methods that work in double, mm
    std::vector<float> floats;    // answers of methods that work in float, mm
    CertifiedGaps certified;      // answers of certified methods
  };
  // The gap of every point with the ball in that pose; what is timed.
  virtual void scan(const AskedPoints& asked, const Pose& pose, Scratch& scratch) = 0;

  // Answer i of the scratch, mm; NaN where there is none.
  virtual double gap(const Scratch& scratch, std::size_t i) const = 0;
  virtual std::size_t undecided(const Scratch& /*scratch*/) const { return 0; }  // answers by a slower way
  virtual double bytes() const = 0;                            // of everything that was built to answer
  virtual bool answers() const { return true; }                // does gap() mean something?
  virtual Measure measure() const { return Measure::radial; }  // what the answers are
};

// The surface that is asked, and by whom. The mesh outlives the methods.
struct AskedSurface {
  const TriangleMesh& mesh;  // centre frame
  Layer layer;               // of it that counts
  Surface scanned;           // whose vertices ask
};

// How a method comes to be, and what the results call it.
struct GapMethodMaker {
  std::string name;                                  // in the results
  std::string setting;                               // precision or quality
  std::string storage;                               // double, float, uint16, corners or none
  bool kernel = false;                               // does its time depend on the instruction set?
  std::function<std::unique_ptr<GapMethod>()> make;  // builds the table or tree
  bool few = false;                                  // so slow that few points are asked
};

// Cells along an edge of a cube map of which 16 bits an entry take just less than 1 MiB, and than half of
// what RSID takes in double at half a degree.
inline constexpr std::size_t kMainCells = 291;

// What the results call the storage of a table of corners.
inline constexpr const char* kCorners = "corners";

// Cells along an edge of such a table that takes just less than 1 MiB; one of kMainCells takes 2.
inline constexpr std::size_t kCornersOfAMebibyte = 208;

// All of them. Kernels of the cube map at the precisions of a quarter turn divided by `cube_cells`, and by
// `corner_cells` of tables of corners, of RSID at `rsid_degrees` and of USID at `usid_degrees`. A certified
// table takes seconds to prove for 100,000 triangles.
struct FastSizes {
  std::vector<std::size_t> cube_cells;    // cells along an edge of the cube
  std::vector<double> rsid_degrees;       // precisions, degrees
  std::vector<double> usid_degrees = {};  // precisions, degrees
  bool certified = true;                  // is the certified table tried, too?
  std::vector<double> voxels_mm = {};     // of OpenVDB's grids
  std::vector<std::size_t> corner_cells = {kMainCells,
                                           kCornersOfAMebibyte};  // cells along an edge of the cube
};
// Every method on this surface, kernels in each storage.
std::vector<GapMethodMaker> fast_methods(const AskedSurface& surface, const FastSizes& sizes);

}  // namespace impinge::lab
