// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/surface_index.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/edges.hpp"
#include "mesh/lengths.hpp"
#include "mesh/star_shape.hpp"
#include "sphere/infinity.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {
namespace {

constexpr double kSlack = 1e-12;  // of unit vectors and their products, far above their rounding

SurfacePlane plane_of(const TriangleCone& cone) {
  const FacePlane& face = cone.plane();
  SurfacePlane plane{.cone = cone};
  plane.slope = cone.edge_on() ? kInfinity : cone.largest_slope();
  plane.condition = kInfinity;
  for (const Vec3& x : cone.corners()) plane.largest_radius = std::max(plane.largest_radius, x.norm());
  if (face.offset > 0.0 && std::isfinite(plane.slope)) {
    plane.inverse = face.normal / face.offset;
    plane.distance = cone.plane_distance();
    plane.least_radius = plane.distance;
    plane.condition = face.size * plane.largest_radius / face.offset;
  }
  for (const Vec3& x : cone.corners()) plane.middle += x.normalized();
  plane.middle.normalize();
  // A cap of less than a quarter turn that holds the corners holds the face.
  for (const Vec3& x : cone.corners())
    plane.chord = std::max(plane.chord, (x.normalized() - plane.middle).norm());
  if (plane.chord > 1.0) plane.chord = 2.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 across = cone.side() * cone.corners()[k].cross(cone.corners()[(k + 1) % 3]);
    const double length = across.norm();
    plane.inward[k] = length > 0.0 ? Vec3(across / length) : Vec3::Zero();
  }
  return plane;
}

// Is one face beyond an edge of the other, by more than rounding? Faces that are seen edge-on overlap none.
bool clearly_apart(const SurfacePlane& a, const SurfacePlane& b) {
  if (a.cone.edge_on() || b.cone.edge_on()) return true;
  if ((a.middle - b.middle).norm() > a.chord + b.chord + kSlack) return true;
  const auto beyond_an_edge = [](const SurfacePlane& here, const SurfacePlane& there) {
    return std::ranges::any_of(here.inward, [&there](const Vec3& inward) {
      const double slack = kSlack * there.largest_radius;
      return std::ranges::all_of(there.cone.corners(), [&](const Vec3& x) { return inward.dot(x) < -slack; });
    });
  };
  return beyond_an_edge(a, b) || beyond_an_edge(b, a);
}

// Each level is for caps that much smaller than those of the level before.
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

// Values of each key in the order in which they come.
SurfaceIndex::Lists SurfaceIndex::gather(std::size_t count,
                                         const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  Lists lists;
  lists.first.assign(count + 1, 0);
  lists.value.resize(pairs.size());
  for (const auto& pair : pairs) ++lists.first[pair[0] + 1];
  for (std::size_t k = 0; k < count; ++k) lists.first[k + 1] += lists.first[k];
  std::vector<std::size_t> next(lists.first.begin(), lists.first.end() - 1);
  for (const auto& [key, value] : pairs) lists.value[next[key]++] = value;
  return lists;
}

void SurfaceIndex::find_planes(const TriangleMesh& mesh) {
  planes_.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) planes_.push_back(plane_of(cone_of(mesh, face)));
}

// Bins as wide as the caps.
SurfaceIndex::Level SurfaceIndex::make_level(double reach) const {
  const double divisions = std::clamp(std::round(2.0 / reach), 2.0, kMostBins);
  Level level{CubeGnomonic::with_precision(90.0 / divisions), reach, {}};
  std::vector<std::array<std::uint32_t, 2>> pairs;
  const auto& walker = level.bins.walker();
  // A direction's bin is its nearest tap, within the stencil radius of it.
  const double margin = (level.bins.stencil_radius() + reach) * (1.0 + 1e-9);
  for (std::size_t f = 0; f < planes_.size(); ++f) {
    walker.visit_near(planes_[f].cone, margin, [&](const DirectionRun& run) {
      for (std::size_t k = 0; k < run.count; ++k)
        pairs.push_back({static_cast<std::uint32_t>(run.first + k), static_cast<std::uint32_t>(f)});
    });
  }
  level.faces = gather(level.bins.size(), pairs);
  return level;
}

// Down to the size of the faces.
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

