// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/fcl_obb.hpp"

#include <fcl/narrowphase/collision.h>

#include "methods/fcl_model.hpp"

namespace impinge::lab {
namespace {

using BoxTree = fcl::BVHModel<fcl::OBB<double>>;

class FclObb final : public TouchMethod {
 public:
  FclObb(const TriangleMesh& ball, const TriangleMesh& socket) {
    fill_fcl_model(ball_, ball);
    fill_fcl_model(socket_, socket);
  }

  std::string_view name() const override { return "fcl_obb"; }
  bool gives_distance() const override { return false; }

  bool touches(const Pose& pose) override {
    const fcl::CollisionRequest<double> request(1, /*enable_contact_=*/false);
    fcl::CollisionResult<double> result;
    fcl::collide(&ball_, fcl_transform(pose), &socket_, fcl::Transform3<double>::Identity(), request, result);
    return result.isCollision();
  }

 private:
  BoxTree ball_;
  BoxTree socket_;
};

}  // namespace

std::unique_ptr<TouchMethod> make_fcl_obb(const TriangleMesh& ball, const TriangleMesh& socket) {
  return std::make_unique<FclObb>(ball, socket);
}

}  // namespace impinge::lab
