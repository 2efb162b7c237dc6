// SPDX-License-Identifier: GPL-3.0-or-later
// Anything that gives the radius of a surface along a direction: a table, its faces. scan_gaps()
// (gap/gap_scan.hpp) takes any of them.
#pragma once

#include <concepts>
#include <cstddef>
#include <utility>

#include "sphere/radial_table.hpp"

namespace impinge {

/// radius_at(x): x of any length above zero; mm, kNoSurface where it has no answer. bytes(): of memory.
template <class Q>
concept RadialQuery = requires(const Q& query, const Vec3& x) {
  { query.radius_at(x) } -> std::convertible_to<double>;
  { query.bytes() } -> std::convertible_to<std::size_t>;
};

/// A RadialQuery that is chosen at run time.
class RadiusSource {
 public:
  RadiusSource() = default;
  RadiusSource(const RadiusSource&) = delete;
  RadiusSource& operator=(const RadiusSource&) = delete;
  virtual ~RadiusSource() = default;

  virtual double radius_at(const Vec3& x) const = 0;
  virtual std::size_t bytes() const = 0;    // of memory
  virtual std::size_t entries() const = 0;  // that were worked out
};

/// A table with every entry of its scheme.
template <SamplingScheme S>
class FullTable final : public RadiusSource {
 public:
  /// Takes a table that has been filled.
  explicit FullTable(RadialTable<S> table) : table_(std::move(table)) {}

  double radius_at(const Vec3& x) const override { return table_.radius_at(x); }
  std::size_t bytes() const override { return table_.bytes(); }
  std::size_t entries() const override { return table_.scheme().size(); }
  const RadialTable<S>& table() const { return table_; }  // as it was given

 private:
  RadialTable<S> table_;
};

}  // namespace impinge
