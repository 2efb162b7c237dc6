// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/fill/cube_rim.hpp"

#include <array>
#include <cmath>

#include "table/rim.hpp"

namespace impinge {
namespace {

constexpr double kFloatShare = 0x1p-18;  // of a number: what float takes from it, see tile_triangle.hpp

// What mask_doubtful() asks of a table, and the mask of its cells. A cell has the number of its first entry.
template <class Value>
class StoredRim {
 public:
  explicit StoredRim(const RimTask<Value>& task) : task_(task), side_(task.scheme.divisions() + 1) {
    const double lost =
        kFloatShare + (task.table.smallest > 0.0 ? task.table.step / task.table.smallest : 0.0);
    nearer_to_a_jump_ = task.layer == Layer::nearest ? 1.0 + lost : 1.0 - lost;
  }

  const CubeGnomonic& scheme() const { return task_.scheme; }
  double radius_of(std::size_t entry) const { return std::sqrt(squared_radius(entry)); }
  bool marked(std::size_t entry) const {
    const auto& none = task_.table.none;
    return !none.empty() && (none[entry / 32] >> (entry % 32) & 1U) != 0U;
  }
  void mark_rim_cell(std::size_t entry) {
    auto& table = task_.table;
    if (table.none.empty()) table.none.resize(table.values.size() / 32 + 1, 0U);
    table.none[entry / 32] |= 1U << (entry % 32);
  }

  // exp(2 change_to_be_seen()) of table/rim.hpp for an edge in the cell: all its corners have a surface.
  double squared_change(std::size_t entry, double squared_edge) const {
    const std::array taps{squared_radius(entry), squared_radius(entry + 1), squared_radius(entry + side_),
                          squared_radius(entry + side_ + 1)};
    return task_.layer == Layer::nearest ? squared_edge / std::ranges::max(taps)
                                         : std::ranges::min(taps) / squared_edge;
  }

  // mask_doubtful() would mark them again, and only takes longer.
  void drop_marked(std::vector<DoubtfulRim>& doubtful) const {
    std::erase_if(doubtful, [this](const DoubtfulRim& one) { return marked(one.reader.cell); });
  }
  // As a table's cell, for mask_doubtful().
  Stencil reader(std::size_t entry) const {
    return {{entry, entry + 1, entry + side_, entry + side_ + 1}, {}, 4, entry};
  }

 private:
  // |(1, a, b)| / q
  double squared_radius(std::size_t entry) const {
    const auto& table = task_.table;
    const double a = node(entry % side_);
    const double b = node(entry / side_ % side_);
    const double q = table.smallest + table.step * static_cast<double>(table.values[entry]);
    return nearer_to_a_jump_ * nearer_to_a_jump_ * (1.0 + a * a + b * b) / (q * q);
  }
  double node(std::size_t k) const {
    return 2.0 * static_cast<double>(k) / static_cast<double>(side_ - 1) - 1.0;
  }

  const RimTask<Value>& task_;
  std::size_t side_;  // entries along an edge of the cube
  double nearer_to_a_jump_ = 1.0;
};

// Marks the cells along one side of an edge where it may be seen; the others are put down as doubtful. It
// only saves time not to put down all of them: the faces at the edge are within the reach of every tap, so
// that mask_doubtful() marks what they make visible as well.
template <class Value>
void follow(const JumpEdge& edge, const RimLine& line, Layer layer, StoredRim<Value>& rim,
            std::vector<DoubtfulRim>& doubtful) {
  const double reach = rim.scheme().stencil_radius();
  const double most = std::exp(2.0 * edge.slope * reach);
  for_each_cell_along(rim.scheme(), line, [&](const Stencil& at, const Vec3& first, const Vec3& last) {
    const std::size_t entry = at.entry[0];
    if (rim.marked(entry)) return;
    const double radius = radius_to_be_seen(first, last, layer);
    const double change = rim.squared_change(entry, radius * radius);
    if (change <= most) {
      rim.mark_rim_cell(entry);
    } else {
      doubtful.push_back({rim.reader(entry), 0.5 * std::log(change) / reach});
    }
  });
}

// mark_rim(), in the unnamed namespace as what it captures is.
template <class Value>
void mark_all(const RimTask<Value>& task, const std::vector<JumpEdge>& edges) {
  StoredRim<Value> rim(task);
  std::vector<DoubtfulRim> doubtful;
  for_each_side(edges, task.mesh, [&](const JumpEdge& edge, const RimLine& line) {
    follow(edge, line, task.layer, rim, doubtful);
  });
  rim.drop_marked(doubtful);
  mask_doubtful(task.mesh, doubtful, rim);
}

}  // namespace

template <PackedValue Value>
void mark_rim(const RimTask<Value>& task, const std::vector<JumpEdge>& edges) {
  mark_all(task, edges);
}

template void mark_rim(const RimTask<float>&, const std::vector<JumpEdge>&);
template void mark_rim(const RimTask<std::uint16_t>&, const std::vector<JumpEdge>&);

}  // namespace impinge
