// SPDX-License-Identifier: GPL-3.0-or-later
// Random vectors that are the same whatever the compiler: the order in which it works out the arguments of a
// call is its own choice.
#pragma once

#include "sphere/direction.hpp"

namespace impinge::test {

template <class Distribution, class Engine>
Vec3 random_vector(Distribution& distribution, Engine& random) {
  const double z = distribution(random);
  const double y = distribution(random);
  const double x = distribution(random);
  return {x, y, z};
}

}  // namespace impinge::test
