// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Geometry>

#include "contact/culled_joint.hpp"
#include "gap/gap_scan.hpp"
#include "mesh/bodies.hpp"
#include "phantoms/phantom.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/exact_raster.hpp"
#include "table/table_bound.hpp"

namespace impinge {
namespace {

constexpr double kInner = 20.0;  // mm
constexpr double kOuter = 26.0;

// How far a face of a mesh inscribed in a sphere about `centre` is inside of it, mm, along directions from
// the origin: the sagitta R - d, d the distance of the plane, over the cosine of the largest angle between a
// direction and the sphere's normal, whose sine is |centre| / R, less the tilt of a face against the normal
// at its corners.
double depth_of_faces(const TriangleMesh& mesh, double radius, const Vec3& centre) {
  double depth = 0.0;
  for (const Face& face : mesh.faces) {
    const Vec3 normal = area_vector(mesh, face).normalized();
    const double tilt = std::acos(std::min(1.0, normal.dot(corner(mesh, face, 0) - centre) / radius));
    const double incidence = std::asin(centre.norm() / radius) + tilt;
    depth = std::max(depth, radius * (1.0 - std::cos(tilt)) / std::cos(incidence));
  }
  return depth;
}

struct Spheres {
  Vec3 centre;  // of the ball
  PhantomSizes sizes;
  TriangleMesh ball = sphere(kInner, sizes.faces, centre);
  TriangleMesh socket = sphere(kOuter, sizes.faces);

  double gap(const Vec3& u) const { return kOuter - eccentric_sphere_radius(u, kInner, centre); }
};

// The gap at the vertex of the ball next to where it is smallest. No face of the socket is beyond its sphere,
// so that the smallest of all vertices is no larger.
double gap_at_nearest(const Spheres& spheres) {
  double least = HUGE_VAL;
  for (const Vec3& x : spheres.ball.vertices) least = std::min(least, spheres.gap(x.normalized()));
  return least;
}

// The largest error of the gaps of one scan, by tables.
double largest_error(const Spheres& spheres, const std::vector<Vec3>& vertices,
                     std::span<const double> gaps) {
  double largest = 0.0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    largest = std::max(largest, std::abs(gaps[i] - spheres.gap(vertices[i].normalized())));
  return largest;
}

void add_rows(const Spheres& spheres, std::vector<PhantomRow>& rows) {
  const std::string name =
      "eccentric spheres by " + std::to_string(std::lround(spheres.centre.norm())) + " mm";
  const double ball_depth = depth_of_faces(spheres.ball, kInner, spheres.centre);
  const double socket_depth = depth_of_faces(spheres.socket, kOuter, Vec3::Zero());
  const BallSocketPair joint{spheres.ball, spheres.socket};
  const double smallest = CulledJoint(joint).least_gap({})->gap_mm;
  const double closed = kOuter - kInner - spheres.centre.norm();
  rows.push_back({name, "smallest gap of a vertex on faces, mm", closed, smallest, smallest - closed,
                  std::max({ball_depth, socket_depth, gap_at_nearest(spheres) - closed}), true});
  const Rsid scheme = Rsid::with_precision(spheres.sizes.precision_deg);
  const auto socket_table = fill_exact(spheres.socket, scheme, Layer::nearest);
  const auto ball_table = fill_exact(spheres.ball, scheme, Layer::farthest);
  std::vector<double> gaps(spheres.ball.vertices.size());
  scan_gaps(socket_table, spheres.ball.vertices, {}, Surface::ball, gaps);
  const BoundOptions a_priori{1.05, 0};
  double error = largest_error(spheres, spheres.ball.vertices, gaps);
  rows.push_back({name, "gaps of the ball's vertices by table, largest error, mm", 0.0, error, error,
                  socket_depth + table_bound(spheres.socket, socket_table, Layer::nearest, a_priori).bound_mm,
                  true});
  gaps.resize(spheres.socket.vertices.size());
  scan_gaps(ball_table, spheres.socket.vertices, {}, Surface::socket, gaps);
  error = largest_error(spheres, spheres.socket.vertices, gaps);
  rows.push_back({name, "gaps of the socket's vertices by table, largest error, mm", 0.0, error, error,
                  ball_depth + table_bound(spheres.ball, ball_table, Layer::farthest, a_priori).bound_mm,
                  true});
}

}  // namespace

std::vector<PhantomRow> phantom_gaps(const PhantomSizes& sizes) {
  std::vector<PhantomRow> rows;
  for (const double by : {1.0, 2.0, 5.0}) add_rows({by * Vec3(1.0, 2.0, 2.0) / 3.0, sizes}, rows);
  return rows;
}

}  // namespace impinge
