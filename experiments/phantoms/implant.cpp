// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "contact/culled_joint.hpp"
#include "gap/gap_scan.hpp"
#include "mesh/bodies.hpp"
#include "mesh/loft.hpp"
#include "phantoms/phantom.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/exact_raster.hpp"
#include "table/table_bound.hpp"

namespace impinge {
namespace {

// mm
constexpr double kHeadRadius = 16.0;
constexpr double kNeckRadius = 6.0;   // radius
constexpr double kNeckLength = 40.0;  // from the centre
constexpr double kBendRadius = 30.0;  // of the bend from the neck to the shaft
constexpr double kShaftRadius = 8.0;  // radius where it begins
constexpr double kTipRadius = 4.0;    // radius where it ends
constexpr double kShaftLength = 130.0;
constexpr double kClearance = 0.1;
constexpr double kShell = 6.0;  // thickness of the cup

// Unit vector away from the midline, `down` from the transverse plane and `forward` from the frontal plane.
Vec3 outwards(double down, double forward) {
  return {std::cos(forward) * std::cos(down), std::sin(forward) * std::cos(down), -std::sin(down)};
}

// A place on the middle line of the stem, with its ring.
struct Station {
  Vec3 centre, along;  // mm, unit vector
  double radius;       // mm
};

// The stem from the pole of the head: rings at equal steps on each of its pieces.
class Stem {
 public:
  Station on_head(double share) const {
    const double polar = share * (kPi - std::asin(kNeckRadius / kHeadRadius));
    return {-kHeadRadius * std::cos(polar) * neck_, neck_, kHeadRadius * std::sin(polar)};
  }
  Station on_neck(double share) const {
    const double begin = std::sqrt(kHeadRadius * kHeadRadius - kNeckRadius * kNeckRadius);
    return {std::lerp(begin, kNeckLength, share) * neck_, neck_, kNeckRadius};
  }
  Station on_bend(double share) const {
    const double turn = share * std::acos(-neck_.z());
    const Vec3 inwards = side().cross(neck_);
    const Vec3 way = std::sin(turn) * neck_ + (1.0 - std::cos(turn)) * inwards;
    return {kNeckLength * neck_ + kBendRadius * way, std::cos(turn) * neck_ + std::sin(turn) * inwards,
            std::lerp(kNeckRadius, kShaftRadius, share)};
  }
  Station on_shaft(double share) const {
    const Station begin = on_bend(1.0);
    return {begin.centre + share * kShaftLength * begin.along, begin.along,
            std::lerp(kShaftRadius, kTipRadius, share)};
  }

  // Perpendicular to the plane of neck and shaft.
  Vec3 side() const { return neck_.cross(-Vec3::UnitZ()).normalized(); }

