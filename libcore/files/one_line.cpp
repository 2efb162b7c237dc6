// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/one_line.hpp"

#include <algorithm>

namespace impinge {

std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

}  // namespace impinge
