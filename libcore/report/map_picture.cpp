// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/map_picture.hpp"

#include "files/formatted.hpp"

namespace impinge {

std::string free_shade(double share) {
  const int light = 230 - static_cast<int>(180.0 * share);
  return formatted("rgb(%d,%d,%d)", light / 3, light, 235);
}

MapPicture::MapPicture(const MapExtentShown& shown) : shown_(shown) {
  svg_ = formatted(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %g\" font-family=\"sans-serif\" "
      "font-size=\"6\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
      x(shown.right) + 10.0, y(shown.bottom) + 50.0);
}

void MapPicture::rectangle(double across, double up, double width, double height, std::string_view fill) {
  svg_ += formatted("<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" fill=\"%s\"/>\n", x(across),
                    y(up + height), width * shown_.scale, height * shown_.scale, std::string(fill).c_str());
}

void MapPicture::name_angles() {
  for (double across = shown_.left; across <= shown_.right; across += shown_.step_across)
    svg_ += formatted("<text x=\"%g\" y=\"%g\" text-anchor=\"middle\">%g</text>\n", x(across),
                      y(shown_.bottom) + 8.0, across);
  for (double up = shown_.bottom; up <= shown_.top; up += shown_.step_up)
    svg_ +=
        formatted("<text x=\"%g\" y=\"%g\" text-anchor=\"end\">%g</text>\n", kMargin - 2.0, y(up) + 2.0, up);
  svg_ += formatted("<text transform=\"translate(7 %g) rotate(-90)\" text-anchor=\"middle\">%s</text>\n",
                    0.5 * (y(shown_.top) + y(shown_.bottom)), std::string(shown_.beside).c_str());
}

void MapPicture::mark(double across, double up, bool ring) {
  const std::string pink(kMapMark);
  svg_ += formatted("<circle cx=\"%g\" cy=\"%g\" r=\"2\" fill=\"%s\" stroke=\"%s\"/>\n", x(across), y(up),
                    ring ? "#fff" : pink.c_str(), pink.c_str());
}

void MapPicture::words(int line, std::string_view text) {
  svg_ += formatted("<text x=\"%g\" y=\"%g\">%s</text>\n", kMargin, below(line), std::string(text).c_str());
}

void MapPicture::key(int line, double from_left, std::string_view fill, std::string_view text) {
  svg_ += formatted(
      "<rect x=\"%g\" y=\"%g\" width=\"8\" height=\"6\" fill=\"%s\" stroke=\"#777\" stroke-width=\".4\"/>"
      "<text x=\"%g\" y=\"%g\">%s</text>\n",
      kMargin + from_left, below(line) - 5.0, std::string(fill).c_str(), kMargin + from_left + 10.0,
      below(line), std::string(text).c_str());
}

}  // namespace impinge
