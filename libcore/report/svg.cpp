// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/svg.hpp"

#include <algorithm>

#include "files/formatted.hpp"

namespace impinge {

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string spaced(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

void Svg::rect(double x, double y, double width, double height, std::string_view fill,
               std::string_view more) {
  body_ += formatted("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\" %s/>\n", x, y,
                     width, height, std::string(fill).c_str(), std::string(more).c_str());
}

void Svg::line(double x1, double y1, double x2, double y2, std::string_view stroke, std::string_view more) {
  body_ += formatted("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" %s/>\n", x1, y1, x2,
                     y2, std::string(stroke).c_str(), std::string(more).c_str());
}

void Svg::text(double x, double y, std::string_view text, const TextStyle& style) {
  body_ += formatted("<text x=\"%.1f\" y=\"%.1f\" font-size=\"%d\" text-anchor=\"%s\" fill=\"%s\"%s>", x, y,
                     style.size, style.anchor, style.fill, style.bold ? " font-weight=\"600\"" : "") +
           escaped(text) + "</text>\n";
}

std::string Svg::text_of(double height) const {
  return formatted(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" font-family=\"system-ui, "
             "sans-serif\" role=\"img\" aria-label=\"",
             kWidth, height) +
         escaped(label_) + "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" + body_ + "</svg>\n";
}

}  // namespace impinge
