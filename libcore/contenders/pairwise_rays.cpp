// SPDX-License-Identifier: GPL-3.0-or-later
#include "contenders/pairwise_rays.hpp"

#include "contenders/heap_use.hpp"
#include "sampling/pairwise.hpp"

namespace impinge {
namespace {

class PairwiseRays final : public RadiusMethod {
 public:
  PairwiseRays(const TriangleMesh& mesh, Layer layer)
      : heap_before_(heap_bytes()), caster_(mesh), bytes_(heap_bytes() - heap_before_), layer_(layer) {}

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = caster_.cast(points[i].normalized(), layer_);
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

}  // namespace impinge
