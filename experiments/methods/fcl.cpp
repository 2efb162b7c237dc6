// SPDX-License-Identifier: GPL-3.0-or-later
// @can     touch contact steps
// @links   gap peer::fcl
//
// FCL's trees of boxes on both surfaces, one answer for a whole pose. fcl_obb and fcl_collide: oriented
// boxes, do the surfaces meet? One contact is asked for, without its depth, and ends the search. The thesis
// compares with RAPID (Gottschalk, Lin and Manocha 1996), which is not free software: its licence allows no
// commercial use. FCL is its kept descendant, from the same group, with the same tree. fcl_distance: boxes
// with a rectangle swept by a sphere inside, smallest distance, to the last digits (no tolerance is given
// away).

#include <algorithm>
#include <memory>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "methods/contact.hpp"

namespace impinge::lab {
namespace {

template <class Volume>
void fill(fcl::BVHModel<Volume>& model, const TriangleMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) triangles.emplace_back(face[0], face[1], face[2]);
  model.beginModel(static_cast<int>(mesh.faces.size()), static_cast<int>(mesh.vertices.size()));
  model.addSubModel(mesh.vertices, triangles);
  model.endModel();
}

template <class Volume>
struct Trees {
  explicit Trees(const BallSocketPair& pair) {
    fill(ball, pair.ball);
    fill(socket, pair.socket);
  }
  fcl::BVHModel<Volume> ball;
  fcl::BVHModel<Volume> socket;
};

// From the ball's frame to the socket's.
fcl::Transform3<double> placed(const Pose& pose) {
  fcl::Transform3<double> transform = fcl::Transform3<double>::Identity();
  transform.linear() = pose.rotation;
  transform.translation() = pose.translation;
  return transform;
}

Touch fcl_touch(const BallSocketPair& pair) {
  return [trees = std::make_shared<const Trees<fcl::OBB<double>>>(pair)](const Pose& pose) {
    const fcl::CollisionRequest<double> request(1, /*enable_contact_=*/false);
    fcl::CollisionResult<double> result;
    fcl::collide(&trees->ball, placed(pose), &trees->socket, fcl::Transform3<double>::Identity(), request,
                 result);
    return result.isCollision();
  };
}

// mm, 0 where they touch.
std::function<double(const Pose&)> smallest_distance(const BallSocketPair& pair) {
  return [trees = std::make_shared<const Trees<fcl::OBBRSS<double>>>(pair)](const Pose& pose) {
    const fcl::DistanceRequest<double> request;
    fcl::DistanceResult<double> result;
    return std::max(fcl::distance(&trees->ball, placed(pose), &trees->socket,
                                  fcl::Transform3<double>::Identity(), request, result),
                    0.0);
  };
}

}  // namespace

Method fcl_method() {
  Method method;
  method.touch = [](const BallSocketPair& pair, double /*precision_deg*/) {
    return std::vector{TouchCase{{"fcl_obb", "OBB tree (FCL)", "", 1}, fcl_touch(pair)}};
  };
  method.contact = [](const BallSocketPair& pair) {
    std::vector cases{touch_only("fcl_collide", "FCL, touch", 0, pair, fcl_touch),
                      ContactCase{{"fcl_distance", "FCL, distance", "", 1}}};
    cases[1].measure = Measure::euclidean;
    cases[1].few = true;
    cases[1].make = [&pair] {
      const auto distance = smallest_distance(pair);
      return ContactQuery{[distance](const Pose& pose) { return distance(pose) <= 0.0; }, {}, distance};
    };
    return cases;
  };
  method.steps = [](const BallSocketPair& pair) {
    return std::vector{touch_only("fcl_collide", "FCL", 0, pair, fcl_touch)};
  };
  return method;
}

}  // namespace impinge::lab
