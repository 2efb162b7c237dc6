// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/working_tables.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "mesh/bodies.hpp"
#include "sphere/infinity.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/stored_table.hpp"
#include "table/error_bound.hpp"
#include "table/partial_table.hpp"

namespace impinge::lab {
namespace {

template <class S>
constexpr bool kIsWorking = std::same_as<S, Rsid> || std::same_as<S, Usid> || std::same_as<S, CubeGnomonic> ||
                            std::same_as<S, IcosahedralGnomonic>;

template <class S>
std::optional<S> working_scheme(double precision_deg) {
  try {
    return S::with_precision(precision_deg);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// How a table is read: its taps, and the answer from their radii.
struct Radii {
  static constexpr const char* kSuffix = "";
  template <class S>
  static Stencil taps(const S& scheme, const Vec3& x) {
    return scheme.stencil(x);
  }
  template <class S, class RadiusOf>
  static double answer(const S&, const Stencil& taps, const RadiusOf& radius_of, const Vec3&) {
    double sum = 0.0;
    for (std::size_t k = 0; k < taps.taps; ++k) {
      if (taps.weight[k] != 0.0) sum += taps.weight[k] * radius_of(taps.entry[k]);
    }
    return sum;
  }
  // Error of the answer, a mean of the taps: error_bound.hpp.
  static double share(double slope, double reach) { return first_order_share(slope, reach); }
};

struct InverseDepths {
  static constexpr const char* kSuffix = "_mesh_exact";
  template <class S>
  static Stencil taps(const S& scheme, const Vec3& x) {
    return scheme.plane_stencil(x);
  }
  template <class S, class RadiusOf>
  static double answer(const S& scheme, const Stencil& taps, const RadiusOf& radius_of, const Vec3& x) {
    double sum = 0.0;
    for (std::size_t k = 0; k < taps.taps; ++k) {
      if (taps.weight[k] == 0.0) continue;
      const double depth = scheme.depth(scheme.direction(taps.entry[k]));
      sum += taps.weight[k] / (radius_of(taps.entry[k]) * depth);
    }
    return (x / scheme.depth(x)).norm() / sum;
  }
  // The answer R is between cos s times the least tap and the largest tap, and the true radius between exp(-T
  // s) and exp(T s) times any tap: |R - r| <= R (exp(T s) / cos s - 1).
  static double share(double slope, double reach) {
    const double grown = first_order_share(slope, reach);
    return (1.0 + grown) / std::cos(std::min(reach, 1.0)) - 1.0;
  }
};

// A face as it is seen: the inward unit normals of the planes through its edges, and its largest tan psi.
struct SeenFace {
  explicit SeenFace(const TriangleCone& cone) : slope(cone.edge_on() ? kInfinity : cone.largest_slope()) {
    for (std::size_t k = 0; k < 3; ++k)
      inward[k] = (cone.corners()[k].cross(cone.corners()[(k + 1) % 3])).stableNormalized();
    if (cone.side() < 0) std::ranges::transform(inward, inward.begin(), std::negate{});
    if (!cone.edge_on()) return;
    // The plane of the face holds the centre: stay near that plane.
    const Vec3 across = inward[0].isZero() ? inward[1] : inward[0];
    inward = {across, -across, across};
  }
  // No direction of a convex cone within an angle of u is beyond a plane by more than the angle's sine.
  bool may_be_within(const Vec3& u, double sine) const {
    return std::ranges::all_of(inward, [&](const Vec3& n) { return n.dot(u) >= -sine; });
  }
  std::array<Vec3, 3> inward;
  double slope;
};

// Largest tan psi of the faces within `reach` radians of x, and perhaps of others.
double slope_near(const std::vector<SeenFace>& faces, const Vec3& x, double reach) {
  const Vec3 u = x.stableNormalized();
  const double sine = std::sin(std::min(reach, 1.5)) + 1e-12;
  double slope = 0.0;
  for (const SeenFace& face : faces) {
    if (face.may_be_within(u, sine)) slope = std::max(slope, face.slope);
  }
  return slope;
}

// Adds the entries that this way of reading needs.
template <class Way, class S>
void insert(const S& scheme, std::span<const Vec3> directions, EntrySet& entries) {
  for (const Vec3& x : directions) {
    const Stencil taps = Way::taps(scheme, x);
    for (std::size_t k = 0; k < taps.taps; ++k) entries.insert(taps.entry[k]);
  }
}

template <class Way, class S>
WorkingTable read(const S& scheme, double precision_deg, const PartialTable& table,
                  const std::vector<SeenFace>& seen, std::span<const Vec3> directions) {
  WorkingTable result{std::string(S::name) + Way::kSuffix, precision_deg, scheme.stencil_radius(), {}, {}};
  const double reach = scheme.stencil_radius() + direction_doubt(scheme);
  for (const Vec3& x : directions) {
    const Stencil taps = Way::taps(scheme, x);
    const bool rim = table.is_rim_cell(taps.cell) || table.is_rim_cell(scheme.stencil(x).cell);
    const double answer =
        rim ? kNoSurface
            : Way::answer(
                  scheme, taps, [&](std::size_t entry) { return table.radius_of(entry); }, x);
    result.answers.push_back(answer);
    // The path from x to a tap stays within the tap's reach, so only faces within twice the reach of x count.
    const double share = std::isnan(answer) ? 0.0 : Way::share(slope_near(seen, x, 2.0 * reach), reach);
    result.bounds.push_back(share > 1.0 ? kInfinity : answer * share);
  }
  return result;
}

}  // namespace

std::vector<WorkingTable> working_tables(const TriangleMesh& mesh, std::span<const Vec3> directions) {
  std::vector<SeenFace> seen;
  for (const Face& face : mesh.faces) seen.emplace_back(cone_of(mesh, face));
  const NearFaces faces(mesh, 0.0);
  std::vector<WorkingTable> tables;
  for (const double precision : kWorkingPrecisions) {
    for_each_scheme([&]<class S>() {
      if constexpr (!kIsWorking<S>) return;
      const std::optional<S> scheme = working_scheme<S>(precision);
      if (!scheme) return;
      EntrySet entries(scheme->size());
      insert<Radii>(*scheme, directions, entries);
      if constexpr (PlaneExactScheme<S>) insert<InverseDepths>(*scheme, directions, entries);
      entries.number();
      const PartialTable table =
          fill_partial(faces, AnyScheme(S::name, precision), std::move(entries), BenchmarkScene::kLayer);
      tables.push_back(read<Radii>(*scheme, precision, table, seen, directions));
      if constexpr (PlaneExactScheme<S>)
        tables.push_back(read<InverseDepths>(*scheme, precision, table, seen, directions));
    });
  }
  return tables;
}

std::vector<StabilityMethod> working_octahedra(double radius) {
  const double slope = std::sqrt(2.0);  // the largest tan psi of an octahedron
  std::vector<StabilityMethod> methods;
  for (const double precision : kWorkingPrecisions) {
    for_each_scheme([&]<class S>() {
      const std::optional<S> scheme = working_scheme<S>(precision);
      if (!scheme) return;
      StabilityMethod method;
      method.maker.name = S::name;
      method.maker.kind = "ours";
      method.maker.precision_deg = precision;
      method.maker.interpolant = "smooth";
      method.maker.make = [scheme = *scheme, radius] {
        return one_by_one(
            [scheme, radius](const Vec3& x) {
              const auto radius_of = [&](std::size_t entry) {
                return octahedron_mesh_radius(scheme.direction(entry), radius);
              };
              return Radii::answer(scheme, scheme.stencil(x), radius_of, x);
            },
            0.0);
      };
      const double reach = scheme->stencil_radius() + direction_doubt(*scheme);
      method.maker.bound = [=](const PointQuery&) {
        return MethodBound{radius * first_order_share(slope, reach)};
      };
      methods.push_back(std::move(method));
    });
  }
  return methods;
}

}  // namespace impinge::lab
