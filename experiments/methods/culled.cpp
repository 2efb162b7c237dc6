// SPDX-License-Identifier: GPL-3.0-or-later
// @can     contact
// @links   contact
//
// Methods culled and culled_least_gap: touch and smallest gap without asking most vertices; coherent: touch,
// from one pose to the next.

#include <memory>

#include "contact/coherent_contact.hpp"
#include "methods/contact.hpp"

namespace impinge::lab {
namespace {

ContactCase culled_case(const char* name, const char* label, Touch touches) {
  ContactCase one;
  static_cast<Case&>(one) = {name, label, "", 3};
  one.touches = std::move(touches);
  one.contact = Contact::vertices;
  one.counted = true;
  return one;
}

std::vector<ContactCase> culled_cases(const CulledJoint& joint) {
  const auto coherent = std::make_shared<CoherentContact>(joint);
  std::vector cases{
      culled_case("culled", "touch, culled",
                  [&joint](const Pose& pose) { return joint.impinged(pose).has_value(); }),
      culled_case("coherent", "touch, culled, from pose to pose",
                  [coherent](const Pose& pose) { return coherent->impinged(pose).has_value(); }),
      culled_case("culled_least_gap", "smallest gap, culled", [&joint](const Pose& pose) {
        const auto least = joint.least_gap(pose);
        return least && least->gap_mm <= 0.0;
      })};
  cases.back().counted = false;
  return cases;
}

}  // namespace

Method culled_method() {
  Method method;
  method.contact = culled_cases;
  return method;
}

}  // namespace impinge::lab
