// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles at random, to test what must hold for any mesh: layers over layers, cliffs, and rims everywhere.
#pragma once

#include <cstddef>
#include <random>

#include "mesh/triangle_mesh.hpp"
#include "support/joined.hpp"
#include "support/random_vector.hpp"

namespace impinge::test {

// Corners uniform in the cube of half side 30 mm about the centre.
inline TriangleMesh soup(std::size_t faces, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-30.0, 30.0);
  TriangleMesh mesh;
  for (std::size_t f = 0; f < faces; ++f) {
    const Vec3 a = random_vector(place, random);
    const Vec3 b = random_vector(place, random);
    add_face(mesh, a, b, random_vector(place, random));
  }
  return mesh;
}

}  // namespace impinge::test
