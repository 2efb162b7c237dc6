// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>

#include <Eigen/Geometry>

#include "20_claims/claims_study.hpp"
#include "20_claims/self_collision.hpp"
#include "mesh/bodies.hpp"
#include "methods/face_crossings.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge::lab {
namespace {

constexpr double kBone = 24.0;       // mm
constexpr double kCartilage = 26.0;  // mm
constexpr double kPressed = 3.0;     // mm, deeper than the cartilage is thick
constexpr double kCap = 25.0;        // degrees, half the width of what is pressed in

// Bone and, pressed in on one side, cartilage: one mesh whose two layers cross along a ring. The bone is
// turned, so that no vertex of one lies under one of the other.
TriangleMesh pressed_cartilage(std::size_t faces) {
  const Vec3 middle = Vec3(0.5, -0.3, 0.6).normalized();
  TriangleMesh mesh = radial_body(faces, [&middle](const Vec3& u) {
    const double share = angle_between(u, middle) / (kCap * kDegree);
    return kCartilage - (share < 1.0 ? kPressed * std::pow(std::cos(0.5 * kPi * share), 2) : 0.0);
  });
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  const TriangleMesh bone = radial_body(faces, [](const Vec3&) { return kBone; });
  const auto shift = static_cast<VertexIndex>(mesh.vertices.size());
  for (const Vec3& v : bone.vertices) mesh.vertices.emplace_back(turn * v);
  for (const Face& f : bone.faces) mesh.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  return mesh;
}

}  // namespace

void add_self_collision(ClaimsStudy& study, const ClaimsOptions& options) {
  const char* claim = "self-collision found while sampling";
  const TriangleMesh mesh = pressed_cartilage(options.faces);
  const std::vector<FacePair> crossing = face_crossings(mesh);
  study.rows.push_back({claim, "exact", "pairs crossing", static_cast<double>(crossing.size()), "1"});
  for (const double precision : options.collision_precisions) {
    const Rsid scheme = Rsid::with_precision(precision);
    for (const double tolerance : {0.001, 0.01, 0.1}) {
      const std::string setting =
          Cell(precision).text() + " degrees, within " + Cell(tolerance).text() + " mm";
      const std::vector<FacePair> found = self_collisions(mesh, scheme, tolerance);
      std::vector<FacePair> right;
      std::ranges::set_intersection(found, crossing, std::back_inserter(right));
      const auto share = static_cast<double>(right.size()) / static_cast<double>(crossing.size());
      study.rows.push_back({claim, setting, "crossing pairs found", 100.0 * share, "%"});
      const auto wrong = static_cast<double>(found.size() - right.size());
      study.rows.push_back({claim, setting, "pairs found that do not cross", wrong, "1"});
    }
  }
}

}  // namespace impinge::lab
