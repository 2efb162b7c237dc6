// SPDX-License-Identifier: GPL-3.0-or-later
// The sampling scheme: which directions a table samples, and which of them a look-up reads. To add a scheme,
// add one file to sphere/schemes/; the build finds it, and every table, test, experiment and plot follows.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "sphere/triangle_cone.hpp"

namespace impinge {

/// The entries that an interpolation at one direction reads, with weights that are not negative and sum to 1,
/// and the cell (patch between entries) that holds the direction. Only the first `taps` places count.
struct Stencil {
  std::array<std::size_t, 4> entry{};  // the taps
  std::array<double, 4> weight{};      // of each tap
  std::size_t taps = 0;                // that count, at most 4
  std::size_t cell = 0;                // below cells()
};

/// Consecutive entries first, first + 1, ... with their directions, coordinate by coordinate, so that several
/// are tested at once. Scratch memory of a walker.
struct DirectionRun {
  static constexpr std::size_t kMost = 64;  // entries that a run has room for

  std::size_t first = 0;        // number of the first entry
  std::size_t count = 0;        // of entries in the run, at most kMost
  std::array<double, kMost> x;  // of the directions, as y and z
  std::array<double, kMost> y;
  std::array<double, kMost> z;

  Vec3 operator[](std::size_t k) const { return {x[k], y[k], z[k]}; }  // direction of entry first + k
};

/// Calls visit(run) for runs that make up the entries first .. first + count - 1; entry first + k has the
/// direction direction_of(k).
template <class DirectionOf, class Visit>
void visit_in_runs(std::size_t first, std::size_t count, DirectionOf&& direction_of, Visit&& visit) {
  DirectionRun run;
  for (std::size_t done = 0; done < count; done += run.count) {
    run.first = first + done;
    run.count = std::min(count - done, DirectionRun::kMost);
    for (std::size_t k = 0; k < run.count; ++k) {
      const Vec3 u = direction_of(done + k);
      run.x[k] = u.x();
      run.y[k] = u.y();
      run.z[k] = u.z();
    }
    visit(static_cast<const DirectionRun&>(run));
  }
}

/// Visitor of runs, used to state the concepts below.
struct RunVisitor {
  void operator()(const DirectionRun& run) const;  // takes a run; there is no body, as none is called
};

/// A scheme with a walker of its own:
///   walker()             finds the entries near triangles, as often as it is asked, by visit_near()
///   visit_near(cone, margin, visit)
///                        calls visit(run) for runs that hold every entry inside the cone or within `margin`
///                        radians of it, and perhaps some outside; each once, and with exactly the numbers
///                        of direction(i)
template <class S>
concept HasWalker = requires(const S scheme, const Vec3& x) {
  scheme.walker().visit_near(TriangleCone(x, x, x), 0.0, RunVisitor{});
};

/// A scheme with a member walker(), which must then satisfy HasWalker.
template <class S>
concept NamesWalker = requires(const S scheme) {
  scheme.walker();
};

/// A scheme is a regular value type of a few bytes.
///   name                 what the scheme is called in options, files and tables
///   label                the same for figures and text
///   citation             where the scheme is from
///   with_precision(d)    the scheme whose entries are d degrees apart at the equator; std::invalid_argument,
///                        one line that says why, if there is none
///   precision_deg()      how far entries are apart at the equator, degrees
///   size()               number of entries
///   cells()              number of cells
///   direction(i)         unit vector of entry i
///   stencil(x)           entries round the direction of x, x of any length above zero
///   covering_radius()    largest angle from any direction to its nearest entry, radians
///   stencil_radius()     largest angle from any direction to a tap of its stencil, radians
///   equator_points()     entries on the equator, or those nearest to it that stand for it
/// The radii are promised, never guessed: bounds are proven from them, and the tests hold them against brute
/// force. The direction of an entry must lead back to the entry, stencil(direction(i)) to tap i (or one in
/// the same direction) with the weight 1: an overset grid, whose parts overlap, is no SamplingScheme.
///
/// That is all that a scheme needs. What it may have besides:
///   walker()             finds entries faster than sphere/walker.hpp does for any scheme, see HasWalker
///   area(i)              see AreaScheme
///   depth(x), ...        see PlaneExactScheme: a table of inverse depths
///   meets_cells_once()   see HasKnownBorders: a rim takes out the cells that it crosses, and no more
///   patches_of(scheme)   see table/patches/patch.hpp: a tight bound on the error, not one of first order
/// A scheme whose stencils read entries beyond the cell that holds the direction must have
///   for_each_cell_across(stencil, visit)
///                        calls visit(other) for the stencils of all cells that read across the cell of
///                        `stencil`: they become rim cells with it
template <class S>
concept SamplingScheme = std::regular<S> &&
    (!NamesWalker<S> || HasWalker<S>)&&requires(const S scheme, double degrees, std::size_t i,
                                                const Vec3& x) {
  { S::name } -> std::convertible_to<std::string_view>;
  { S::label } -> std::convertible_to<std::string_view>;
  { S::citation } -> std::convertible_to<std::string_view>;
  { S::with_precision(degrees) } -> std::same_as<S>;
  { scheme.precision_deg() } -> std::same_as<double>;
  { scheme.size() } -> std::same_as<std::size_t>;
  { scheme.cells() } -> std::same_as<std::size_t>;
  { scheme.direction(i) } -> std::same_as<Vec3>;
  { scheme.stencil(x) } -> std::same_as<Stencil>;
  { scheme.covering_radius() } -> std::same_as<double>;
  { scheme.stencil_radius() } -> std::same_as<double>;
  { scheme.equator_points() } -> std::same_as<std::size_t>;
};

/// The scheme whose entries are `degrees` apart at the equator; std::nullopt if there is none, as for a grid
/// of angles whose step does not divide 180 degrees.
template <SamplingScheme S>
std::optional<S> scheme_of_precision(double degrees) {
  try {
    return S::with_precision(degrees);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// A scheme whose entries are points of a solid with flat faces round the centre, for InverseDepthTable:
///   depth(x)          largest n . x over the faces n . p = 1 of the solid, x of any length: x / depth(x) is
///                     the point of the solid in the direction of x
///   plane_stencil(x)  taps on the face of this point, with weights that are not negative and sum to 1 and
///                     make it the mean of the taps' points: x / depth(x) = sum w_i u_i / depth(u_i)
///   kFlatCells        needed, true or false: whether all cells are convex and bounded by great circles. Then
///                     stencil(x) has the same taps and cell; else plane_stencil(x) may take a neighbour if x
///                     is close to the border
template <class S>
concept PlaneExactScheme = SamplingScheme<S> && requires(const S scheme, const Vec3& x) {
  { scheme.depth(x) } -> std::same_as<double>;
  { scheme.plane_stencil(x) } -> std::same_as<Stencil>;
  { S::kFlatCells } -> std::convertible_to<bool>;
};

/// A scheme that tells how its cells are bounded, so that the rim of a surface takes out no more of them than
/// it crosses (table/rim.hpp). It has one of
///   kFlatCells               true: all cells are bounded by great circles and convex
///   meets_cells_once(a, b)   does the arc between two vectors, shorter than half a turn, surely meet every
///                            cell in one stretch at most? It must say yes for every arc that is short
///                            enough, except round single points. sphere/arc_borders.hpp helps.
/// In a table of any other scheme the entries beside a rim have no surface.
template <class S>
concept HasKnownBorders = requires(const S scheme, const Vec3& x) {
  { scheme.meets_cells_once(x, x) } -> std::same_as<bool>;
}
|| requires { requires S::kFlatCells; };

/// Does the arc from a to b, shorter than half a turn, surely meet every cell in one stretch at most?
template <HasKnownBorders S>
bool meets_cells_once(const S& scheme, const Vec3& a, const Vec3& b) {
  if constexpr (requires { scheme.meets_cells_once(a, b); }) {
    return scheme.meets_cells_once(a, b);
  } else {
    return true;
  }
}

/// A scheme that divides the sphere among its entries in closed form:
///   area(i)  solid angle that entry i stands for, steradians; the sum is 4 pi
template <class S>
concept AreaScheme = SamplingScheme<S> && requires(const S scheme, std::size_t i) {
  { scheme.area(i) } -> std::same_as<double>;
};

}  // namespace impinge
