// SPDX-License-Identifier: GPL-3.0-or-later
// @can     baseline
// @links   gap method_cgal

#include "methods/cartesian_field.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "methods/baseline.hpp"
#include "methods/cgal.hpp"

namespace impinge::lab {
namespace {

BaselineCase with_nodes(const BallSocketPair& joint, std::size_t nodes) {
  const DistanceGridShape shape = grid_shape({"", joint, {}}, nodes);
  const auto grid = std::make_shared<const GridField>(make_signed_field(joint.socket, shape));
  BaselineCase one;
  one.setting = std::to_string(nodes) + " nodes a side";
  one.place = 2;
  one.size = static_cast<double>(nodes);
  one.bytes = static_cast<double>(grid->bytes());
  one.gives_distance = true;
  one.distance = [grid](const Vec3& x) { return std::abs(grid->at(x)); };
  one.slack_mm = distance_grid_bound(shape);
  one.touches = [field = std::make_shared<CartesianField>(joint.ball, *grid)](const Pose& pose) {
    return field->touches(pose);
  };
  one.build = [&joint, shape] { make_signed_field(joint.socket, shape); };
  return one;
}

}  // namespace

GridField make_signed_field(const TriangleMesh& socket, const DistanceGridShape& shape) {
  const auto closest = make_cgal_closest(socket);
  const auto first_hit = make_cgal_first_hit(socket);
  std::vector<Vec3> directions;
  std::vector<double> radius(shape.nodes);
  return {shape, [&](const std::vector<Vec3>& nodes, std::vector<double>& out) {
            directions = nodes;
            std::ranges::replace(directions, Vec3::Zero().eval(),
                                 Vec3::UnitZ().eval());  // no ray ends where it begins
            closest.answer(nodes, out);
            first_hit.answer(directions, radius);
            for (std::size_t i = 0; i < nodes.size(); ++i) {
              if (nodes[i].norm() > radius[i]) out[i] = -out[i];  // not true where the socket is not met
            }
          }};
}

Method cartesian_field_method() {
  Method method{.name = "cartesian_field", .label = "Cartesian distance field"};
  method.lacks =
      "points outside of its cube, and the sign of a distance near the rim: an open surface has no inside";
  method.baseline = [](const BallSocketPair& joint, const BaselineSizes& sizes) {
    std::vector<BaselineCase> cases;
    for (const std::size_t nodes : sizes.nodes) cases.push_back(with_nodes(joint, nodes));
    return cases;
  };
  return method;
}

}  // namespace impinge::lab
