// SPDX-License-Identifier: GPL-3.0-or-later
#include "command/volume_picture.hpp"

#include <algorithm>

#include "files/formatted.hpp"
#include "joint/volume_map.hpp"

namespace impinge {
namespace {

// Of the map, a unit of the picture a degree.
constexpr int kStep = kMapStep;
constexpr int kExtension = kMapExtension;
constexpr int kFlexion = kMapFlexion;
constexpr int kAbduction = kMapAbduction;
constexpr int kMargin = 30;
constexpr double kDarkest = 120.0;  // degrees of rotation

// Of so many degrees of rotation, internal and external together.
std::string shade(double range) {
  const int light = 230 - static_cast<int>(180.0 * std::min(range, kDarkest) / kDarkest);
  return formatted("rgb(%d,%d,%d)", light / 3, light, 235);
}

// Colour of the pose.
std::string colour(const MotionVolume& volume, const Motion& pose, Side side) {
  const auto [state, range] = map_square(volume, pose, side);
  if (state == CellState::blocked) return "#999";
  return state == CellState::free ? shade(range) : "#fff";
}

// What the colours mean, from the place (x, y) to the right.
std::string key(int x, int y) {
  std::string svg = formatted(
      "<text x=\"%d\" y=\"%d\">rotation without contact, internal and external together, degrees:</text>\n",
      x, y);
  const auto add = [&](int place, const std::string& fill, const std::string& label) {
    svg += formatted(
        "<rect x=\"%d\" y=\"%d\" width=\"8\" height=\"6\" fill=\"%s\" stroke=\"#777\" stroke-width=\".4\"/>"
        "<text x=\"%d\" y=\"%d\">%s</text>\n",
        x + place, y + 4, fill.c_str(), x + place + 10, y + 9, label.c_str());
  };
  for (int k = 0; k <= 4; ++k) add(22 * k, shade(30.0 * k), std::to_string(30 * k) + (k == 4 ? "+" : ""));
  add(117, "#999", "blocked");
  add(153, "#fff", "undecided");
  return svg;
}

}  // namespace

std::string volume_picture(const MotionVolume& volume, Side side) {
  const int width = kFlexion - kExtension;
  const int height = 2 * kAbduction;
  std::string svg = formatted(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" font-family=\"sans-serif\" "
      "font-size=\"6\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
      width + kMargin + 10, height + 2 * kMargin);
  for (int abduction = kAbduction - kStep; abduction >= -kAbduction; abduction -= kStep) {
    for (int flexion = kExtension; flexion < kFlexion; flexion += kStep) {
      const Motion pose{flexion + 0.5 * kStep, abduction + 0.5 * kStep, 0.0};
      svg += formatted("<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"%s\"/>\n",
                       flexion - kExtension + kMargin, kAbduction - abduction - kStep + 10, kStep, kStep,
                       colour(volume, pose, side).c_str());
    }
  }
  for (int flexion = kExtension; flexion <= kFlexion; flexion += 45)
    svg += formatted("<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%d</text>\n",
                     flexion - kExtension + kMargin, height + 18, flexion);
  for (int abduction = -kAbduction; abduction <= kAbduction; abduction += 25)
    svg += formatted("<text x=\"%d\" y=\"%d\" text-anchor=\"end\">%d</text>\n", kMargin - 2,
                     kAbduction - abduction + 12, abduction);
  svg += formatted(
      "<circle cx=\"%d\" cy=\"%d\" r=\"2\" fill=\"#fff\" stroke=\"#d4006a\"/>\n<text x=\"%d\" "
      "y=\"%d\">flexion, "
      "degrees; the ring is the neutral pose</text>\n<text transform=\"translate(7 %d) rotate(-90)\" "
      "text-anchor=\"middle\">abduction, degrees</text>\n",
      kMargin - kExtension, kAbduction + 10, kMargin, height + 27, kAbduction + 10);
  svg += key(kMargin, height + 38) + "</svg>\n";
  return svg;
}

}  // namespace impinge
