// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/fcl_distance.hpp"

#include <algorithm>

#include <fcl/narrowphase/distance.h>

#include "methods/fcl_model.hpp"

namespace impinge::lab {

struct FclDistance::Trees {
  fcl::BVHModel<fcl::OBBRSS<double>> ball;
  fcl::BVHModel<fcl::OBBRSS<double>> socket;
};

FclDistance::FclDistance(const TriangleMesh& ball, const TriangleMesh& socket)
    : trees_(std::make_unique<Trees>()) {
  fill_fcl_model(trees_->ball, ball);
  fill_fcl_model(trees_->socket, socket);
}

FclDistance::~FclDistance() = default;

double FclDistance::distance(const Pose& pose) const {
  const fcl::DistanceRequest<double> request;
  fcl::DistanceResult<double> result;
  const double distance = fcl::distance(&trees_->ball, fcl_transform(pose), &trees_->socket,
                                        fcl::Transform3<double>::Identity(), request, result);
  return std::max(distance, 0.0);
}

}  // namespace impinge::lab
