// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Fills a table and bounds its error for a scheme of your own: this defines what exact_raster.hpp,
/// error_bound.hpp and table_bound.hpp declare. For the schemes of the library it is compiled once, in
/// own_scheme.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "mesh/lengths.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/walker.hpp"
#include "table/error_bound.hpp"
#include "table/exact_raster.hpp"
#include "table/patch_error.hpp"
#include "table/patches/patches.hpp"
#include "table/rim.hpp"
#include "table/surface_index.hpp"
#include "table/table_bound.hpp"
#include "table/table_interpolant.hpp"

namespace impinge {

template <SamplingScheme S>
RadialTable<S> fill_exact(const TriangleMesh& mesh, const S& scheme, Layer layer) {
  require_lengths(mesh);
  RadialTable<S> table(scheme);
  const auto radii = table.radii();
  const auto& walker = walker_of(scheme);
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (cone.edge_on()) continue;
    for_each_entry_inside(
        walker, cone, [&](std::size_t entry, const Vec3& u) { keep(radii[entry], cone.radius(u), layer); });
  }
  mask_rim(mesh, layer, table);
  return table;
}

template <SamplingScheme S>
std::vector<float> largest_slopes(const TriangleMesh& mesh, const S& scheme) {
  std::vector<float> slopes(scheme.size(), 0.0F);
  const auto& walker = walker_of(scheme);
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    const double slope = cone.edge_on() ? std::numeric_limits<double>::infinity() : cone.largest_slope();
    // The conversion to float may round down; one step up keeps the bound.
    const float safe = std::nextafter(static_cast<float>(slope), std::numeric_limits<float>::infinity());
    for_each_entry_near(walker, cone, scheme.stencil_radius(), [&](std::size_t entry, const Vec3&) {
      slopes[entry] = std::max(slopes[entry], safe);
    });
  }
  return slopes;
}

/// The search over the patches of one table.
template <class Interpolant>
class BoundSearch {
 public:
  /// Keeps references to interpolant and surface. `surface` must reach as far as the stencils of the table.
  BoundSearch(const Interpolant& interpolant, const SurfaceIndex& surface, const BoundOptions& options)
      : interpolant_(interpolant),
        surface_(surface),
        error_(surface, direction_doubt(interpolant.table().scheme())),
        options_(options) {}

  /// Runs the whole search. To be called once.
  TableBound run() {
    interpolant_.patches().for_each([this](const Patch& patch) { begin(patch); });
    result_.a_priori_mm = largest_bound();
    std::ranges::make_heap(open_, {}, &Node::bound);
    for (std::size_t step = 0; step < options_.budget && !open_.empty(); ++step) {
      if (open_.front().bound <= enough()) break;
      std::ranges::pop_heap(open_, {}, &Node::bound);
      const Node node = open_.back();
      open_.pop_back();
      halve(node);
    }
    result_.bound_mm = std::max(largest_bound(), result_.attained_mm);
    return result_;
  }

 private:
  struct Node {
    Patch patch;
    Rect rect;
    std::array<CornerSample, 4> corner;
    double bound;
    std::size_t split;
  };

  static constexpr std::size_t kMostOpen = 1U << 20U;
  static constexpr double kLeastShare = 1e-4;  // of a patch; a smaller rectangle is not halved

  double enough() const { return options_.tightness * result_.attained_mm; }
  double largest_bound() const {
    double largest = closed_;
    for (const Node& node : open_) largest = std::max(largest, node.bound);
    return largest;
  }

  void begin(const Patch& patch) {
    if (!interpolant_.answers(interpolant_.patches().at(patch, patch.rect.middle(0), patch.rect.middle(1))))
      return;
    Node node{patch, patch.rect, {}, 0.0, 0};
    for (std::size_t k = 0; k < 4; ++k) node.corner[k] = sample(patch, patch.rect, k);
    if (std::ranges::all_of(node.corner, [](const CornerSample& c) { return std::isnan(c.value); })) return;
    open(node);
    if (options_.of_cells != nullptr) note_bound_of_cell(node);
    if (node.bound > enough()) sample_middle(patch);
    if (open_.size() > kMostOpen) close_tight();
  }

