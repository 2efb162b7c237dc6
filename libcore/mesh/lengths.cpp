// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/lengths.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <stdexcept>

namespace impinge {
namespace {

struct LengthRange {
  double least;  // mm
  double most;   // mm
};

[[noreturn]] void refuse(std::size_t face, double length, const LengthRange& range) {
  char text[240];
  if (std::isfinite(length)) {
    std::snprintf(
        text, sizeof text,
        "face %zu reaches to coordinates of %.3g mm, and lengths are from %.2g to %.2g mm: scale the "
        "mesh to millimetres",
        face, length, range.least, range.most);
  } else {
    std::snprintf(
        text, sizeof text,
        "face %zu has a corner with a coordinate that is not a finite number: repair the mesh or leave "
        "the face out",
        face);
  }
  throw std::invalid_argument(text);
}

// Largest absolute coordinate of a face; NaN if it has one.
double extent(const TriangleMesh& mesh, const Face& face) {
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double x : corner(mesh, face, k)) {
      if (!(std::abs(x) <= largest)) largest = std::abs(x);
      if (std::isnan(largest)) return largest;
    }
  }
  return largest;
}

// If true, all faces are within the range too. This is faster, as each vertex is read once and in a row, and
// the corners of faces six times. False decides nothing: the sum may be at fault, or a vertex of no face.
bool all_vertices_within(const TriangleMesh& mesh, const LengthRange& range) {
  return std::ranges::all_of(mesh.vertices, [&range](const Vec3& v) {
    const double sum = std::abs(v.x()) + std::abs(v.y()) + std::abs(v.z());
    return sum >= 3.0 * range.least && sum <= range.most;
  });
}

void require(const TriangleMesh& mesh, const LengthRange& range) {
  if (all_vertices_within(mesh, range)) return;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const double length = extent(mesh, mesh.faces[f]);
    if (length != 0.0 && !(length >= range.least && length <= range.most)) refuse(f, length, range);
  }
}

}  // namespace

void require_lengths(const TriangleMesh& mesh) { require(mesh, {kLeastLength, kMostLength}); }

void require_float_lengths(const TriangleMesh& mesh) { require(mesh, {kLeastFloatLength, kMostFloatLength}); }

}  // namespace impinge
