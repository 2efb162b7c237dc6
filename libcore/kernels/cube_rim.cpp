// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/cube_rim.hpp"

#include "sampling/rim.hpp"

namespace impinge {
namespace {

constexpr double kFloatShare = 0x1p-18;  // of a number: what float takes from it, see tile_triangle.hpp

// What mask_rim_along() asks of a table.
template <class Value>
class StoredRim {
 public:
  explicit StoredRim(const RimTask<Value>& task) : task_(task) {
    const double lost =
        kFloatShare + (task.table.smallest > 0.0 ? task.table.step / task.table.smallest : 0.0);
    nearer_to_a_jump_ = task.layer == Layer::nearest ? 1.0 + lost : 1.0 - lost;
  }

  const CubeGnomonic& scheme() const { return task_.scheme; }
  bool keeps(const Stencil& stencil) const { return !marked(stencil.entry[0]); }
  double radius_of(std::size_t entry) const {
    const auto& table = task_.table;
    const double q = table.smallest + table.step * static_cast<double>(table.values[entry]);
    return nearer_to_a_jump_ / (q * scheme().depth(scheme().direction(entry)));
  }
  bool is_rim_cell(std::size_t cell) const { return marked(entry_of(cell)); }
  void mark_rim_cell(std::size_t cell) {
    auto& table = task_.table;
    if (table.none.empty()) table.none.resize(table.values.size() / 32 + 1, 0U);
    const std::size_t entry = entry_of(cell);
    table.none[entry / 32] |= 1U << (entry % 32);
  }

 private:
  std::size_t entry_of(std::size_t cell) const {
    const std::size_t n = scheme().divisions();
    const std::size_t row = cell / n;  // of cells, over all faces
    return (row + row / n) * (n + 1) + cell % n;
  }
  bool marked(std::size_t entry) const {
    const auto& none = task_.table.none;
    return !none.empty() && (none[entry / 32] >> (entry % 32) & 1U) != 0U;
  }

  const RimTask<Value>& task_;
  double nearer_to_a_jump_ = 1.0;
};

}  // namespace

template <LaneValue Value>
void mark_rim(const RimTask<Value>& task, const std::vector<JumpEdge>& edges) {
  StoredRim<Value> rim(task);
  mask_rim_along(edges, task.mesh, task.layer, rim);
}

template void mark_rim(const RimTask<float>&, const std::vector<JumpEdge>&);
template void mark_rim(const RimTask<std::uint16_t>&, const std::vector<JumpEdge>&);

}  // namespace impinge
