// SPDX-License-Identifier: GPL-3.0-or-later
// @can     contact turns
// @links   gap peer::bullet
//
// Method bullet_collide: trees of boxes along the axes on both surfaces (Bullet's GImpact), without a margin.
// It finds all contacts of a pair and cannot stop at the first. It works in float, so a verdict next to
// contact may differ from the exact one.
//
// For turns: bullet_convex is Bullet's conservative advancement of two convex hulls, here of up to three
// points each, in ten parts of the turn; bullet_collide tests poses in steps.

#include <memory>

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <btBulletCollisionCommon.h>

#include "methods/contact.hpp"
#include "methods/turns.hpp"

namespace impinge::lab {
namespace {

btVector3 in_float(const Vec3& x) {
  return {static_cast<btScalar>(x.x()), static_cast<btScalar>(x.y()), static_cast<btScalar>(x.z())};
}

btTransform placed(const Pose& pose) {
  btMatrix3x3 turn;
  for (int row = 0; row < 3; ++row) turn[row] = in_float(pose.rotation.row(row));
  return btTransform(turn, in_float(pose.translation));
}

std::vector<btVector3> vertices_of(const TriangleMesh& mesh) {
  std::vector<btVector3> vertices;
  for (const Vec3& v : mesh.vertices) vertices.push_back(in_float(v));
  return vertices;
}

std::vector<int> indices_of(const TriangleMesh& mesh) {
  std::vector<int> indices;
  for (const Face& face : mesh.faces)
    for (const VertexIndex v : face) indices.push_back(static_cast<int>(v));
  return indices;
}

// Bullet reads the vertices and indices in place.
struct Body {
  explicit Body(const TriangleMesh& mesh) : vertices(vertices_of(mesh)), indices(indices_of(mesh)) {
    shape.setMargin(0.0F);
    shape.updateBound();
    object.setCollisionShape(&shape);
  }
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  std::vector<btVector3> vertices;
  std::vector<int> indices;
  btTriangleIndexVertexArray triangles{
      static_cast<int>(indices.size() / 3), indices.data(),       3 * static_cast<int>(sizeof(int)),
      static_cast<int>(vertices.size()),    &vertices.front()[0], static_cast<int>(sizeof(btVector3))};
  btGImpactMeshShape shape{&triangles};
  btCollisionObject object;
  btCollisionObjectWrapper placed{nullptr, &shape, &object, object.getWorldTransform(), -1, -1};
};

// Notes whether there is a contact, and stores none.
class AnyContact : public btManifoldResult {
 public:
  using btManifoldResult::btManifoldResult;
  void addContactPoint(const btVector3&, const btVector3&, btScalar distance) override {
    hit = hit || distance <= 0.0F;
  }
  bool hit = false;
};

class Joint {
 public:
  explicit Joint(const BallSocketPair& pair) : ball_(pair.ball), socket_(pair.socket) {
    btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher_);
    algorithm_ =
        dispatcher_.findAlgorithm(&ball_.placed, &socket_.placed, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  }
  Joint(const Joint&) = delete;
  Joint& operator=(const Joint&) = delete;
  ~Joint() {
    algorithm_->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(algorithm_);
  }

  bool touches(const Pose& pose) {
    ball_.object.setWorldTransform(placed(pose));
    AnyContact contact(&ball_.placed, &socket_.placed);
    algorithm_->processCollision(&ball_.placed, &socket_.placed, step_, &contact);
    return contact.hit;
  }

 private:
  Body ball_;
  Body socket_;
  btDefaultCollisionConfiguration settings_;
  btCollisionDispatcher dispatcher_{&settings_};
  btDispatcherInfo step_;
  btCollisionAlgorithm* algorithm_ = nullptr;
};

Touch bullet_touch(const BallSocketPair& pair) {
  return [joint = std::make_shared<Joint>(pair)](const Pose& pose) { return joint->touches(pose); };
}

struct Hull {
  explicit Hull(const TriangleMesh& mesh) {
    for (const Vec3& x : corners_of(mesh, mesh.faces.front())) shape.addPoint(in_float(x));
    shape.setMargin(0.0F);
  }
  btConvexHullShape shape;
};

FindTurn of_hulls(const TurnQuery& query) {
  const auto turning = std::make_shared<const Hull>(query.turning);
  const auto resting = std::make_shared<const Hull>(query.resting);
  return [&query, turning, resting]() -> TurnAnswer {
    constexpr int kParts = 10;
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btContinuousConvexCollision cast(&turning->shape, &resting->shape, &simplex, &depth);
    const btTransform rest = btTransform::getIdentity();
    for (int k = 0; k < kParts; ++k) {
      btConvexCast::CastResult result;
      if (cast.calcTimeOfImpact(placed(turned_pose(query, query.largest * k / kParts)),
                                placed(turned_pose(query, query.largest * (k + 1) / kParts)), rest, rest,
                                result))
        return {query.largest * (k + static_cast<double>(result.m_fraction)) / kParts};
    }
    return {};
  };
}

FindTurn in_steps(const TurnQuery& query, double step) {
  const auto joint = std::make_shared<Joint>(BallSocketPair{query.turning, query.resting});
  return [&query, joint, step] {
    return stepped(
        query, [&](const Pose& pose) { return joint->touches(pose); }, step);
  };
}

}  // namespace

Method bullet_method() {
  Method method;
  method.contact = [](const BallSocketPair& pair) {
    ContactCase one = touch_only("bullet_collide", "Bullet (GImpact), touch", 2, pair, bullet_touch);
    one.few = true;
    return std::vector{one};
  };
  method.turns = [] {
    using enum TurnQuery::Kind;
    TurnCase convex{{"bullet_convex", "Bullet, convex advancement", "", 20},
                    {vertex_face, edge_edge, face_face}};
    convex.make = of_hulls;
    TurnCase steps{{"bullet_collide", "Bullet (GImpact)", "steps of 5 deg", 33}, {face_face, mesh}};
    steps.make = [](const TurnQuery& query) { return in_steps(query, 5.0 * kDegree); };
    return std::vector{convex, steps};
  };
  return method;
}

}  // namespace impinge::lab
