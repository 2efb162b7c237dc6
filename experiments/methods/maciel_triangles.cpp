// SPDX-License-Identifier: GPL-3.0-or-later
// @can     baseline
// @links   gap triangle_table

#include "methods/maciel_triangles.hpp"

#include <memory>

#include "methods/baseline.hpp"

namespace impinge::lab {
namespace {

BaselineCase with_rays(const BallSocketPair& joint, std::size_t side, double most_pairs) {
  TriangleTable table = fill_triangles(joint.ball, side, Layer::farthest);
  BaselineCase one;
  one.setting = std::to_string(side) + " x " + std::to_string(side);
  one.place = 1;
  one.size = static_cast<double>(side);
  one.missed_faces = static_cast<double>(missed_faces(table, joint.ball));
  one.work = static_cast<double>(side * side) * static_cast<double>(joint.ball.faces.size());
  one.slack_mm = 1e-9;  // no triangle is farther than the farthest, but for rounding
  if (one.work <= most_pairs)
    one.build = [&joint, side] { fill_triangles_pairwise(joint.ball, side, Layer::farthest); };
  const auto triangles = std::make_shared<MacielTriangles>(joint.ball, joint.socket, std::move(table));
  one.bytes = static_cast<double>(triangles->bytes());
  one.touches = [triangles](const Pose& pose) { return triangles->touches(pose); };
  one.radius = [triangles](const Vec3& y) { return triangles->radius(y); };
  return one;
}

}  // namespace

bool MacielTriangles::touches(const Pose& pose) {
  bool touching = false;
  for (std::size_t i = 0; i < socket_.size(); ++i) {
    const Vec3 y = to_ball(pose, socket_[i]);
    gap_[i] = y.norm() - radius(y);
    touching = touching || gap_[i] <= 0.0;  // a NaN is not
  }
  return touching;
}

Method maciel_triangles_method() {
  Method method{.name = "maciel_triangles", .label = "Triangles (Maciel)"};
  method.lacks =
      "vertices under triangles that no ray met; distances, which are published without: its projection on "
      "the "
      "triangle would give the radial gap of the tested vertices";
  method.baseline = [](const BallSocketPair& joint, const BaselineSizes& sizes) {
    std::vector<BaselineCase> cases;
    for (const std::size_t side : sizes.rays) cases.push_back(with_rays(joint, side, sizes.most_pairs));
    return cases;
  };
  return method;
}

}  // namespace impinge::lab
