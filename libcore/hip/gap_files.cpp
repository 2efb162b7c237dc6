// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/gap_files.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace impinge {
namespace {

void append_number(double number, std::string& text) {
  std::array<char, 32> buffer{};  // a double needs 24 characters
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  text.append(buffer.data(), end);
}

void append_lines(const GapsOfSurface& surface, std::string& text) {
  for (std::size_t i = 0; i < surface.gap.size(); ++i) {
    const Vec3& x = surface.places[i];
    text += std::string(name(surface.surface)) + ',' + std::to_string(i);
    for (const double number : {x.x(), x.y(), x.z(), surface.gap[i]}) {
      text += ',';
      if (!std::isnan(number)) append_number(number, text);
    }
    text += '\n';
  }
}

}  // namespace

std::string gaps_csv(const GapsOfSurface& ball, const GapsOfSurface& socket) {
  std::string text = "surface,vertex,x,y,z,gap_mm\n";
  append_lines(ball, text);
  append_lines(socket, text);
  return text;
}

}  // namespace impinge
