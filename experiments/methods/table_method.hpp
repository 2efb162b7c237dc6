// SPDX-License-Identifier: GPL-3.0-or-later
// Any table as a method: radii or inverse depths, in double or stored in fewer bytes.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "methods/radius_method.hpp"

namespace impinge::lab {

// What a table keeps, entry by entry, in the order of its scheme.
struct StoredRadii {
  std::vector<Vec3> directions;  // unit
  std::vector<double> radii;     // mm, NaN where there is no surface
  double reach = 0.0;            // largest angle from a direction to an entry that its look-up reads, radians
};

// A method that keeps a table, to be looked at for itself.
class KeepsRadii {
 public:
  KeepsRadii() = default;
  KeepsRadii(const KeepsRadii&) = delete;
  KeepsRadii& operator=(const KeepsRadii&) = delete;
  virtual ~KeepsRadii() = default;

  virtual StoredRadii stored() const = 0;  // every entry of the table
};

template <class Table>
class TableMethod final : public RadiusMethod, public KeepsRadii {
 public:
  explicit TableMethod(Table table) : table_(std::move(table)) {}  // takes a table that has been filled

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = table_.radius_at(points[i]);
  }

  double bytes() const override { return static_cast<double>(table_.bytes()); }

  double storage_bound() const override {
    if constexpr (requires { table_.storage_bound(); }) return table_.storage_bound();
    return 0.0;
  }

  StoredRadii stored() const override {
    StoredRadii stored;
    stored.reach = table_.scheme().stencil_radius();
    for (std::size_t i = 0; i < table_.scheme().size(); ++i) {
      stored.directions.push_back(table_.scheme().direction(i));
      stored.radii.push_back(table_.radius_of(i));
    }
    return stored;
  }

 private:
  Table table_;
};

}  // namespace impinge::lab
