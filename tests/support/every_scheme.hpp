// SPDX-License-Identifier: GPL-3.0-or-later
// All schemes, or the one that IMPINGE_SCHEME names: how tests/check_scheme tries a new one alone.
#pragma once

#include <cstdlib>
#include <string_view>

#include "sphere/scheme_list.hpp"

namespace impinge::test {

// Calls visit.template operator()<S>() for each.
template <class Visit>
void every_scheme(Visit&& visit) {
  const char* only = std::getenv("IMPINGE_SCHEME");
  for_each_scheme([&]<class S>() {
    if (only == nullptr || std::string_view(only) == S::name) visit.template operator()<S>();
  });
}

}  // namespace impinge::test
