// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact_radius.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include <CGAL/box_intersection_d.h>

#include "reference/exact_input.hpp"
#include "reference/exact_ratio.hpp"
#include "reference/kernel_point.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {
namespace {

using Point = Kernel::Point_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

constexpr std::size_t kDirectionBatch = 1U << 16U;  // directions at a time
constexpr double kSlack = 1e-9;                     // far above the rounding of a unit vector

struct Hit {
  std::size_t direction;
  std::size_t face;
};

Box box_about(const Vec3& middle, double reach, std::size_t info) {
  const Vec3 low = middle.array() - reach;
  const Vec3 high = middle.array() + reach;
  return {CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()), info};
}

// A box round the part of the unit sphere that a face covers. A cap smaller than a hemisphere that holds the
// corners holds the triangle between them, and a ball about the middle of the cap holds the cap.
Box box_of(const TriangleMesh& mesh, std::size_t f) {
  const Face& face = mesh.faces[f];
  Vec3 sum = Vec3::Zero();
  for (const VertexIndex v : face) sum += mesh.vertices[v].stableNormalized();
  const Vec3 middle = sum.normalized();
  double chord = 0.0;
  for (const VertexIndex v : face)
    chord = std::max(chord, (mesh.vertices[v].stableNormalized() - middle).norm());
  const bool small = sum.norm() > 0.1 && chord < 1.4;  // 1.414 is a hemisphere
  return small ? box_about(middle, chord + kSlack, f) : box_about(Vec3::Zero(), 2.0, f);
}

class Caster {
 public:
  explicit Caster(const TriangleMesh& mesh) : mesh_(mesh) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      side_.push_back(side(f));
      if (side_.back() != CGAL::COPLANAR) boxes_.push_back(box_of(mesh, f));
    }
  }

  // The faces that directions first .. last - 1 meet, direction by direction.
  std::vector<Hit> hits(std::span<const Vec3> directions, std::size_t first, std::size_t last) {
    std::vector<Box> rays;
    rays.reserve(last - first);
    for (std::size_t i = first; i < last; ++i)
      rays.push_back(box_about(directions[i].stableNormalized(), 0.0, i));
    std::vector<Hit> found;
    CGAL::box_intersection_d(rays.begin(), rays.end(), boxes_.begin(), boxes_.end(),
                             [&](const Box& ray, const Box& face) {
                               if (meets(face.info(), directions[ray.info()]))
                                 found.push_back({ray.info(), face.info()});
                             });
    std::ranges::sort(found, {}, &Hit::direction);
    return found;
  }

  // (r / 1 mm)^2 along a direction that meets the face.
  ExactRatio squared_radius(const Hit& hit, const Vec3& direction) const {
    const Face& face = mesh_.faces[hit.face];
    const ExactVector a = exact(corner(mesh_, face, 0));
    const ExactVector n =
        CGAL::cross_product(exact(corner(mesh_, face, 1)) - a, exact(corner(mesh_, face, 2)) - a);
    const ExactVector u = exact(direction);
    const ExactNumber over = n * a;
    const ExactNumber under = n * u;
    return {over * over * (u * u), under * under};
  }

 private:
  CGAL::Orientation side(std::size_t f) const {
    const Face& face = mesh_.faces[f];
    return CGAL::orientation(Point(CGAL::ORIGIN), kernel_point(corner(mesh_, face, 0)),
                             kernel_point(corner(mesh_, face, 1)), kernel_point(corner(mesh_, face, 2)));
  }

  // Is u in the closed cone over the face? u is the sum of the corners with the weights det(u, b, c), det(a,
  // u, c) and det(a, b, u), each over det(a, b, c), which must not be negative.
  bool meets(std::size_t f, const Vec3& u) const {
    const Face& face = mesh_.faces[f];
    const std::array<Point, 3> corners{kernel_point(corner(mesh_, face, 0)),
                                       kernel_point(corner(mesh_, face, 1)),
                                       kernel_point(corner(mesh_, face, 2))};
    const auto is_within = [&](std::size_t k) {
      const auto turn =
          CGAL::orientation(Point(CGAL::ORIGIN), corners[k], corners[(k + 1) % 3], kernel_point(u));
      return turn == CGAL::COPLANAR || turn == side_[f];
    };
    return is_within(0) && is_within(1) && is_within(2);
  }

  const TriangleMesh& mesh_;
  std::vector<CGAL::Orientation> side_;
  std::vector<Box> boxes_;
};

void require_directions(std::span<const Vec3> directions) {
  require_finite(directions, "direction");
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (directions[i].isZero(0.0)) {
      throw std::invalid_argument("direction " + std::to_string(i) + " is of length zero; leave it out");
    }
  }
}

}  // namespace

std::vector<double> exact_radii(const TriangleMesh& mesh, const RadiusQuery& query) {
  require_exact_input(mesh);
  require_directions(query.directions);
  Caster caster(mesh);
  std::vector<double> radii(query.directions.size(), kNoSurface);
  for (std::size_t first = 0; first < radii.size(); first += kDirectionBatch) {
    const std::size_t last = std::min(first + kDirectionBatch, radii.size());
    const std::vector<Hit> hits = caster.hits(query.directions, first, last);
    for (std::size_t i = 0; i < hits.size();) {
      const std::size_t direction = hits[i].direction;
      ExactRatio kept = caster.squared_radius(hits[i], query.directions[direction]);
      for (++i; i < hits.size() && hits[i].direction == direction; ++i) {
        const ExactRatio other = caster.squared_radius(hits[i], query.directions[direction]);
        if (query.layer == Layer::nearest ? other < kept : kept < other) kept = other;
      }
      radii[direction] = nearest_root(kept);
    }
    if (query.progress) query.progress(last);
  }
  return radii;
}

}  // namespace impinge
