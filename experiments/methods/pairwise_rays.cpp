// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/pairwise_rays.hpp"

#include <cmath>

#include "methods/heap_use.hpp"
#include "table/pairwise.hpp"

namespace impinge::lab {
namespace {

constexpr double kUnitRounding = 8.0 * 0x1p-53;

class PairwiseRays final : public RadiusMethod {
 public:
  PairwiseRays(const TriangleMesh& mesh, Layer layer)
      : heap_before_(heap_bytes()), caster_(mesh), bytes_(heap_bytes() - heap_before_), layer_(layer) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      // Normalised once more a unit vector may move by an ulp, over the edge that it goes through.
      const Vec3& x = points[i];
      const bool is_unit = std::abs(x.squaredNorm() - 1.0) < kUnitRounding;
      out[i] = caster_.cast(is_unit ? x : x.normalized(), layer_);
    }
  }
  double bytes() const override { return bytes_; }

 private:
  double heap_before_;
  RayCaster caster_;
  double bytes_;
  Layer layer_;
};

}  // namespace

std::unique_ptr<RadiusMethod> make_pairwise_rays(const TriangleMesh& mesh, Layer layer) {
  return std::make_unique<PairwiseRays>(mesh, layer);
}

}  // namespace impinge::lab
