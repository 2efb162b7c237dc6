// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/cartesian_field.hpp"

#include <algorithm>

#include "methods/cgal_distances.hpp"

namespace impinge::lab {

GridField make_signed_field(const TriangleMesh& socket, const DistanceGridShape& shape) {
  const auto closest = make_cgal_closest(socket);
  const auto first_hit = make_cgal_first_hit(socket);
  std::vector<Vec3> directions;
  std::vector<double> radius(shape.nodes);
  return {shape, [&](const std::vector<Vec3>& nodes, std::vector<double>& out) {
            directions = nodes;
            std::ranges::replace(directions, Vec3::Zero().eval(),
                                 Vec3::UnitZ().eval());  // no ray ends where it begins
            closest->answer(nodes, out);
            first_hit->answer(directions, radius);
            for (std::size_t i = 0; i < nodes.size(); ++i) {
              if (nodes[i].norm() > radius[i]) out[i] = -out[i];  // false where the socket is not met
            }
          }};
}

}  // namespace impinge::lab