 private:
  Vec3 neck_ = outwards(45.0 * kDegree, 10.0 * kDegree);
};

std::vector<Vec3> ring_of(const Station& at, const Vec3& side, std::size_t sides) {
  const Vec3 across = side.cross(at.along);
  std::vector<Vec3> ring;
  for (std::size_t k = 0; k < sides; ++k) {
    const double angle = 2.0 * kPi * static_cast<double>(k) / static_cast<double>(sides);
    ring.push_back(at.centre + at.radius * (std::cos(angle) * side + std::sin(angle) * across));
  }
  return ring;
}

TriangleMesh make_stem(std::size_t sides) {
  const Stem stem;
  std::vector<std::vector<Vec3>> rings{{stem.on_head(0.0).centre}};
  const auto add = [&](Station (Stem::*piece)(double) const, double share_of_rings) {
    const double steps = std::round(share_of_rings * static_cast<double>(sides));
    for (double k = 1.0; k <= steps; ++k)
      rings.push_back(ring_of((stem.*piece)(k / steps), stem.side(), sides));
  };
  add(&Stem::on_head, 0.35);
  add(&Stem::on_neck, 0.2);
  add(&Stem::on_bend, 0.15);
  add(&Stem::on_shaft, 0.3);
  rings.push_back({stem.on_shaft(1.0).centre});
  return loft(rings);
}

TriangleMesh make_cup(std::size_t sides) {
  const double half = 0.5 * static_cast<double>(sides);
  const double step = 0.5 * kPi / half;
  const double inner = kHeadRadius + kClearance;
  std::vector<LatheRing> rings = sphere_rings(inner + kShell, 0.5 * kPi, step);
  std::vector<LatheRing> inside = sphere_rings(inner, 0.5 * kPi, step);
  rings.insert(rings.end(), inside.rbegin(), inside.rend());
  return revolve({rings, -outwards(45.0 * kDegree, 20.0 * kDegree), Vec3::Zero(), sides});
}

constexpr double kFirst = 2e-4;   // radians, from a place of contact to the first ring about it
constexpr double kGrowth = 1.15;  // of each further ring
constexpr double kCoarsest = 0.15;

constexpr double kInner = 20.0;  // mm
constexpr double kOuter = 26.0;

// How far inside a sphere about `centre` the faces of an inscribed mesh are, mm, along directions from the
// origin: the sagitta R - d, d the distance of the plane, divided by the cosine of the largest angle between
// a direction and the sphere's normal. The sine of that angle is |centre| / R; the tilt of a face against the
// normal at its corners is subtracted from it.
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

// The gap at the ball's vertex next to the place of the smallest gap. No face of the socket is beyond its
// sphere, so the smallest gap of all vertices is at most this.
double gap_at_nearest(const Spheres& spheres) {
  double least = HUGE_VAL;
  for (const Vec3& x : spheres.ball.vertices) least = std::min(least, spheres.gap(x.normalized()));
  return least;
}

// The largest error of a scan's gaps by tables.
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

BallSocketPair make_implant(std::size_t faces) {
  const auto sides = static_cast<std::size_t>(std::lround(std::sqrt(0.25 * static_cast<double>(faces))));
  return {make_stem(sides), make_cup(sides)};
}

TriangleMesh revolve(const Revolution& body) {
  const Vec3 x = body.axis.unitOrthogonal();
  const Vec3 y = body.axis.cross(x);
  std::vector<std::vector<Vec3>> rings;
  for (const LatheRing& ring : body.rings) {
    std::vector<Vec3>& points = rings.emplace_back();
    if (ring.polar == 0.0 || ring.polar == kPi) {
      points.push_back(body.centre + (ring.polar == 0.0 ? ring.radius : -ring.radius) * body.axis);
      continue;
    }
    for (std::size_t k = 0; k < body.sides; ++k) {
      const CosSin at = half_turn_fraction(2 * static_cast<long>(k), static_cast<long>(body.sides));
      points.push_back(body.centre + ring.radius * (std::cos(ring.polar) * body.axis +
                                                    std::sin(ring.polar) * (at.cos * x + at.sin * y)));
    }
  }
  return loft(rings);
}

std::vector<LatheRing> sphere_rings(double radius, double to, double step) {
  const auto steps = static_cast<std::size_t>(std::ceil(to / step));
  std::vector<LatheRing> rings;
  for (std::size_t k = 0; k < steps; ++k)
    rings.push_back({to * static_cast<double>(k) / static_cast<double>(steps), radius});
  rings.push_back({to, radius});
  return rings;
}

std::vector<LatheRing> focused_rings(double radius) {
  std::vector<LatheRing> rings{{0.0, radius}};
  for (double polar = kFirst; polar < kPi - kCoarsest; polar += std::min((kGrowth - 1.0) * polar, kCoarsest))
    rings.push_back({polar, radius});
  rings.push_back({kPi, radius});
  return rings;
}

std::vector<PhantomRow> phantom_gaps(const PhantomSizes& sizes) {
  std::vector<PhantomRow> rows;
  for (const double by : {1.0, 2.0, 5.0}) add_rows({by * Vec3(1.0, 2.0, 2.0) / 3.0, sizes}, rows);
  return rows;
}

}  // namespace impinge
