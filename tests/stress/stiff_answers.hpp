// SPDX-License-Identifier: GPL-3.0-or-later
// What every kernel answers, from the mesh on, as lists of numbers that can be compared.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gap/simd/exact_cells.hpp"
#include "mesh/bodies.hpp"
#include "sphere/as_floats.hpp"
#include "stress/shapes.hpp"
#include "stress/stiff_surfaces.hpp"
#include "stress/table_kernels.hpp"
#include "support/directions.hpp"
#include "support/soup.hpp"

namespace impinge::test {

using namespace lab;

// Points in a pose, and the surface that they are asked of.
struct Questions {
  TriangleMesh mesh;
  Layer layer = Layer::nearest;
  std::vector<Vec3> points;
  Pose pose;
  double unit = 1.0;  // of length, over that of what is stated in mm
};

// Gaps, mm; NaN for none.
using Answers = std::vector<double>;

// Of the exact cells.
inline Answers exact_answers(const Questions& asked) {
  std::vector<float> gap(asked.points.size());
  scan_gaps(exact_cells(asked.mesh, asked.layer), packed_vertices<float>(asked.points), asked.pose,
            Surface::ball, gap);
  return {gap.begin(), gap.end()};
}

// Of all table kernels, one after the other.
inline Answers table_answers(const Questions& asked) {
  Answers all;
  for (const auto& kernel : table_kernels(asked.mesh, asked.layer, 15.0)) {
    const Answers gaps = kernel->gaps(asked.points, asked.pose, Surface::ball);
    all.insert(all.end(), gaps.begin(), gaps.end());
  }
  return all;
}

// A kernel, from the mesh on.
struct Answerer {
  const char* name;
  std::function<Answers(const Questions&)> answer;
};
// All of them.
inline const std::vector<Answerer>& answerers() {
  static const std::vector<Answerer> all{{"tables", table_answers}, {"exact cells", exact_answers}};
  return all;
}

// A surface of each kind: exact coordinates, layers, holes, cliffs everywhere.
struct NamedSurface {
  const char* name;
  StiffSurface surface;
};
inline std::vector<NamedSurface> some_surfaces() {
  return {{"dyadic", {dyadic_body()}},
          {"pleated", {pleated(3)}},
          {"noise", {noisy(sphere(22.0, 200, {2.0, -3.0, 1.0}), 0.1, 3)}},
          {"soup", {soup(30, 9), Layer::farthest}}};
}

// At random and at its corners.
inline Questions questions_for(const StiffSurface& surface) {
  Questions asked{surface.mesh, surface.layer, {}, {}};
  for (const Vec3& u : random_directions(200, 4)) asked.points.push_back(as_floats(23.0 * u));
  for (std::size_t v = 0; v < surface.mesh.vertices.size(); v += 3)
    asked.points.push_back(as_floats(surface.mesh.vertices[v]));
  return asked;
}

}  // namespace impinge::test
