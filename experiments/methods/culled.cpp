// SPDX-License-Identifier: GPL-3.0-or-later
// @can     contact
// @links   contact
//
// Overlap and smallest gap without looking at most vertices or faces. culled_faces: radial overlap of the
// surfaces, edges included, which is the filter of `impinge touch`; culled: overlap of the vertices;
// culled_least_gap: smallest gap of a vertex.

#include <memory>

#include "contact/culled_joint.hpp"
#include "contact/culled_overlay.hpp"
#include "methods/contact.hpp"
#include "sphere/infinity.hpp"

namespace impinge::lab {
namespace {

// A joint, and the overlay that tests it.
struct CulledFaces {
  explicit CulledFaces(const BallSocketPair& pair) : joint(pair), overlay(pair) {}
  CulledJoint joint;
  CulledOverlay overlay;
};

Touch touch_of_faces(const BallSocketPair& pair) {
  return [culled = std::make_shared<CulledFaces>(pair)](const Pose& pose) {
    return culled->overlay.impinged(pose, culled->joint);
  };
}

Touch touch_of_vertices(const BallSocketPair& pair) {
  return [joint = std::make_shared<const CulledJoint>(pair)](const Pose& pose) {
    return joint->impinged(pose).has_value();
  };
}

ContactQuery smallest_gap(const BallSocketPair& pair) {
  const auto joint = std::make_shared<const CulledJoint>(pair);
  const auto smallest = [joint](const Pose& pose) {
    const auto least = joint->least_gap(pose);
    return least ? least->gap_mm : kInfinity;
  };
  return {[smallest](const Pose& pose) { return smallest(pose) <= 0.0; }, {}, smallest};
}

std::vector<ContactCase> culled_cases(const BallSocketPair& pair) {
  std::vector cases{touch_only("culled_faces", "radial overlap, culled", 3, pair, touch_of_faces),
                    touch_only("culled", "touch of vertices, culled", 3, pair, touch_of_vertices),
                    ContactCase{{"culled_least_gap", "smallest gap, culled", "", 3},
                                [&pair] { return smallest_gap(pair); }}};
  for (ContactCase& one : cases)
    if (one.name != "culled_faces") one.contact = Contact::vertices;
  return cases;
}

}  // namespace

Method culled_method() {
  Method method;
  method.contact = culled_cases;
  return method;
}

}  // namespace impinge::lab
