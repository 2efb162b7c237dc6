// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/resampled.hpp"

#include "table/error_bound.hpp"

namespace impinge::lab {

double resampling_bound(const TriangleMesh& mesh, double precision_deg) {
  const double drawn = thesis_raster_bound(mesh);
  if (std::isinf(drawn)) return drawn;  // a face is edge-on
  double radius = 0.0;
  double slope = 0.0;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    slope = std::max(slope, cone.largest_slope());
    for (const Vec3& x : cone.corners()) radius = std::max(radius, x.norm());
  }
  const Rsid raster = raster_for(precision_deg);
  return drawn + radius * first_order_share(slope, raster.stencil_radius() + direction_doubt(raster));
}

}  // namespace impinge::lab
