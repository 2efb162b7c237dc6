// SPDX-License-Identifier: GPL-3.0-or-later
// A scheme by the members that every scheme has, and none of those that it may have besides.
#pragma once

#include <cstddef>
#include <string_view>

#include "sphere/scheme.hpp"

namespace impinge::test {

// To be derived from, with a with_precision() of its own.
template <SamplingScheme S>
class Wrapped {
 public:
  static constexpr std::string_view name = "wrapped";
  static constexpr std::string_view label = "Wrapped";
  static constexpr std::string_view citation = "a test";

  double precision_deg() const { return held_.precision_deg(); }
  std::size_t size() const { return held_.size(); }
  std::size_t cells() const { return held_.cells(); }
  Vec3 direction(std::size_t entry) const { return held_.direction(entry); }
  Stencil stencil(const Vec3& x) const { return held_.stencil(x); }
  double covering_radius() const { return held_.covering_radius(); }
  double stencil_radius() const { return held_.stencil_radius(); }
  std::size_t equator_points() const { return held_.equator_points(); }
  friend bool operator==(const Wrapped&, const Wrapped&) = default;

 protected:
  void hold(const S& scheme) { held_ = scheme; }  // from now on

 private:
  S held_;
};

}  // namespace impinge::test
