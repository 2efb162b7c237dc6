// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/surface_index.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/lengths.hpp"
#include "mesh/star_shape.hpp"
#include "sphere/infinity.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {
namespace {

// Each level is for caps smaller by this factor than in the level before.
constexpr double kFiner = 0.25;
constexpr double kMostBins = 512.0;

}  // namespace

SurfaceIndex::SurfaceIndex(const TriangleMesh& mesh, Layer layer, double reach)
    : layer_(layer), reach_(reach) {
  require_lengths(mesh);
  find_planes(mesh);
  find_levels();
  find_kinks(mesh);
  find_overlaps();
}

void SurfaceIndex::find_planes(const TriangleMesh& mesh) {
  planes_.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) planes_.push_back(surface_plane(cone_of(mesh, face)));
}

// Makes a level whose bins are as wide as the caps.
SurfaceIndex::Level SurfaceIndex::make_level(double reach) const {
  const double divisions = std::clamp(std::round(2.0 / reach), 2.0, kMostBins);
  Level level{DirectionIndex(CubeGnomonic::with_precision(90.0 / divisions)), reach};
  // The bin of a direction is its heaviest tap, which is within the stencil radius.
  const double margin = (level.bins.grid().stencil_radius() + reach) * (1.0 + 1e-9);
  for (std::size_t f = 0; f < planes_.size(); ++f)
    level.bins.add(f, planes_[f].cone, margin, [](std::size_t, const Vec3&) { return true; });
  level.bins.sort();
  return level;
}

// Makes levels down to the size of the faces.
void SurfaceIndex::find_levels() {
  const double face = std::sqrt(4.0 * kPi / static_cast<double>(planes_.size() + 1));
  double reach = reach_;
  for (; reach * kFiner > 0.5 * face; reach *= kFiner) levels_.push_back(make_level(reach));
  levels_.push_back(make_level(reach));
  if (reach > 0.5 * face) levels_.push_back(make_level(0.5 * face));
}

const SurfaceIndex::Level& SurfaceIndex::level_for(double angle) const {
  std::size_t k = levels_.size() - 1;
  while (k > 0 && levels_[k].reach < angle) --k;
  return levels_[k];
}

// The largest difference of q between two of these faces.
Vec3 SurfaceIndex::largest_jump(std::span<const HalfEdge> sides) const {
  Vec3 jump = Vec3::Zero();
  for (std::size_t a = 0; a < sides.size(); ++a) {
    for (std::size_t b = a + 1; b < sides.size(); ++b) {
      const Vec3 here = planes_[sides[a].face].inverse - planes_[sides[b].face].inverse;
      if (here.squaredNorm() > jump.squaredNorm()) jump = here;
    }
  }
  return jump;
}

void SurfaceIndex::find_kinks(const TriangleMesh& mesh) {
  std::vector<Lists::Pair> pairs;
  const EdgeList list = edges(mesh);
  for (std::size_t e = 0; e < list.size(); ++e) {
    const auto sides = list[e];
    if (sides.size() < 2) continue;
    const auto [from, to] = ends(mesh, sides.front());
    const auto kink = surface_kink(mesh.vertices[from], mesh.vertices[to], largest_jump(sides));
    if (!kink) continue;
    pairs.push_back(
        {static_cast<std::uint32_t>(sides.front().face), static_cast<std::uint32_t>(kinks_.size())});
    kinks_.push_back(*kink);
  }
  kinks_of_face_ = Lists(planes_.size(), pairs);
}

// Two faces with a common direction are both in the bin of that direction.
void SurfaceIndex::find_overlaps() {
  const DirectionIndex& bins = levels_.back().bins;
  std::vector<Lists::Pair> pairs;
  std::vector<std::uint32_t> tried(planes_.size(), 0);  // the last face that this one was tried with
  const auto try_pair = [&](std::uint32_t a, std::uint32_t b) {
    if (b >= a || tried[b] == a) return;
    tried[b] = a;
    if (clearly_apart(planes_[a], planes_[b])) return;
    if (!cones_overlap(planes_[a].cone.corners(), planes_[b].cone.corners())) return;
    pairs.push_back({a, b});
    pairs.push_back({b, a});
  };
  for (std::uint32_t a = 1; a < planes_.size(); ++a) {
    bins.for_each_near(planes_[a].cone, bins.grid().stencil_radius(), [&](std::size_t entry, const Vec3&) {
      for (const std::uint32_t b : bins[entry]) try_pair(a, b);
    });
  }
  overlaps_of_face_ = Lists(planes_.size(), pairs);
}

double SurfaceIndex::radius(const Vec3& u) const {
  double radius = kNoSurface;
  for (const std::uint32_t f : levels_.back().bins.at_heaviest_tap(u)) {
    const TriangleCone& cone = planes_[f].cone;
    if (cone.edge_on() || cone.least_edge_distance(u.x(), u.y(), u.z()) < -cone.doubt()) continue;
    if (cone.contains(u)) keep(radius, cone.radius(u), layer_);
  }
  return radius;
}

void SurfaceIndex::faces_near(const DirectionCap& cap, std::vector<std::uint32_t>& found) const {
  found.clear();
  const double outside = -std::sin(std::min(cap.radius, 0.5 * kPi)) - kDirectionSlack;
  for (const std::uint32_t f : level_for(cap.radius).bins.at_heaviest_tap(cap.axis)) {
    const auto& inward = planes_[f].inward;
    if (inward[0].dot(cap.axis) < outside || inward[1].dot(cap.axis) < outside ||
        inward[2].dot(cap.axis) < outside) {
      continue;
    }
    found.push_back(f);
  }
}

}  // namespace impinge