void SurfaceIndex::find_kinks(const TriangleMesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  const EdgeList list = edges(mesh);
  for (std::size_t e = 0; e < list.size(); ++e) {
    const auto sides = list[e];
    if (sides.size() < 2) continue;
    const auto [i, j] = ends(mesh, sides.front());
    const Vec3& from = mesh.vertices[i];
    const Vec3& to = mesh.vertices[j];
    const Vec3 cross = from.cross(to);
    if (cross.squaredNorm() == 0.0) continue;  // seen as a point
    const double line_distance = cross.norm() / (to - from).norm();
    Vec3 jump = Vec3::Zero();
    for (std::size_t a = 0; a < sides.size(); ++a) {
      for (std::size_t b = a + 1; b < sides.size(); ++b) {
        const Vec3 here = planes_[sides[a].face].inverse - planes_[sides[b].face].inverse;
        if (here.squaredNorm() > jump.squaredNorm()) jump = here;
      }
    }
    const auto number = static_cast<std::uint32_t>(kinks_.size());
    kinks_.push_back({cross.normalized(), from.normalized(), to.normalized(), jump,
                      line_distance * (1.0 - kSlack), std::max(from.norm(), to.norm()) * (1.0 + kSlack)});
    pairs.push_back({static_cast<std::uint32_t>(sides.front().face), number});
  }
  kinks_of_face_ = gather(planes_.size(), pairs);
}

// Two faces with a common direction are both in the bin of it.
void SurfaceIndex::find_overlaps() {
  const Level& level = levels_.back();
  const auto& walker = level.bins.walker();
  std::vector<std::array<std::uint32_t, 2>> pairs;
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
    walker.visit_near(planes_[a].cone, level.bins.stencil_radius(), [&](const DirectionRun& run) {
      for (std::size_t k = 0; k < run.count; ++k) {
        for (const std::uint32_t b : level.faces[run.first + k]) try_pair(a, b);
      }
    });
  }
  overlaps_of_face_ = gather(planes_.size(), pairs);
}

std::span<const std::uint32_t> SurfaceIndex::Level::near(const Vec3& u) const {
  const Stencil stencil = bins.stencil(u);
  const auto heaviest = std::ranges::max_element(stencil.weight);
  return faces[stencil.entry[static_cast<std::size_t>(heaviest - stencil.weight.begin())]];
}

std::span<const std::uint32_t> SurfaceIndex::kinks_of(std::uint32_t face) const {
  return kinks_of_face_[face];
}
std::span<const std::uint32_t> SurfaceIndex::overlaps_of(std::uint32_t face) const {
  return overlaps_of_face_[face];
}

double SurfaceIndex::radius(const Vec3& u) const {
  double radius = kNoSurface;
  for (const std::uint32_t f : levels_.back().near(u)) {
    const TriangleCone& cone = planes_[f].cone;
    if (cone.edge_on() || cone.least_edge_distance(u.x(), u.y(), u.z()) < -cone.doubt()) continue;
    if (cone.contains(u)) keep(radius, cone.radius(u), layer_);
  }
  return radius;
}

void SurfaceIndex::faces_near(const Cap& cap, std::vector<std::uint32_t>& found) const {
  found.clear();
  const double outside = -std::sin(std::min(cap.angle, 0.5 * kPi)) - kSlack;
  for (const std::uint32_t f : level_for(cap.angle).near(cap.axis)) {
    const auto& inward = planes_[f].inward;
    if (inward[0].dot(cap.axis) < outside || inward[1].dot(cap.axis) < outside ||
        inward[2].dot(cap.axis) < outside) {
      continue;
    }
    found.push_back(f);
  }
}

bool meets(const SurfaceKink& kink, const Cap& cap) {
  if (cap.angle >= 0.5 * kPi) return true;
  const double sine = std::sin(cap.angle) + kSlack;
  if (std::abs(kink.across.dot(cap.axis)) > sine) return false;
  const double cosine = std::cos(cap.angle) - kSlack;
  if (kink.from.dot(cap.axis) >= cosine || kink.to.dot(cap.axis) >= cosine) return true;
  // Is the point of the great circle nearest to the axis between the ends?
  return kink.across.cross(kink.from).dot(cap.axis) >= -kSlack &&
         kink.across.cross(kink.to).dot(cap.axis) <= kSlack;
}

PlaneRange range_within(const SurfacePlane& plane, const Cap& cap) {
  if (!std::isfinite(plane.slope)) return {0.0, plane.largest_radius, kInfinity};
  const double cosine = std::clamp(plane.inverse.dot(cap.axis) * plane.distance, -1.0, 1.0);
  const double psi = std::acos(cosine);
  const double steepest = psi + cap.angle + 1e-9;
  PlaneRange range{plane.least_radius, plane.largest_radius, plane.slope};
  if (psi > cap.angle)
    range.least =
        std::max(range.least, plane.distance / std::cos(std::min(psi - cap.angle, 0.5 * kPi - 1e-9)));
  range.least *= 1.0 - kSlack;
  if (steepest < 0.5 * kPi) {
    range.largest = std::min(range.largest, plane.distance / std::cos(steepest));
    range.slope = std::min(range.slope, std::tan(steepest));
  }
  range.largest *= 1.0 + kSlack;
  range.slope *= 1.0 + kSlack;
  return range;
}

}  // namespace impinge
