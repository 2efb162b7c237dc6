// SPDX-License-Identifier: GPL-3.0-or-later
// Text of HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace impinge {

/// The text with the characters replaced that HTML and SVG reserve.
std::string escaped(std::string_view text);

/// Turns "internal_rotation" into "internal rotation".
std::string spaced(std::string_view name);

/// How a text is placed.
struct TextStyle {
  int size = 11;
  const char* anchor = "start";
  const char* fill = "#1b2530";
  bool bold = false;
};

/// A drawing that can also be a file of its own. It is 480 units wide.
class Svg {
 public:
  static constexpr double kWidth = 480.0;

  /// `label` describes the drawing to readers who do not see it.
  explicit Svg(std::string_view label) : label_(label) {}

  void rect(double x, double y, double width, double height, std::string_view fill,
            std::string_view more = "");
  void line(double x1, double y1, double x2, double y2, std::string_view stroke, std::string_view more = "");
  void text(double x, double y, std::string_view text, const TextStyle& style = {});
  void add(std::string_view element) { body_ += element; }

  /// The whole drawing, with this height.
  std::string text_of(double height) const;

 private:
  std::string label_;
  std::string body_{};
};

}  // namespace impinge
