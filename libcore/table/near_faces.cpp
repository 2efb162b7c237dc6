// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/near_faces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/star_shape.hpp"
#include "sphere/radial_table.hpp"
#include "table/face_grid.hpp"
#include "table/face_index.hpp"

namespace impinge {
namespace {

constexpr double kNearGridDeg = 10.0;  // degrees between entries of the grid
// tan psi beyond which the radius that a face is computed to have may be nearer than the slack allows: such a
// face may be anywhere before its farthest corner.
constexpr double kSteepSlope = 1e4;

}  // namespace

NearFaces::NearFaces(const TriangleMesh& mesh, double margin)
    : mesh_(mesh),
      margin_(margin),
      grid_(face_grid(mesh, kNearGridDeg)),
      reach_(grid_.stencil_radius() + margin + kCapSlack),
      summaries_(grid_.size()),
      jumps_(jump_edges(mesh)) {
  const auto walker = grid_.walker();
  std::vector<Listed> listed;
  caps_.reserve(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) see(f, walker, listed);
  sort(listed);
  for (const JumpEdge& edge : jumps_) {
    const Vec3& to = mesh.vertices[edge.to];
    walker.visit_near(TriangleCone(mesh.vertices[edge.from], to, to), reach_, [&](const DirectionRun& run) {
      for (std::size_t k = 0; k < run.count; ++k) summaries_[run.first + k].rim = true;
    });
  }
}

// Lists the face at the entries within reach of its cap.
void NearFaces::see(std::size_t f, const CubeGnomonic::Walker& walker, std::vector<Listed>& listed) {
  const TriangleCone cone = cone_of(mesh_, mesh_.faces[f]);
  FaceIndex::SeenFace seen = see_face(cone.corners());
  const bool small = seen.cap.radius < 0.5 * kPi;
  caps_.push_back({seen.cap.axis, small ? std::cos(seen.cap.radius) - kCapSlack : -1.0, seen.side});
  const double slope = cone.edge_on() ? std::numeric_limits<double>::infinity() : cone.largest_slope();
  seen.range.low = slope > kSteepSlope ? 0.0 : seen.range.low * (1.0 - kRangeSlack);
  seen.range.high *= 1.0 + kRangeSlack;
  constexpr float kFarthest = std::numeric_limits<float>::infinity();
  const float low = std::nextafter(static_cast<float>(seen.range.low), 0.0F);
  const float high = std::nextafter(static_cast<float>(seen.range.high), kFarthest);
  const float steepest = std::nextafter(static_cast<float>(slope), kFarthest);
  const double wide = seen.cap.radius + reach_;
  const double least = small && wide < kPi ? std::cos(wide) - kCapSlack : -2.0;
  walker.visit_near(cone, reach_, [&](const DirectionRun& run) {
    for (std::size_t k = 0; k < run.count; ++k) {
      if (seen.cap.axis.dot(run[k]) < least) continue;
      Summary& summary = summaries_[run.first + k];
      summary.slope = std::max(summary.slope, steepest);
      if (cone.edge_on()) continue;
      summary.low = std::min(summary.low, low);
      summary.high = std::max(summary.high, high);
      listed.emplace_back(static_cast<std::uint32_t>(run.first + k), static_cast<std::uint32_t>(f));
    }
  });
}

void NearFaces::sort(const std::vector<Listed>& listed) {
  first_.assign(grid_.size() + 2, 0);
  for (const auto& [entry, face] : listed) ++first_[entry + 2];
  for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
  faces_.resize(listed.size());
  for (const auto& [entry, face] : listed) faces_[first_[entry + 1]++] = face;
  first_.pop_back();
}

NearFaces::Near NearFaces::near(const Vec3& x) const {
  Near common;
  common.range = {0.0, std::numeric_limits<double>::infinity()};
  common.slope = std::numeric_limits<double>::infinity();
  if (x.isZero(0.0)) return common;
  const Stencil stencil = grid_.stencil(x);
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    const Summary& summary = summaries_[stencil.entry[k]];
    common.range.low = std::max(common.range.low, static_cast<double>(summary.low));
    common.range.high = std::min(common.range.high, static_cast<double>(summary.high));
    common.slope = std::min(common.slope, static_cast<double>(summary.slope));
    common.rim = common.rim && summary.rim;
  }
  common.faces = listed(stencil);
  return common;
}

std::span<const std::uint32_t> NearFaces::listed(const Stencil& stencil) const {
  std::size_t first = 0;
  std::size_t fewest = faces_.size() + 1;
  for (std::size_t k = 0; k < stencil.taps; ++k) {
    const std::size_t i = stencil.entry[k];
    const std::size_t count = first_[i + 1] - first_[i];
    first = count < fewest ? first_[i] : first;
    fewest = std::min(fewest, count);
  }
  return std::span(faces_).subspan(first, fewest);
}

double NearFaces::radius(const Vec3& u, Layer layer) const { return radius(u, near(u), layer); }

double NearFaces::radius(const Vec3& u, const Near& near, Layer layer) const {
  double radius = kNoSurface;
  for (const std::uint32_t f : near.faces) {
    if (caps_[f].axis.dot(u) < caps_[f].cosine) continue;
    const TriangleCone cone = cone_of(mesh_, mesh_.faces[f]);
    if (cone.contains(u)) keep(radius, cone.radius(u), layer);
  }
  return radius;
}

std::vector<JumpEdge> NearFaces::jumps_near(std::span<const Vec3> directions, double angle) const {
  std::vector<JumpEdge> found;
  if (jumps_.empty()) return found;
  std::vector<bool> wanted(grid_.size(), false);
  for (const Vec3& u : directions) wanted[grid_.stencil(u).entry[0]] = true;
  const auto walker = grid_.walker();
  for (const JumpEdge& edge : jumps_) {
    const Vec3& to = mesh_.vertices[edge.to];
    bool meets = false;
    const double reach = grid_.stencil_radius() + angle + kCapSlack;
    walker.visit_near(TriangleCone(mesh_.vertices[edge.from], to, to), reach, [&](const DirectionRun& run) {
      for (std::size_t k = 0; k < run.count; ++k) meets = meets || wanted[run.first + k];
    });
    if (meets) found.push_back(edge);
  }
  return found;
}

std::size_t NearFaces::bytes() const {
  return caps_.capacity() * sizeof(Cap) + summaries_.size() * sizeof(Summary) +
         first_.capacity() * sizeof(std::uint32_t) + faces_.capacity() * sizeof(std::uint32_t) +
         jumps_.capacity() * sizeof(JumpEdge);
}

}  // namespace impinge
