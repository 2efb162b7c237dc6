// SPDX-License-Identifier: GPL-3.0-or-later
// Something that knows the radius of a surface along a direction, whatever it is made of.
#pragma once

#include <cstddef>
#include <utility>

#include "table/exact_raster.hpp"

namespace impinge {

class RadiusSource {
 public:
  RadiusSource() = default;
  RadiusSource(const RadiusSource&) = delete;
  RadiusSource& operator=(const RadiusSource&) = delete;
  virtual ~RadiusSource() = default;

  /// x of any length above zero; mm, kNoSurface where it has no answer.
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
  /// Of radii and rim mask.
  std::size_t bytes() const override {
    return RadialTable<S>::bytes(table_.scheme()) + table_.rim_cells().bytes();
  }
  std::size_t entries() const override { return table_.scheme().size(); }
  const RadialTable<S>& table() const { return table_; }  // as it was given

 private:
  RadialTable<S> table_;
};

}  // namespace impinge
