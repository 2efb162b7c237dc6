// SPDX-License-Identifier: GPL-3.0-or-later
// One interface for every way to say how far the surface of a scene is, point by point: tables, rays, closest
// points, distance grids, and answers for a whole pose.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "methods/benchmark_scene.hpp"

namespace impinge::lab {

// What an answer is, mm.
enum class Measure {
  radial,     // distance of the surface from the centre along the direction of the point
  euclidean,  // distance of the surface from the point
  pose        // one answer for all points: smallest distance between ball and socket, 0 where they touch
};
std::string_view name_of(Measure measure);  // "radial", "euclidean" or "pose"

class RadiusMethod {
 public:
  RadiusMethod() = default;
  RadiusMethod(const RadiusMethod&) = delete;
  RadiusMethod& operator=(const RadiusMethod&) = delete;
  virtual ~RadiusMethod() = default;

  // One answer for each point (one alone for Measure::pose); NaN where there is no surface. Points in the
  // socket's frame, mm, not at the centre. Not const: a method may keep scratch memory.
  virtual void answer(std::span<const Vec3> points, std::span<double> out) = 0;

  // Of everything that was built to answer; NaN where it cannot be known.
  virtual double bytes() const = 0;

  // What keeping numbers in fewer bytes adds to the error at most, mm.
  virtual double storage_bound() const { return 0.0; }
};

// What is proven of a method's error, mm; NaN where nothing is.
struct MethodBound {
  double bound_mm = std::numeric_limits<double>::quiet_NaN();     // no answer is off by more
  double attained_mm = std::numeric_limits<double>::quiet_NaN();  // largest error that the proof met
};

// How a method comes to be on one scene, and what the results call it.
struct MethodMaker {
  std::string name;                                                 // of the method, in the results
  std::string setting;                                              // such as "1deg float"
  std::string kind;                                                 // ours, thesis, library, grid or brute
  std::string scheme;                                               // of a table
  double precision_deg = std::numeric_limits<double>::quiet_NaN();  // of a table
  std::string interpolant = "none";                                 // smooth, mesh_exact or none
  std::string storage = "none";                                     // double, float, uint16 or none
  Measure measure = Measure::radial;                                // what the answers are
  // Everything that is done once for a surface. The scene outlives maker and method.
  std::function<std::unique_ptr<RadiusMethod>()> make;
  // Empty where nothing is proven but the rounding.
  std::function<MethodBound(const RadiusMethod&)> bound;
};

}  // namespace impinge::lab
