// SPDX-License-Identifier: GPL-3.0-or-later
// A scheme chosen by its name while the program runs.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "sphere/scheme_list.hpp"

namespace impinge {

/// Names of all schemes, with commas between.
inline std::string scheme_names() {
  std::string names;
  for_each_scheme([&names]<class S>() { names += (names.empty() ? "" : ", ") + std::string(S::name); });
  return names;
}

/// Calls `use.template operator()<S>()` for the scheme of that name; std::invalid_argument that lists the
/// names if there is none.
template <class Use>
void with_scheme(std::string_view name, Use&& use) {
  bool found = false;
  for_each_scheme([&]<class S>() {
    if (S::name != name) return;
    found = true;
    use.template operator()<S>();
  });
  if (!found)
    throw std::invalid_argument("unknown scheme '" + std::string(name) + "'; there are " + scheme_names());
}

}  // namespace impinge
