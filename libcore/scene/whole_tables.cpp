// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/whole_tables.hpp"

#include <algorithm>

#include "files/stopwatch.hpp"
#include "gap/gap_scan.hpp"
#include "mesh/surface_vertices.hpp"
#include "scene/wanted_tables.hpp"
#include "sphere/scheme_choice.hpp"
#include "table/direction_bounds.hpp"
#include "table/exact_raster.hpp"

namespace impinge {
namespace {

// How the gaps were found. Without times, which are in a summary's times_ms: the rest of it is the same in
// every run.
constexpr const char* kWay =
    "whole tables, filled and scanned in double: fill_tables and scan in times_ms of summary.json are the "
    "most that faster kernels could save";

// A vertex of no face belongs to no surface: it has no gap.
void forget_stray_vertices(const TriangleMesh& mesh, std::vector<double>& gap) {
  const std::vector<bool> used = on_surface(mesh);
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!used[i]) gap[i] = kNoSurface;
  }
}

template <SamplingScheme S>
struct Scans {
  const S& scheme;
  const Joint& joint;
  const Pose& pose;

  // Bound of the error at each vertex, whose direction in the frame of the table is given by `place`. mesh
  // filled the table.
  template <class Place>
  static std::vector<double> bounds(const TriangleMesh& mesh, const RadialTable<S>& table, Layer layer,
                                    const std::vector<Vec3>& vertices, Place&& place) {
    const DirectionBounds direction(mesh, table, layer);
    std::vector<double> bound(vertices.size());
    std::ranges::transform(vertices, bound.begin(), [&](const Vec3& v) { return direction.at(place(v)); });
    return bound;
  }

  Measurement run() const {
    Measurement result;
    result.pose = pose;
    result.way = kWay;
    result.precision_deg = scheme.precision_deg();
    result.entries = scheme.size();
    result.bytes = 2 * RadialTable<S>::bytes(scheme);
    const TriangleMesh& ball = joint.ball.mesh;
    const TriangleMesh& socket = joint.socket.mesh;
    result.ball.gap.resize(ball.vertices.size());
    result.socket.gap.resize(socket.vertices.size());
    Stopwatch watch;
    const RadialTable<S> ball_table = fill_exact(ball, scheme, Layer::farthest);
    const RadialTable<S> socket_table = fill_exact(socket, scheme, Layer::nearest);
    result.fill_ms = watch.lap_ms();
    scan_gaps(socket_table, ball.vertices, pose, Surface::ball, result.ball.gap);
    scan_gaps(ball_table, socket.vertices, pose, Surface::socket, result.socket.gap);
    result.scan_ms = watch.lap_ms();
    forget_stray_vertices(ball, result.ball.gap);
    forget_stray_vertices(socket, result.socket.gap);
    result.ball.bound = bounds(socket, socket_table, Layer::nearest, ball.vertices,
                               [&](const Vec3& v) { return to_socket(pose, v); });
    result.socket.bound = bounds(ball, ball_table, Layer::farthest, socket.vertices,
                                 [&](const Vec3& v) { return to_ball(pose, v); });
    result.bound_ms = watch.lap_ms();
    return result;
  }
};

template <SamplingScheme S>
Measurement measure_at(double precision_deg, const Joint& joint, const Pose& pose) {
  const S scheme = S::with_precision(precision_deg);
  const double entry = sizeof(double) + sizeof(float);  // radius and slope
  require_memory({scheme.size(), precision_deg, 2.0 * entry * static_cast<double>(scheme.size()), "",
                  "a coarser --precision"});
  return Scans<S>{scheme, joint, pose}.run();
}

}  // namespace

Measurement measure_whole_tables(const Joint& joint, const SceneOptions& options, const Pose& pose) {
  Measurement result;
  with_scheme(options.scheme, [&]<class S>() { result = measure_at<S>(options.precision_deg, joint, pose); });
  return result;
}

}  // namespace impinge
