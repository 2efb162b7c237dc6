// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a map over two angles as SVG, for volume and orientation: squares, named angles, marks and a key.
#pragma once

#include <string>
#include <string_view>

namespace impinge {

/// Grey for blocked, and other colours of the map.
inline constexpr std::string_view kMapBlocked = "#999";
inline constexpr std::string_view kMapUndecided = "#fff";
inline constexpr std::string_view kMapMark = "#d4006a";

/// The blue of a free share from 0 to 1; more is darker.
std::string free_shade(double share);

/// The angles that the map shows, in degrees; they grow to the right and upwards.
struct MapExtentShown {
  double left = 0.0;
  double right = 0.0;
  double bottom = 0.0;
  double top = 0.0;
  double scale = 1.0;       // units of the picture for one degree
  int step_across = 45;     // between named angles, from the left
  int step_up = 25;         // between named angles, from the bottom
  std::string_view beside;  // label on the left
};

/// A picture whose elements are drawn in the order of the calls.
class MapPicture {
 public:
  explicit MapPicture(const MapExtentShown& shown);

  /// Fills a rectangle whose lower left corner is at these angles.
  void rectangle(double across, double up, double width, double height, std::string_view fill);
  void square(double across, double up, double width, std::string_view fill) {
    rectangle(across, up, width, width, fill);
  }
  /// Adds SVG; x() and y() are the place of an angle.
  void add(std::string_view element) { svg_ += element; }
  double x(double across) const { return kMargin + (across - shown_.left) * shown_.scale; }
  double y(double up) const { return 10.0 + (shown_.top - up) * shown_.scale; }
  /// Writes the named angles.
  void name_angles();
  /// A mark of radius 2, a ring or a dot.
  void mark(double across, double up, bool ring);
  /// Writes a line below the map; the first is line 0.
  void words(int line, std::string_view text);
  /// Shows a colour and its meaning, at this distance from the left.
  void key(int line, double from_left, std::string_view fill, std::string_view text);

  std::string finished() const { return svg_ + "</svg>\n"; }

 private:
  static constexpr double kMargin = 30.0;
  double below(int line) const { return y(shown_.bottom) + 17.0 + 11.0 * line; }

  MapExtentShown shown_;
  std::string svg_;
};

}  // namespace impinge
