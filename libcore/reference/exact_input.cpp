// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact_input.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace impinge {

void require_exact_input(const TriangleMesh& mesh) {
  if (mesh.faces.empty()) {
    throw std::invalid_argument("mesh: it has no faces, so there is no distance to it; read another file");
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const VertexIndex v : mesh.faces[f]) {
      if (v >= mesh.vertices.size()) {
        throw std::invalid_argument("mesh: face " + std::to_string(f) + " names vertex " + std::to_string(v) +
                                    " of " + std::to_string(mesh.vertices.size()) + "; repair the mesh");
      }
      if (!mesh.vertices[v].allFinite()) {
        throw std::invalid_argument("mesh: vertex " + std::to_string(v) +
                                    " has a coordinate that is not finite; repair the mesh");
      }
    }
  }
}

void require_finite(std::span<const Vec3> values, std::string_view what) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i].allFinite()) {
      throw std::invalid_argument(std::string(what) + " " + std::to_string(i) +
                                  " has a component that is not finite; leave it out");
    }
  }
}

}  // namespace impinge