  /// Notes the bound of a whole patch for its cell. The conversion to float may round down; one step up keeps
  /// the bound.
  void note_bound_of_cell(const Node& node) {
    const Vec3 middle = interpolant_.patches().at(node.patch, node.rect.middle(0), node.rect.middle(1));
    float& noted = (*options_.of_cells)[interpolant_.cell(middle)];
    noted = std::max(noted, std::nextafter(static_cast<float>(node.bound), HUGE_VALF));
  }

  /// Keeps a node for halving, or only its bound.
  void open(Node& node) {
    const PatchBound found = error_(view_of(node));
    node.bound = found.bound;
    node.split = found.split;
    const bool small = node.rect.width(0) < kLeastShare * node.patch.rect.width(0) ||
                       node.rect.width(1) < kLeastShare * node.patch.rect.width(1);
    if (found.tight || small || found.bound <= enough() || options_.budget == 0) {
      closed_ = std::max(closed_, found.bound);
    } else {
      open_.push_back(node);
    }
  }

  void close_tight() {
    std::erase_if(open_, [this](const Node& node) {
      if (node.bound > enough()) return false;
      closed_ = std::max(closed_, node.bound);
      return true;
    });
  }

  void halve(const Node& node) {
    const std::size_t k = node.split;
    const double middle = node.rect.middle(k);
    std::array<Node, 2> half{node, node};
    half[0].rect.to[k] = middle;
    half[1].rect.from[k] = middle;
    const std::array<std::size_t, 2> upper =
        k == 0 ? std::array<std::size_t, 2>{1, 3} : std::array<std::size_t, 2>{2, 3};
    const std::size_t step = k == 0 ? 1 : 2;
    for (const std::size_t corner : upper) {
      const CornerSample between = sample(node.patch, half[0].rect, corner);
      half[0].corner[corner] = between;
      half[1].corner[corner - step] = between;
    }
    for (Node& part : half) {
      if (std::ranges::all_of(part.corner, [](const CornerSample& c) { return std::isnan(c.value); }))
        continue;
      open(part);
      if (!open_.empty()) std::ranges::push_heap(open_, {}, &Node::bound);
    }
  }

  static double corner_of(const Rect& rect, std::size_t axis, std::size_t corner) {
    const bool upper = axis == 0 ? corner % 2 == 1 : corner / 2 == 1;
    return upper ? rect.to[axis] : rect.from[axis];
  }

  /// A corner of the rectangle, inside of the patch.
  Vec3 point(const Patch& patch, const Rect& rect, std::size_t corner) const {
    std::array<double, 2> place{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double inset = kCornerInset * patch.rect.width(axis);
      place[axis] = std::clamp(corner_of(rect, axis, corner), patch.rect.from[axis] + inset,
                               patch.rect.to[axis] - inset);
    }
    const Vec3 x = interpolant_.patches().at(patch, place[0], place[1]);
    return Interpolant::kFlat ? x : Vec3(x.normalized());
  }

  CornerSample sample(const Patch& patch, const Rect& rect, std::size_t corner) {
    return sample_at(point(patch, rect, corner));
  }
  void sample_middle(const Patch& patch) {
    const Vec3 x = interpolant_.patches().at(patch, patch.rect.middle(0), patch.rect.middle(1));
    sample_at(Interpolant::kFlat ? x : Vec3(x.normalized()));
  }

  CornerSample sample_at(const Vec3& x) {
    const double radius = surface_.radius(x.normalized());
    const double answer = interpolant_.table().radius_at(x);
    if (std::abs(answer - radius) > result_.attained_mm) {
      result_.attained_mm = std::abs(answer - radius);
      result_.witness = x.normalized();
    }
    return {interpolant_.value(x), Interpolant::kFlat ? x.norm() / radius : radius};
  }

  PatchView view_of(const Node& node) const {
    PatchView view;
    view.motion = interpolant_.patches().motion(node.patch, node.rect);
    view.corner = node.corner;
    for (std::size_t k = 0; k < 4; ++k) view.point[k] = point(node.patch, node.rect, k);
    const Vec3 middle = interpolant_.patches().at(node.patch, node.rect.middle(0), node.rect.middle(1));
    view.cap = {middle.normalized(), 0.5 * (view.motion.way[0] + view.motion.way[1]) * (1.0 + 1e-9) + 1e-12};
    interpolant_.tap_range(middle, view.least_tap, view.largest_tap);
    for (std::size_t k = 0; k < 2; ++k)
      view.inset[k] = kCornerInset * node.patch.rect.width(k) / node.rect.width(k);
    view.flat = Interpolant::kFlat;
    return view;
  }

