// SPDX-License-Identifier: GPL-3.0-or-later
// All schemes, or the one for which tests/check_scheme compiles a test.
#pragma once

#include <utility>

#include "sphere/scheme_list.hpp"

namespace impinge::test {

// Calls visit.template operator()<S>() for each.
template <class Visit>
void every_scheme(Visit&& visit) {
#ifdef IMPINGE_CHECKED_SCHEME
  visit.template operator()<IMPINGE_CHECKED_SCHEME>();
#else
  for_each_scheme(std::forward<Visit>(visit));
#endif
}

}  // namespace impinge::test
