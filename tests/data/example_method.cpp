// SPDX-License-Identifier: GPL-3.0-or-later
// @can     touch
// @links   contact
//
// An example of a method, which e2e.add_scheme drops into experiments/methods/: the gap to the faces at every
// vertex.

#include <memory>

#include "contact/culled_joint.hpp"
#include "gap/surface.hpp"
#include "methods/method.hpp"

namespace impinge::lab {

Method example_method_method() {
  Method method{.name = "example_method", .label = "Example method"};
  method.lacks = "contacts of edges between vertices";
  method.touch = [](const BallSocketPair& pair, double /*precision_deg*/) {
    TouchCase one;
    one.gives_distance = true;
    one.touches = [&pair, joint = std::make_shared<CulledJoint>(pair)](const Pose& pose) {
      bool touching = false;
      for (const Surface scanned : kSurfaces) {
        for (const Vec3& x : mesh_of(pair, scanned).vertices)
          touching |= joint->gap(scanned, to_other(scanned, pose, x)) <= 0.0;
      }
      return touching;
    };
    return std::vector{one};
  };
  return method;
}

}  // namespace impinge::lab
