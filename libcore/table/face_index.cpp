// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/face_index.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/star_shape.hpp"
#include "table/face_grid.hpp"

namespace impinge {
namespace {

constexpr double kIndexGridDeg = 15.0;  // degrees between entries of the grid
constexpr double kReach = 1.5;  // of the covering radius of the grid: most faces are looked up in one piece
constexpr double kRounding = 1e-12;  // of lengths, as a share

}  // namespace

FaceIndex::SeenFace see_face(const std::array<Vec3, 3>& corners) {
  FaceIndex::SeenFace seen;
  seen.side = orientation(corners[0], corners[1], corners[2]);
  seen.cap.axis = Vec3::Zero();
  for (const Vec3& v : corners) seen.cap.axis += v.stableNormalized();
  const double length = seen.cap.axis.norm();
  seen.cap.axis = length > 0.0 ? Vec3(seen.cap.axis / length) : Vec3::UnitZ();
  // x . axis is linear on the face and no larger than |x|, which is convex.
  for (const Vec3& v : corners) {
    seen.cap.radius = std::max(seen.cap.radius, v.isZero(0.0) ? kPi : angle_between(seen.cap.axis, v));
    seen.range.low = std::min(seen.range.low, seen.cap.axis.dot(v));
    seen.range.high = std::max(seen.range.high, v.norm());
  }
  seen.cap.radius += kCapSlack;
  seen.range.low = std::max(0.0, seen.range.low - kRounding * seen.range.high);
  seen.range.high *= 1.0 + kRounding;
  return seen;
}

FaceIndex::FaceIndex(const TriangleMesh& mesh)
    : grid_(face_grid(mesh, kIndexGridDeg)), reach_(kReach * grid_.covering_radius()), ranges_(grid_.size()) {
  faces_.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces)
    faces_.push_back(see_face({corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)}));
  list_faces(mesh);
}

void FaceIndex::list_faces(const TriangleMesh& mesh) {
  const auto& walker = grid_.walker();
  const double radius = grid_.stencil_radius() + reach_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;  // entry, face
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (faces_[f].side == 0) continue;
    const TriangleCone cone = cone_of(mesh, mesh.faces[f]);
    const FaceRange range(cone);
    walker.visit_near(cone, radius * (1.0 + 2.0 * kCapShare) + 2.0 * kCapSlack, [&](const DirectionRun& run) {
      for (std::size_t k = 0; k < run.count; ++k) {
        const auto part = range.in_cap({run[k], radius});
        if (!part) continue;
        ranges_[run.first + k].include(part->range.low);
        ranges_[run.first + k].include(part->range.high);
        found.emplace_back(static_cast<std::uint32_t>(run.first + k), static_cast<std::uint32_t>(f));
      }
    });
  }
  std::ranges::sort(found);
  first_.assign(grid_.size() + 1, 0);
  for (const auto& [entry, face] : found) {
    ++first_[entry + 1];
    listed_.push_back(face);
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

FaceIndex::Neighbours FaceIndex::near(const Vec3& x) const {
  const Stencil stencil = grid_.stencil(x);
  Neighbours common;
  std::size_t fewest = listed_.size() + 1;
  common.range = {0.0, std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    const std::size_t i = stencil.entry[k];
    const std::size_t count = first_[i + 1] - first_[i];
    common.range.low = std::max(common.range.low, ranges_[i].low);
    common.range.high = std::min(common.range.high, ranges_[i].high);
    if (count >= fewest) continue;
    fewest = count;
    common.faces = std::span(listed_).subspan(first_[i], count);
  }
  return common;
}

std::size_t FaceIndex::bytes() const {
  return faces_.size() * sizeof(SeenFace) + ranges_.size() * sizeof(RadiusRange) +
         first_.size() * sizeof(std::size_t) + listed_.size() * sizeof(std::uint32_t);
}

}  // namespace impinge
