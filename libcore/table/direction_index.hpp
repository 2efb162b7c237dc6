// SPDX-License-Identifier: GPL-3.0-or-later
// Finds faces near a direction: it keeps a list of faces for each entry of a cube map. All look-ups of faces
// use it. The caller that fills it decides which faces count as near an entry, and may gather other data on
// the way.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "sphere/lists.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/walker.hpp"

namespace impinge {

class DirectionIndex {
 public:
  explicit DirectionIndex(const CubeGnomonic& grid) : grid_(grid), walker_(grid.walker()) {}

  /// Lists a face at the entries within `reach` radians of its cone for which take(entry, direction) holds.
  template <class Take>
  void add(std::size_t face, const TriangleCone& cone, double reach, Take&& take) {
    for_each_entry_near(walker_, cone, reach, [&](std::size_t entry, const Vec3& direction) {
      if (take(entry, direction))
        pairs_.push_back({static_cast<std::uint32_t>(entry), static_cast<std::uint32_t>(face)});
    });
  }
  /// To be called once, after all faces are added and before any list is read.
  void sort() { faces_ = Lists(grid_.size(), std::exchange(pairs_, {})); }

  const CubeGnomonic& grid() const { return grid_; }  // the cube map
  /// The faces of an entry, in the order in which they were added.
  std::span<const std::uint32_t> operator[](std::size_t entry) const { return faces_[entry]; }
  bool empty() const { return faces_.empty(); }         // no face is listed
  std::size_t bytes() const { return faces_.bytes(); }  // memory of the lists

  /// Calls visit(entry, direction) for the entries within `reach` radians of a cone, and perhaps others.
  template <class Visit>
  void for_each_near(const TriangleCone& cone, double reach, Visit&& visit) const {
    for_each_entry_near(walker_, cone, reach, visit);
  }
  /// The faces listed at the tap with the largest weight in the direction of x.
  std::span<const std::uint32_t> at_heaviest_tap(const Vec3& x) const {
    const Stencil stencil = grid_.stencil(x);
    const auto heaviest = std::ranges::max_element(stencil.weight);
    return faces_[stencil.entry[static_cast<std::size_t>(heaviest - stencil.weight.begin())]];
  }
  /// The shortest of the lists at the taps of a stencil.
  std::span<const std::uint32_t> shortest(const Stencil& stencil) const {
    std::span<const std::uint32_t> found = faces_[stencil.entry[0]];
    for (std::size_t k = 1; k < stencil.taps; ++k) {
      const auto here = faces_[stencil.entry[k]];
      found = here.size() < found.size() ? here : found;
    }
    return found;
  }

 private:
  CubeGnomonic grid_;
  CubeGnomonic::Walker walker_;
  std::deque<Lists::Pair> pairs_;  // entry and face, until they are sorted: no copy as it grows
  Lists faces_;
};

}  // namespace impinge
