// SPDX-License-Identifier: GPL-3.0-or-later
// A map over two angles as SVG: squares, named angles, marks and a key. Volume and orientation are drawn so.
#pragma once

#include <string>
#include <string_view>

namespace impinge {

/// Grey, white and the pink of marks.
inline constexpr std::string_view kMapBlocked = "#999";
inline constexpr std::string_view kMapUndecided = "#fff";
inline constexpr std::string_view kMapMark = "#d4006a";

/// The blue of what is free, 0 to 1: the darker, the more of it.
std::string free_shade(double share);

/// Angles in degrees, which grow to the right and upwards.
struct MapExtentShown {
  double left = 0.0;
  double right = 0.0;
  double bottom = 0.0;
  double top = 0.0;
  double scale = 1.0;       // units of the picture a degree
  int step_across = 45;     // between angles that are named, from the left
  int step_up = 25;         // the same, from the bottom
  std::string_view beside;  // what is on the left
};

/// A picture that is drawn in the order of its calls.
class MapPicture {
 public:
  explicit MapPicture(const MapExtentShown& shown);

  /// From the corner at the least angles.
  void rectangle(double across, double up, double width, double height, std::string_view fill);
  void square(double across, double up, double width, std::string_view fill) {
    rectangle(across, up, width, width, fill);
  }
  /// Elements of SVG; x() and y() are where an angle is.
  void add(std::string_view element) { svg_ += element; }
  double x(double across) const { return kMargin + (across - shown_.left) * shown_.scale; }
  double y(double up) const { return 10.0 + (shown_.top - up) * shown_.scale; }
  /// The angles by name.
  void name_angles();
  /// A mark of radius 2, a ring or a dot.
  void mark(double across, double up, bool ring);
  /// A line of words below the map: the first is 0.
  void words(int line, std::string_view text);
  /// A colour and what it means, so far from the left.
  void key(int line, double from_left, std::string_view fill, std::string_view text);

  std::string finished() const { return svg_ + "</svg>\n"; }

 private:
  static constexpr double kMargin = 30.0;
  double below(int line) const { return y(shown_.bottom) + 17.0 + 11.0 * line; }

  MapExtentShown shown_;
  std::string svg_;
};

}  // namespace impinge
