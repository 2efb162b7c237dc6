// SPDX-License-Identifier: GPL-3.0-or-later
// One interface for every way to answer whether the ball touches the socket in a pose.
#pragma once

#include <string_view>

#include "gap/pose.hpp"

namespace impinge::lab {

class TouchMethod {
 public:
  TouchMethod() = default;
  TouchMethod(const TouchMethod&) = delete;
  TouchMethod& operator=(const TouchMethod&) = delete;
  virtual ~TouchMethod() = default;

  // Method name of the results; begins with the name of the library where there is one.
  virtual std::string_view name() const = 0;

  // Does the work for one answer also yield the distance between the surfaces, everywhere?
  virtual bool gives_distance() const = 0;

  // Do the surfaces meet in this pose? Not const: a method may keep its scratch memory between poses.
  virtual bool touches(const Pose& pose) = 0;
};

}  // namespace impinge::lab
