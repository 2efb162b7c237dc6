// SPDX-License-Identifier: GPL-3.0-or-later
// Text of HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace impinge {

/// As it may stand between tags and in attributes.
std::string escaped(std::string_view text);

/// "internal_rotation" as "internal rotation".
std::string spaced(std::string_view name);

/// Where a text stands.
struct TextStyle {
  int size = 11;
  const char* anchor = "start";
  const char* fill = "#1b2530";
  bool bold = false;
};

/// A drawing that also stands as a file of its own. Lengths are its units, 480 across.
class Svg {
 public:
  static constexpr double kWidth = 480.0;

  /// `label` says what it shows to those who do not see it.
  explicit Svg(std::string_view label) : label_(label) {}

  void rect(double x, double y, double width, double height, std::string_view fill,
            std::string_view more = "");
  void line(double x1, double y1, double x2, double y2, std::string_view stroke, std::string_view more = "");
  void text(double x, double y, std::string_view text, const TextStyle& style = {});
  void add(std::string_view element) { body_ += element; }

  /// All of it, so high.
  std::string text_of(double height) const;

 private:
  std::string label_;
  std::string body_{};
};

}  // namespace impinge
