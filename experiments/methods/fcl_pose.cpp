// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/fcl_pose.hpp"

#include "methods/fcl_distance.hpp"
#include "methods/fcl_obb.hpp"
#include "methods/heap_use.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

class FclCollide final : public RadiusMethod {
 public:
  explicit FclCollide(const BenchmarkScene& scene)
      : heap_before_(heap_bytes()),
        method_(make_fcl_obb(scene.pair.ball, scene.pair.socket)),
        bytes_(heap_bytes() - heap_before_),
        pose_(scene.pose) {}

  void answer(std::span<const Vec3> /*points*/, std::span<double> out) override {
    out[0] = method_->touches(pose_) ? 0.0 : kNoSurface;
  }
  double bytes() const override { return bytes_; }

 private:
  double heap_before_;
  std::unique_ptr<TouchMethod> method_;
  double bytes_;
  Pose pose_;
};

class FclSmallest final : public RadiusMethod {
 public:
  explicit FclSmallest(const BenchmarkScene& scene)
      : heap_before_(heap_bytes()),
        distance_(scene.pair.ball, scene.pair.socket),
        bytes_(heap_bytes() - heap_before_),
        pose_(scene.pose) {}

  void answer(std::span<const Vec3> /*points*/, std::span<double> out) override {
    out[0] = distance_.distance(pose_);
  }
  double bytes() const override { return bytes_; }

 private:
  double heap_before_;
  FclDistance distance_;
  double bytes_;
  Pose pose_;
};

}  // namespace

std::unique_ptr<RadiusMethod> make_fcl_collide(const BenchmarkScene& scene) {
  return std::make_unique<FclCollide>(scene);
}

std::unique_ptr<RadiusMethod> make_fcl_distance(const BenchmarkScene& scene) {
  return std::make_unique<FclSmallest>(scene);
}

}  // namespace impinge::lab
