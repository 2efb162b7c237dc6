// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/cube_view.hpp"

#include <algorithm>
#include <cmath>

namespace impinge {
namespace {

constexpr double kLeastShare = 0.125;  // of the largest coordinate, for a corner to be projected

struct FaceAxes {
  Eigen::Index depth, a, b;
};
constexpr std::array<FaceAxes, 3> kFaceAxes{{{0, 1, 2}, {1, 0, 2}, {2, 0, 1}}};

double depth_through(const Vec3& v, std::size_t face) {
  const double depth = v[kFaceAxes[face / 2].depth];
  return face % 2 == 0 ? depth : -depth;
}

SeenCorner project(const Vec3& v, std::size_t face, double half) {
  const double q = 1.0 / depth_through(v, face);
  const FaceAxes& axes = kFaceAxes[face / 2];
  return {(v[axes.a] * q + 1.0) * half, (v[axes.b] * q + 1.0) * half, q, static_cast<std::uint32_t>(face)};
}

std::size_t face_before(const Vec3& v) {
  Eigen::Index axis = 0;
  v.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<std::size_t>(axis) + (v[axis] < 0.0 ? 1U : 0U);
}

// Do all corners lie beyond one side of the pyramid over a face of the cube, by a share of their distance?
bool surely_beside(const TriangleMesh& mesh, const Face& face, std::size_t through, double share) {
  const FaceAxes& axes = kFaceAxes[through / 2];
  const auto all = [&](auto&& beyond) {
    return std::ranges::all_of(face, [&](VertexIndex v) {
      const Vec3& x = mesh.vertices[v];
      return beyond(x, depth_through(x, through)) > share * x.cwiseAbs().maxCoeff();
    });
  };
  return all([](const Vec3&, double depth) { return -depth; }) ||
         all([&](const Vec3& x, double depth) { return x[axes.a] - depth; }) ||
         all([&](const Vec3& x, double depth) { return -x[axes.a] - depth; }) ||
         all([&](const Vec3& x, double depth) { return x[axes.b] - depth; }) ||
         all([&](const Vec3& x, double depth) { return -x[axes.b] - depth; });
}

}  // namespace

SeenCorner seen_corner(const Vec3& v, std::size_t divisions) {
  return project(v, face_before(v), 0.5 * static_cast<double>(divisions));
}

CubeView::CubeView(const TriangleMesh& mesh, std::size_t divisions)
    : mesh_(&mesh),
      divisions_(divisions),
      corners_(mesh.vertices.size()),
      margin_face_(mesh.vertices.size(), kNone) {}

void CubeView::see(std::size_t first_vertex, std::size_t end_vertex) {
  const double half = 0.5 * static_cast<double>(divisions_);
  const auto inside = [&](double x) { return x > kLeastReach && x < 2.0 * half - kLeastReach; };
  for (std::size_t v = first_vertex; v < end_vertex; ++v) {
    const Vec3& x = mesh_->vertices[v];
    const std::size_t face = face_before(x);
    corners_[v] = project(x, face, half);
    if (inside(corners_[v].x) && inside(corners_[v].y)) margin_face_[v] = static_cast<std::uint8_t>(face);
  }
}

SeenFace CubeView::seen_across(const Face& face, std::size_t through, double reach) const {
  SeenFace seen;
  if (surely_beside(*mesh_, face, through, 4.0 * reach / static_cast<double>(divisions_))) return seen;
  seen.projected = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& v = mesh_->vertices[face[k]];
    seen.corners[k] = project(v, through, 0.5 * static_cast<double>(divisions_));
    const double depth = depth_through(v, through);
    seen.projected =
        seen.projected && depth > kLeastShare * v.cwiseAbs().maxCoeff() && seen.corners[k].q < kMostInverse;
  }
  const auto last = static_cast<long>(divisions_);
  seen.window = seen.projected ? window_of(seen.corners, reach) : GridWindow{0, last, 0, last};
  return seen;
}

}  // namespace impinge
