// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/unpaired_edges.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

#include "mesh/edges.hpp"

namespace impinge {
namespace {

constexpr std::size_t kAtOnce = 4;  // so many edges of a vertex are compared without a loop; three are usual
// Up to so many edges of a vertex are gone through for each of them. Edges of the hub of a larger fan count
// as unpaired, so that the time stays linear.
constexpr std::size_t kMostGoneThrough = 64;

// A side of a face in its direction, after faces of side -1 are turned round.
struct Run {
  VertexIndex from, to;

  bool upwards() const { return from < to; }
};

// The upper ends of the edges that run upwards; edges with the lower end v are at upper[first[v]] to
// upper[first[v + 1]]. The upper end is replaced by the lower end once the edge has met its partner.
struct Upwards {
  std::vector<std::uint32_t> first;
  std::vector<VertexIndex> upper;
};

template <class Visit>
void for_each_run(const TriangleMesh& mesh, std::span<const std::int8_t> sides, Visit&& visit) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (sides[f] == 0) continue;
    const auto [a, second, third] = mesh.faces[f];
    const VertexIndex b = sides[f] > 0 ? second : third;
    const VertexIndex c = sides[f] > 0 ? third : second;
    visit(Run{a, b});
    visit(Run{b, c});
    visit(Run{c, a});
  }
}

// Sorts the edges that run upwards by their lower ends, by counting.
Upwards upwards(const TriangleMesh& mesh, std::span<const std::int8_t> sides) {
  Upwards all;
  all.first.assign(mesh.vertices.size() + 2, 0);
  for_each_run(mesh, sides, [&](Run run) { all.first[run.from + 2] += run.upwards(); });
  for (std::size_t v = 2; v < all.first.size(); ++v) all.first[v] += all.first[v - 1];
  all.upper.resize(all.first.back() + kAtOnce);
  for_each_run(mesh, sides, [&](Run run) {
    if (run.upwards()) all.upper[all.first[run.from + 1]++] = run.to;
  });
  return all;
}

// Takes the one edge from `lower` to `upper`; false if there is none, more than one, or if there are too many
// edges to look.
bool take(VertexIndex lower, VertexIndex upper, Upwards& all) {
  const std::uint32_t first = all.first[lower];
  const std::uint32_t count = all.first[lower + 1] - first;
  VertexIndex* const own = all.upper.data() + first;
  unsigned hits = 0;
  for (unsigned k = 0; k < kAtOnce; ++k) hits |= own[k] == upper ? 1U << k : 0U;
  if (count <= kAtOnce) {
    hits &= (1U << count) - 1U;
    if (hits == 0 || (hits & (hits - 1U)) != 0) return false;
    own[std::countr_zero(hits)] = lower;
    return true;
  }
  if (count > kMostGoneThrough) return false;
  const std::span many(own, count);
  if (std::ranges::count(many, upper) != 1) return false;
  *std::ranges::find(many, upper) = lower;
  return true;
}

}  // namespace

std::vector<bool> unpaired_lower_ends(const TriangleMesh& mesh, std::span<const std::int8_t> sides) {
  require_countable_edges(mesh);
  std::vector<bool> unpaired(mesh.vertices.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (sides[f] != 0 || !has_three_corners(mesh, mesh.faces[f])) continue;
    for (std::size_t k = 0; k < 3; ++k) unpaired[std::ranges::min(ends(mesh, {f, k}))] = true;
  }
  Upwards all = upwards(mesh, sides);
  for_each_run(mesh, sides, [&](Run run) {
    if (!run.upwards() && !take(run.to, run.from, all)) unpaired[run.to] = true;
  });
  for (std::size_t v = 0; v < unpaired.size(); ++v)
    for (std::uint32_t e = all.first[v]; e < all.first[v + 1]; ++e)
      if (all.upper[e] != v) unpaired[v] = true;
  return unpaired;
}

}  // namespace impinge