  const Interpolant& interpolant_;
  const SurfaceIndex& surface_;
  PatchError error_;
  BoundOptions options_;
  TableBound result_;
  std::vector<Node> open_;
  double closed_ = 0.0;  // largest bound of the rectangles that are not halved any more
};

/// Makes bounds infinite that are above the largest radius of the mesh and say nothing, of cells too.
inline TableBound within_surface(const TriangleMesh& mesh, TableBound found,
                                 std::vector<float>* of_cells = nullptr) {
  double largest = 0.0;
  for (const Vec3& v : mesh.vertices) largest = std::max(largest, v.norm());
  if (found.bound_mm > largest) found.bound_mm = HUGE_VAL;
  if (found.a_priori_mm > largest) found.a_priori_mm = HUGE_VAL;
  if (of_cells == nullptr) return found;
  for (float& bound : *of_cells) {
    if (static_cast<double>(bound) > largest) bound = HUGE_VALF;
  }
  return found;
}

/// The bound of first order for any scheme (error_bound.hpp): the largest r_i (exp(T_i s) - 1) of all
/// entries.
template <SamplingScheme S>
TableBound first_order_bound(const TriangleMesh& mesh, const RadialTable<S>& table) {
  const std::vector<float> slopes = largest_slopes(mesh, table.scheme());
  const double reach = table.scheme().stencil_radius() + direction_doubt(table.scheme());
  TableBound result;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (std::isnan(table.radii()[i])) continue;
    result.bound_mm = std::max(result.bound_mm, table.radii()[i] * first_order_share(slopes[i], reach));
  }
  result.a_priori_mm = result.bound_mm;
  return within_surface(mesh, result);
}

/// The same for a table of inverse depths: the largest r_i (exp(T_i s) - cos s) of all entries, by Theorem 3
/// (slope).
template <PlaneExactScheme S>
TableBound first_order_bound(const TriangleMesh& mesh, const InverseDepthTable<S>& table) {
  const S& scheme = table.scheme();
  const std::vector<float> slopes = largest_slopes(mesh, scheme);
  const double reach = scheme.stencil_radius() + direction_doubt(scheme);
  const double beside = 1.0 - std::cos(reach);
  TableBound result;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const double inverse = table.values()[i];
    if (std::isnan(inverse)) continue;
    const double radius = 1.0 / (inverse * scheme.depth(scheme.direction(i)));
    result.bound_mm = std::max(result.bound_mm, radius * (first_order_share(slopes[i], reach) + beside));
  }
  result.a_priori_mm = result.bound_mm;
  return within_surface(mesh, result);
}

template <SamplingScheme S>
TableBound table_bound(const TriangleMesh& mesh, const RadialTable<S>& table, Layer layer,
                       const BoundOptions& options) {
  if constexpr (HasPatches<S>) {
    const SurfaceIndex surface(mesh, layer, table.scheme().stencil_radius());
    const auto patches = patches_of(table.scheme());
    const SmoothInterpolant interpolant(table, patches);
    return within_surface(mesh, BoundSearch(interpolant, surface, options).run(), options.of_cells);
  } else {
    return first_order_bound(mesh, table);
  }
}

template <PlaneExactScheme S>
TableBound table_bound(const TriangleMesh& mesh, const InverseDepthTable<S>& table, Layer layer,
                       const BoundOptions& options) {
  if constexpr (HasFlatPatches<S>) {
    const SurfaceIndex surface(mesh, layer, table.scheme().stencil_radius());
    const auto patches = flat_patches_of(table.scheme());
    const PlaneExactInterpolant interpolant(table, patches);
    return within_surface(mesh, BoundSearch(interpolant, surface, options).run(), options.of_cells);
  } else {
    return first_order_bound(mesh, table);
  }
}

#define IMPINGE_OF_SCHEME(S)                                                                \
  extern template RadialTable<S> fill_exact(const TriangleMesh&, const S&, Layer);          \
  extern template std::vector<float> largest_slopes(const TriangleMesh&, const S&);         \
  extern template TableBound table_bound(const TriangleMesh&, const RadialTable<S>&, Layer, \
                                         const BoundOptions&);
IMPINGE_SCHEMES(IMPINGE_OF_SCHEME)
#undef IMPINGE_OF_SCHEME

}  // namespace impinge
