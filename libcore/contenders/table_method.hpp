// SPDX-License-Identifier: GPL-3.0-or-later
// Any table as a method: radii or inverse depths, in double or stored in fewer bytes.
#pragma once

#include <utility>

#include "contenders/radius_method.hpp"

namespace impinge {

// Bytes of entries and rim mask.
template <class Table>
std::size_t table_bytes(const Table& table) {
  if constexpr (requires { table.bytes(); }) {
    return table.bytes();
  } else {
    return Table::bytes(table.scheme()) + table.rim_cells().bytes();
  }
}

template <class Table>
class TableMethod final : public RadiusMethod {
 public:
  explicit TableMethod(Table table) : table_(std::move(table)) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = table_.radius_at(points[i]);
  }

  double bytes() const override { return static_cast<double>(table_bytes(table_)); }

  double storage_bound() const override {
    if constexpr (requires { table_.storage_bound(); }) return table_.storage_bound();
    return 0.0;
  }

 private:
  Table table_;
};

}  // namespace impinge
