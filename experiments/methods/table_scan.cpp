// SPDX-License-Identifier: GPL-3.0-or-later
// @can     touch baseline
// @links   gap
//
// Methods rsid and usid: both scans of all vertices, with the thesis' tables.

#include "methods/table_scan.hpp"

#include "files/csv.hpp"
#include "methods/baseline.hpp"
#include "methods/table_scan.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"
#include "sphere/walker.hpp"

namespace impinge::lab {
namespace {

constexpr double kRounding = 1e-9;  // mm, of a radius in double

template <SamplingScheme S>
Touch scan_of(const BallSocketPair& pair, std::shared_ptr<const TablePair<S>> tables) {
  return [scan = std::make_shared<TableScan<S>>(pair.ball, pair.socket, std::move(tables))](
             const Pose& pose) { return scan->touches(pose); };
}

template <SamplingScheme S>
TouchCase touch_case(const BallSocketPair& pair, const char* label, double precision_deg) {
  return {{std::string(S::name), label, "", 2}, scan_of<S>(pair, make_tables<S>(pair, precision_deg)), true};
}

// Faces without an entry inside.
std::size_t faces_without_entry(const TriangleMesh& mesh, const Rsid& scheme) {
  const auto walker = walker_of(scheme);
  std::size_t without = 0;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    bool met = false;
    for_each_entry_inside(walker, cone, [&met](std::size_t, const Vec3&) { met = true; });
    without += met ? 0U : 1U;
  }
  return without;
}

BaselineCase at_precision(const BallSocketPair& joint, double precision) {
  const auto tables = make_tables<Rsid>(joint, precision);
  require_radii(tables->ball, joint.ball, Layer::farthest, {300, kRounding, true});
  BaselineCase one;
  static_cast<Case&>(one) = {"rsid", "RSID", Cell(precision).text() + " degrees", 3};
  one.size = precision;
  one.touches = scan_of<Rsid>(joint, tables);
  one.gives_distance = true;
  const std::size_t rims = tables->ball.rim_cells().bytes() + tables->socket.rim_cells().bytes();
  one.bytes = static_cast<double>(2 * RadialTable<Rsid>::bytes(tables->ball.scheme()) + rims);
  one.build = [&joint, precision] { make_tables<Rsid>(joint, precision); };
  one.missed_faces = static_cast<double>(faces_without_entry(joint.ball, tables->ball.scheme()));
  one.radius = [tables](const Vec3& y) { return tables->ball.radius_at(y); };
  return one;
}

}  // namespace

Method table_scan_method() {
  Method method;
  method.lacks = "contacts of edges between vertices, which a scan of vertices does not see";
  method.touch = [](const BallSocketPair& pair, double precision_deg) {
    return std::vector{touch_case<Rsid>(pair, "RSID", precision_deg),
                       touch_case<Usid>(pair, "USID", precision_deg)};
  };
  method.baseline = [](const BallSocketPair& joint, const BaselineSizes& sizes) {
    std::vector<BaselineCase> cases;
    for (const double precision : sizes.precisions_deg) cases.push_back(at_precision(joint, precision));
    return cases;
  };
  return method;
}

}  // namespace impinge::lab
