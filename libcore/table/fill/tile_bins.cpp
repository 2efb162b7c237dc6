// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/fill/tile_bins.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "files/thread_team.hpp"

namespace impinge {
namespace {

constexpr double kLeastPlane = 1e-12;  // of a corner's distance: nearer planes pass through the centre

struct Meeting {
  std::uint32_t tile;
  std::uint32_t face;
};

// What one thread found.
struct Found {
  std::vector<Meeting> meetings;
  std::span<std::int8_t> sides;  // of all faces
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;

  void cover(const DepthRange& range) {
    least = std::min(least, range.least);
    most = std::max(most, range.most);
  }
};

// Depths from that of the farthest corner down to that of the plane. A face seen edge-on has none.
DepthRange unprojected_range(const TriangleMesh& mesh, const Face& face) {
  const TriangleCone cone = cone_of(mesh, face);
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0.0;
  for (const Vec3& corner : cone.corners()) {
    nearest = std::min(nearest, corner.norm());
    farthest = std::max(farthest, corner.cwiseAbs().maxCoeff());
  }
  if (cone.edge_on()) return {std::numeric_limits<double>::infinity(), 0.0};
  const double plane = cone.plane_distance();
  return {1.0 / farthest, std::numbers::sqrt3 / (plane > kLeastPlane * nearest ? plane : nearest)};
}

DepthRange seen_range(const CubeView& view, const Face& face, const SeenFace& seen) {
  return seen.projected ? range_of(seen, plane_of(seen, view.divisions()))
                        : unprojected_range(view.mesh(), face);
}

DepthRange range_of_corners(const CubeView& view, const Face& face) {
  const double a = view.corner(face[0]).q;
  const double b = view.corner(face[1]).q;
  const double c = view.corner(face[2]).q;
  return {std::min(std::min(a, b), c), std::max(std::max(a, b), c)};
}

void find_meetings(const CubeView& view, const CubeTiling& tiling, const Share& faces, Found& found) {
  found.meetings.reserve((faces.end - faces.first) * 3 / 2);
  for (std::size_t f = faces.first; f < faces.end; ++f) {
    const Face& face = view.mesh().faces[f];
    const auto meet = [&](std::size_t through, const GridWindow& window, auto&& range) {
      if (window.empty()) return;
      found.cover(range());
      tiling.for_each_seeing(through, window, [&](std::size_t tile) {
        found.meetings.push_back({static_cast<std::uint32_t>(tile), static_cast<std::uint32_t>(f)});
      });
    };
    if (view.inside_one(face)) {
      found.sides[f] =
          side_of({&view.corner(face[0]), &view.corner(face[1]), &view.corner(face[2])}, view.divisions());
      meet(view.corner(face[0]).face, view.window_inside(face), [&] { return range_of_corners(view, face); });
      continue;
    }
    for (unsigned left = view.may_be_seen(face); left != 0; left &= left - 1) {
      const auto through = static_cast<std::size_t>(std::countr_zero(left));
      const SeenFace seen = view.seen(face, through);
      meet(through, seen.window, [&] { return seen_range(view, face, seen); });
    }
  }
}

}  // namespace

TileBins tile_bins(const CubeView& view, const CubeTiling& tiling, std::size_t threads) {
  TileBins bins;
  bins.sides.resize(view.mesh().faces.size());
  std::vector<Found> found(threads);
  on_threads(threads, [&](std::size_t thread) {
    found[thread].sides = bins.sides;
    find_meetings(view, tiling, share_of(view.mesh().faces.size(), thread, threads), found[thread]);
  });
  bins.first.assign(tiling.size() + 1, 0);
  Found all;
  for (const Found& part : found) {
    all.cover({part.least, part.most});
    for (const Meeting& meeting : part.meetings) ++bins.first[meeting.tile + 1];
  }
  if (all.least <= all.most) bins.range = {all.least, all.most};
  for (std::size_t tile = 0; tile < tiling.size(); ++tile) bins.first[tile + 1] += bins.first[tile];
  bins.faces.resize(bins.first.back());
  std::vector<std::size_t> next(bins.first.begin(), bins.first.end() - 1);
  for (const Found& part : found)
    for (const Meeting& meeting : part.meetings) bins.faces[next[meeting.tile]++] = meeting.face;
  return bins;
}

}  // namespace impinge
