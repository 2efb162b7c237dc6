// SPDX-License-Identifier: GPL-3.0-or-later
#include "contenders/fcl_pose.hpp"

#include <algorithm>

#include <fcl/narrowphase/distance.h>

#include "contenders/fcl_model.hpp"
#include "contenders/fcl_obb.hpp"
#include "contenders/heap_use.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {
namespace {

class FclCollide final : public RadiusMethod {
 public:
  explicit FclCollide(const RaceScene& scene)
      : heap_before_(heap_bytes()),
        contender_(make_fcl_obb(scene.pair.ball, scene.pair.socket)),
        bytes_(heap_bytes() - heap_before_),
        pose_(scene.pose) {}

  void answer(std::span<const Vec3> /*points*/, std::span<double> out) override {
    out[0] = contender_->touches(pose_) ? 0.0 : kNoSurface;
  }
  double bytes() const override { return bytes_; }

 private:
  double heap_before_;
  std::unique_ptr<Contender> contender_;
  double bytes_;
  Pose pose_;
};

// Boxes with a rectangle swept by a sphere inside: FCL measures distances with the latter.
using SweptTree = fcl::BVHModel<fcl::OBBRSS<double>>;

class FclDistance final : public RadiusMethod {
 public:
  explicit FclDistance(const RaceScene& scene) : placed_(fcl_transform(scene.pose)) {
    const double before = heap_bytes();
    fill_fcl_model(ball_, scene.pair.ball);
    fill_fcl_model(socket_, scene.pair.socket);
    bytes_ = heap_bytes() - before;
  }

  void answer(std::span<const Vec3> /*points*/, std::span<double> out) override {
    const fcl::DistanceRequest<double> request;
    fcl::DistanceResult<double> result;
    const double distance =
        fcl::distance(&ball_, placed_, &socket_, fcl::Transform3<double>::Identity(), request, result);
    out[0] = std::max(distance, 0.0);
  }
  double bytes() const override { return bytes_; }

 private:
  SweptTree ball_;
  SweptTree socket_;
  fcl::Transform3<double> placed_;
  double bytes_ = 0.0;
};

}  // namespace

std::unique_ptr<RadiusMethod> make_fcl_collide(const RaceScene& scene) {
  return std::make_unique<FclCollide>(scene);
}

std::unique_ptr<RadiusMethod> make_fcl_distance(const RaceScene& scene) {
  return std::make_unique<FclDistance>(scene);
}

}  // namespace impinge
