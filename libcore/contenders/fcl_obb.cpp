// SPDX-License-Identifier: GPL-3.0-or-later
#include "contenders/fcl_obb.hpp"

#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

namespace impinge {
namespace {

using BoxTree = fcl::BVHModel<fcl::OBB<double>>;

void build(BoxTree& tree, const TriangleMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) triangles.emplace_back(face[0], face[1], face[2]);
  tree.beginModel(static_cast<int>(mesh.faces.size()), static_cast<int>(mesh.vertices.size()));
  tree.addSubModel(mesh.vertices, triangles);
  tree.endModel();
}

class FclObb final : public Contender {
 public:
  FclObb(const TriangleMesh& ball, const TriangleMesh& socket) {
    build(ball_, ball);
    build(socket_, socket);
  }

  std::string_view name() const override { return "fcl_obb"; }
  bool gives_distance() const override { return false; }

  bool touches(const Pose& pose) override {
    fcl::Transform3<double> placed = fcl::Transform3<double>::Identity();
    placed.linear() = pose.rotation;
    placed.translation() = pose.translation;
    const fcl::CollisionRequest<double> request(1, /*enable_contact_=*/false);
    fcl::CollisionResult<double> result;
    fcl::collide(&ball_, placed, &socket_, fcl::Transform3<double>::Identity(), request, result);
    return result.isCollision();
  }

 private:
  BoxTree ball_;
  BoxTree socket_;
};

}  // namespace

std::unique_ptr<Contender> make_fcl_obb(const TriangleMesh& ball, const TriangleMesh& socket) {
  return std::make_unique<FclObb>(ball, socket);
}

}  // namespace impinge
