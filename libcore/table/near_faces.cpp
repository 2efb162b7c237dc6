// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/near_faces.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/lengths.hpp"
#include "mesh/star_shape.hpp"
#include "sphere/infinity.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {
namespace {

constexpr double kFinest = 0.5;  // degrees between entries of the grid
constexpr double kCoarsest = 10.0;

constexpr double kPlaneSlack = 1e-6;   // of w . u in floats, as a share of |w|
constexpr double kLeastOffset = 1e-3;  // of a plane that says something, as a share of the farthest corner
constexpr double kLargest = 1e30;      // 1 / mm, of numbers that floats take with all their digits
constexpr double kSmallest = 1.0 / kLargest;

// A grid whose cells are about as large as the mean face, as seen from the centre.
CubeGnomonic face_grid(const TriangleMesh& mesh) {
  require_lengths(mesh);
  double total = 0.0;
  for (const Face& face : mesh.faces)
    total += std::abs(solid_angle(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)));
  const double mean = total / static_cast<double>(std::max<std::size_t>(mesh.faces.size(), 1));
  const double size_deg = std::clamp(std::sqrt(mean) / kDegree, kFinest, kCoarsest);
  return CubeGnomonic::with_precision(90.0 / std::round(90.0 / size_deg));
}

}  // namespace

NearFaces::NearFaces(const TriangleMesh& mesh, double margin)
    : mesh_(mesh),
      margin_(margin),
      index_(face_grid(mesh)),
      reach_(index_.grid().stencil_radius() + margin + kCapSlack),
      summaries_(index_.grid().size()),
      jumps_(jump_edges(mesh)) {
  caps_.reserve(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) see(f);
  index_.sort();
  for (const JumpEdge& edge : jumps_) {
    index_.for_each_near(cone_of(mesh, edge), reach_,
                         [&](std::size_t entry, const Vec3&) { summaries_[entry].rim = true; });
  }
}

// Lists the face at the entries within reach of its cap.
void NearFaces::see(std::size_t f) {
  const TriangleCone cone = cone_of(mesh_, mesh_.faces[f]);
  FaceCap seen = face_cap(cone.corners());
  caps_.push_back(
      {seen.cap.axis, seen.small() ? std::cos(seen.cap.radius) - kCapSlack : -1.0, seen.side, {}, HUGE_VALF});
  const Vec3 w = cone.plane().normal / cone.plane().offset;
  const double inverse = w.norm();  // of the distance of the plane
  if (cone.plane_distance() > kLeastOffset * seen.range.high && inverse > kSmallest && inverse < kLargest) {
    for (Eigen::Index k = 0; k < 3; ++k)
      caps_.back().plane[static_cast<std::size_t>(k)] = static_cast<float>(w[k]);
    caps_.back().slack = static_cast<float>(kPlaneSlack * inverse);
  }
  if (cone.edge_on()) return;
  seen.range.low = cone.largest_slope() > kSteepSlope ? 0.0 : seen.range.low * (1.0 - kRangeSlack);
  seen.range.high *= 1.0 + kRangeSlack;
  const float low = std::nextafter(static_cast<float>(seen.range.low), 0.0F);
  const float high = std::nextafter(static_cast<float>(seen.range.high), HUGE_VALF);
  const double wide = seen.cap.radius + reach_;
  const double least = seen.small() && wide < kPi ? std::cos(wide) - kCapSlack : -2.0;
  index_.add(f, cone, reach_, [&](std::size_t entry, const Vec3& direction) {
    if (seen.cap.axis.dot(direction) < least) return false;
    Summary& summary = summaries_[entry];
    summary.low = std::min(summary.low, low);
    summary.high = std::max(summary.high, high);
    return true;
  });
}

NearFaces::Near NearFaces::near(const Vec3& x) const {
  Near common;
  common.range = {0.0, kInfinity};
  if (x.isZero(0.0)) return common;
  const Stencil stencil = index_.grid().stencil(x);
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    const Summary& summary = summaries_[stencil.entry[k]];
    common.range.low = std::max(common.range.low, static_cast<double>(summary.low));
    common.range.high = std::min(common.range.high, static_cast<double>(summary.high));
    common.rim = common.rim && summary.rim;
  }
  common.faces = index_.shortest(stencil);
  return common;
}

double NearFaces::radius(const Vec3& u, Layer layer) const { return radius(u, near(u), layer); }

double NearFaces::radius_bound(const Vec3& u, Layer layer) const {
  const bool nearest = layer == Layer::nearest;
  const Eigen::Vector3f at = u.cast<float>();
  float decisive = nearest ? 0.0F : HUGE_VALF;  // the least or largest 1 / radius
  bool any = false;
  for (const std::uint32_t f : index_.shortest(index_.grid().stencil(u))) {
    const Cap& cap = caps_[f];
    if (cap.axis.dot(u) < cap.cosine) continue;
    const float inverse = cap.plane[0] * at[0] + cap.plane[1] * at[1] + cap.plane[2] * at[2];
    decisive = nearest ? std::max(decisive, inverse + cap.slack) : std::min(decisive, inverse - cap.slack);
    any = true;
  }
  if (!any) return nearest ? kInfinity : -kInfinity;
  return nearest || decisive > 0.0F ? 1.0 / static_cast<double>(decisive) : kInfinity;
}

double NearFaces::radius(const Vec3& u, const Near& near, Layer layer) const {
  double radius = kNoSurface;
  for (const std::uint32_t f : near.faces) {
    if (caps_[f].axis.dot(u) < caps_[f].cosine) continue;
    const Face& face = mesh_.faces[f];
    if (place_in_cone(corners_of(mesh_, face), caps_[f].side, u) < 0) continue;
    keep(radius, cone_of(mesh_, face).radius(u), layer);
  }
  return radius;
}

std::vector<JumpEdge> NearFaces::jumps_near(std::span<const Vec3> directions, double angle) const {
  std::vector<JumpEdge> found;
  if (jumps_.empty()) return found;
  const CubeGnomonic& grid = index_.grid();
  std::vector<bool> wanted(grid.size(), false);
  for (const Vec3& u : directions) wanted[grid.stencil(u).entry[0]] = true;
  for (const JumpEdge& edge : jumps_) {
    bool meets = false;
    index_.for_each_near(cone_of(mesh_, edge), grid.stencil_radius() + angle + kCapSlack,
                         [&](std::size_t entry, const Vec3&) { meets = meets || wanted[entry]; });
    if (meets) found.push_back(edge);
  }
  return found;
}

std::size_t NearFaces::bytes() const {
  return caps_.capacity() * sizeof(Cap) + summaries_.size() * sizeof(Summary) + index_.bytes() +
         jumps_.capacity() * sizeof(JumpEdge);
}

}  // namespace impinge
