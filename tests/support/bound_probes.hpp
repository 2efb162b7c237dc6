// SPDX-License-Identifier: GPL-3.0-or-later
// Directions along which a bound is put to the test, and a search for the worst one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/jump_edges.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sphere/scheme.hpp"
#include "support/directions.hpp"
#include "support/wrapped_scheme.hpp"

namespace impinge::test {

// Uniform ones, features of the mesh, poles and seam, both sides of the rim, the steepest face, and the
// entries themselves with directions next to them.
template <SamplingScheme S>
std::vector<Vec3> bound_probes(const TriangleMesh& mesh, const S& scheme, std::size_t uniform) {
  std::vector<Vec3> probes = random_directions(uniform, 60);
  for (const Vec3& u : test::feature_directions(mesh)) probes.push_back(u);
  for (const Vec3& x : special_directions()) probes.push_back(x.normalized());
  for (const JumpEdge& edge : jump_edges(mesh)) {
    const Vec3 middle = (mesh.vertices[edge.from] + mesh.vertices[edge.to]).normalized();
    const Vec3 across = mesh.vertices[edge.from].cross(mesh.vertices[edge.to]).normalized();
    for (const double off : {-0.05, -1e-3, -1e-9, 1e-9, 1e-3, 0.05})
      probes.push_back((middle + off * across).normalized());
  }
  const auto steepest = std::ranges::max_element(mesh.faces, {}, [&mesh](const Face& face) {
    const TriangleCone cone = cone_of(mesh, face);
    return cone.edge_on() ? 0.0 : cone.largest_slope();
  });
  for (const Vec3& u : random_directions(200, 61)) {
    const Vec3 weight = u.cwiseAbs();
    probes.push_back((weight[0] * corner(mesh, *steepest, 0) + weight[1] * corner(mesh, *steepest, 1) +
                      weight[2] * corner(mesh, *steepest, 2))
                         .normalized());
  }
  const std::size_t step = std::max<std::size_t>(scheme.size() / 500, 1);
  for (std::size_t i = 0; i < scheme.size(); i += step) {
    const Vec3 u = scheme.direction(i);
    probes.push_back(u);
    probes.push_back((u + 0.3 * scheme.stencil_radius() * u.unitOrthogonal()).normalized());
  }
  return probes;
}

// Largest error over the probes and over climbs from the worst of them; `step` is the first step, radians.
template <class Error>
double largest_error(const Error& error, const std::vector<Vec3>& probes, double step) {
  constexpr std::ptrdiff_t kClimbs = 12;
  std::vector<std::pair<double, std::size_t>> found(probes.size());
  for (std::size_t i = 0; i < probes.size(); ++i) found[i] = {error(probes[i]), i};
  const auto last = found.begin() + std::min(kClimbs, static_cast<std::ptrdiff_t>(found.size()));
  std::ranges::partial_sort(found, last, std::greater<>{});
  double largest = 0.0;
  for (auto start = found.begin(); start != last; ++start) {
    Vec3 u = probes[start->second];
    double here = start->first;
    for (double reach = step; reach > 1e-6 * step; reach *= 0.6) {
      const Vec3 east = u.unitOrthogonal();
      const Vec3 north = u.cross(east);
      for (int k = 0; k < 8; ++k) {
        const double angle = 0.25 * kPi * k;
        const Vec3 v = (u + reach * (std::cos(angle) * east + std::sin(angle) * north)).normalized();
        const double there = error(v);
        if (there > here) {
          here = there;
          u = v;
        }
      }
    }
    largest = std::max(largest, here);
  }
  return largest;
}

// One face on the plane x = distance that takes in a circle of about `opening` degrees round +x.
inline TriangleMesh large_flat_face(double distance, double opening) {
  TriangleMesh mesh;
  const double reach = 2.0 * distance * std::tan(opening * kDegree);
  mesh.vertices = {{distance, -reach, -reach},
                   {distance, 1.9 * reach, -0.3 * reach},
                   {distance, -0.4 * reach, 1.8 * reach}};
  mesh.faces = {{0, 1, 2}};
  return mesh;
}

// A scheme whose stencil is the tap that is farthest from the direction: nothing but the stencil radius says
// how wrong it is. It declares no patches.
template <SamplingScheme S>
class FarTap : public Wrapped<S> {
 public:
  static constexpr bool kFlatCells = S::kFlatCells;
  static FarTap with_precision(double degrees) {
    FarTap scheme;
    scheme.hold(S::with_precision(degrees));
    return scheme;
  }
  Stencil stencil(const Vec3& x) const {
    Stencil stencil = Wrapped<S>::stencil(x);
    const Vec3 u = x.normalized();
    const auto farther = [&](std::size_t a, std::size_t b) {
      return this->direction(a).dot(u) > this->direction(b).dot(u);
    };
    const std::size_t far = *std::max_element(stencil.entry.begin(), stencil.entry.begin() + 4, farther);
    return {{far, far, far, far}, {1.0, 0.0, 0.0, 0.0}, 1, stencil.cell};
  }
};

}  // namespace impinge::test
