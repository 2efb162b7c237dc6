// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint sets of the numbers 0..n-1, in which each member is on one of two sides of its set.
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace impinge {

class DisjointSets {
 public:
  /// n sets of one member each.
  explicit DisjointSets(std::size_t n) : parent_(n), opposite_(n, false) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// The place of a member.
  struct Place {
    std::size_t root = 0;   // names the set
    bool opposite = false;  // on the other side of the set than the root
  };

  /// The set of `a`, and its side. Shortens the path for the next call.
  Place find(std::size_t a) {
    Place place{a, false};
    while (parent_[place.root] != place.root) {  // halve the path on the way
      const std::size_t parent = parent_[place.root];
      if (opposite_[parent]) opposite_[place.root] = !opposite_[place.root];
      parent_[place.root] = parent_[parent];
      place.opposite = place.opposite != opposite_[place.root];
      place.root = parent_[place.root];
    }
    return place;
  }

  /// Puts a and b in one set, on opposite sides or on the same. False if they are in one set already and its
  /// sides contradict this.
  bool join(std::size_t a, std::size_t b, bool opposite) {
    Place pa = find(a);
    Place pb = find(b);
    const bool roots_opposite = (pa.opposite != pb.opposite) != opposite;
    if (pa.root == pb.root) return !roots_opposite;
    if (pb.root < pa.root) std::swap(pa, pb);
    parent_[pb.root] = pa.root;
    opposite_[pb.root] = roots_opposite;
    return true;
  }

 private:
  std::vector<std::size_t> parent_;
  std::vector<bool> opposite_;  // on the other side of the set than the parent
};

}  // namespace impinge
