// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "files/formatted.hpp"
#include "hip/gap_levels.hpp"
#include "report/plots.hpp"
#include "report/svg.hpp"

namespace impinge {
namespace {

constexpr const char* kFaint = "#566472";
constexpr const char* kGrid = "#d5dce2";

std::string css(const Rgb& colour) { return formatted("#%02x%02x%02x", colour[0], colour[1], colour[2]); }

// 7.5 for "7:30".
double hours_of(const std::string& clock) {
  const std::size_t colon = clock.find(':');
  return std::fmod(std::stod(clock.substr(0, colon)) + std::stod(clock.substr(colon + 1)) / 60.0, 12.0);
}

// The unrolled clock runs from 6 over 9, 12 and 3 back to 6.
struct Across {
  double left = 40.0;
  double right = Svg::kWidth - 8.0;

  double at(double hours) const { return left + (right - left) * std::fmod(hours + 6.0, 12.0) / 12.0; }
};

void add_hours(Svg& svg, const Across& x, double y, double top) {
  constexpr const char* kNames[] = {"6", "7", "8", "9", "10", "11", "12", "1", "2", "3", "4", "5", "6"};
  for (int k = 0; k <= 12; ++k) {
    const double at = x.left + (x.right - x.left) * k / 12.0;
    svg.line(at, top, at, y, kGrid, k % 3 == 0 ? "" : "stroke-dasharray=\"2 3\"");
    svg.text(at, y + 12.0, kNames[k], {.anchor = "middle"});
  }
  const TextStyle soft{.size = 10, .anchor = "middle", .fill = kFaint};
  svg.text(x.at(9.0), y + 24.0, "posterior", soft);
  svg.text(x.at(0.0), y + 24.0, "superior, o'clock on the rim", soft);
  svg.text(x.at(3.0), y + 24.0, "anterior", soft);
  svg.text(x.left, y + 24.0, "inferior", {.size = 10, .fill = kFaint});
  svg.text(x.right, y + 24.0, "inferior", {.size = 10, .anchor = "end", .fill = kFaint});
}

std::string cell_colour(const ClockMap& map, std::size_t row, std::size_t column) {
  const std::size_t cell = row * ClockMap::kColumns + column;
  if (map.gap_mm[cell] == ClockMap::kAbsent) return "";
  return css(gap_colour(map.against_cartilage[cell], gap_levels(Surface::socket, map.touching)));
}

// Draws neighbouring cells of one colour as one.
void add_cells(Svg& svg, const ClockMap& map, const Across& x, double top, double high) {
  const double step = (x.right - x.left) / static_cast<double>(ClockMap::kColumns);
  const auto column_at = [](std::size_t k) { return (k + ClockMap::kColumns / 2) % ClockMap::kColumns; };
  for (std::size_t row = 0; row < map.rows; ++row) {
    const double y = top + high * static_cast<double>(map.rows - 1 - row);
    std::size_t k = 0;
    while (k < ClockMap::kColumns) {
      const std::string colour = cell_colour(map, row, column_at(k));
      const std::size_t first = k;
      while (k < ClockMap::kColumns && cell_colour(map, row, column_at(k)) == colour) ++k;
      if (!colour.empty())
        svg.rect(x.left + step * static_cast<double>(first), y, step * static_cast<double>(k - first), high,
                 colour, "shape-rendering=\"crispEdges\"");
    }
  }
}

// The smallest gap of each column.
std::vector<double> smallest_by_column(const ClockMap& map) {
  std::vector<double> smallest(ClockMap::kColumns, std::nan(""));
  for (std::size_t cell = 0; cell < map.gap_mm.size(); ++cell) {
    double& here = smallest[cell % ClockMap::kColumns];
    if (std::isfinite(map.gap_mm[cell]) && !(here <= map.gap_mm[cell])) here = map.gap_mm[cell];
  }
  return smallest;
}

void add_curve(Svg& svg, const ClockMap& map, const Across& x, double top, double height) {
  const std::vector<double> smallest = smallest_by_column(map);
  double low = 0.0;
  double high = 5.0;
  for (const double gap : smallest) {
    if (std::isfinite(gap)) low = std::min(low, std::floor(gap));
    if (std::isfinite(gap)) high = std::clamp(std::ceil(gap), high, 10.0);
  }
  const auto y = [&](double gap) {
    return top + height * (high - std::clamp(gap, low, high)) / (high - low);
  };
  for (double gap = low; gap <= high; gap += high - low > 6.0 ? 2.0 : 1.0) {
    svg.line(x.left, y(gap), x.right, y(gap), gap == 0.0 ? "#1b2530" : kGrid);
    svg.text(x.left - 4.0, y(gap) + 4.0, formatted("%g", gap), {.size = 10, .anchor = "end", .fill = kFaint});
  }
  std::string path;
  bool drawn = false;
  for (std::size_t k = 0; k < ClockMap::kColumns; ++k) {
    const std::size_t column = (k + ClockMap::kColumns / 2) % ClockMap::kColumns;
    const double gap = smallest[column];
    if (std::isfinite(gap))
      path += formatted("%c%.1f %.1f ", drawn ? 'L' : 'M', x.at(ClockMap::hours(column)), y(gap));
    drawn = std::isfinite(gap);
  }
  svg.add("<path d=\"" + path + "\" fill=\"none\" stroke=\"#1d4e7a\" stroke-width=\"1.8\"/>\n");
}

void add_zones(Svg& svg, const Json& zones, const Across& x, double y, std::string_view fill) {
  if (!zones.is_array()) return;
  for (const Json& zone : zones) {
    const double from = std::fmod(hours_of(zone["clock_from"]) + 6.0, 12.0);
    double to = std::fmod(hours_of(zone["clock_to"]) + 6.0, 12.0);
    if (to <= from) to += 12.0;
    const auto part = [&](double first, double last) {
      const double unit = (x.right - x.left) / 12.0;
      if (last > first) svg.rect(x.left + unit * first, y, unit * (last - first), 7.0, fill);
    };
    part(from, std::min(to, 12.0));
    part(0.0, to - 12.0);
  }
}

// Draws where each level is reached, the ball above the socket. Returns the lower end.
double add_levels(Svg& svg, const Json& gaps, const Across& x, double y) {
  for (const Json& level : gaps["impingement"]) {
    const bool bone = level["gap_up_to_mm"].is_number() && level["gap_up_to_mm"] == 0.0;
    const std::string what = bone ? "Gap of 0 mm or less"
                             : level["gap_up_to_mm"].is_number()
                                 ? formatted("Gap up to %g mm", level["gap_up_to_mm"].get<double>())
                                 : std::string("Within the cartilage of the map");
    svg.text(x.left, y + 10.0,
             what + formatted(": ball %.0f mm², socket %.0f mm²", level["ball"]["area_mm2"].get<double>(),
                              level["socket"]["area_mm2"].get<double>()));
    double at = y + 15.0;
    for (const char* surface : {"ball", "socket"}) {
      svg.text(x.left - 4.0, at + 7.0, surface, {.size = 10, .anchor = "end", .fill = kFaint});
      svg.rect(x.left, at, x.right - x.left, 7.0, "#eef2f5");
      add_zones(svg, level[surface]["clock_zones"], x, at, bone ? "#3b0f70" : "#f07f1c");
      at += 10.0;
    }
    y = at + 5.0;
  }
  return y;
}

// `by_map`: a map gives the thickness of the cartilage, and levels are shares of it (joint/gaps.hpp).
double add_legend(Svg& svg, const ClockMap& map, bool by_map, double y) {
  double x = 4.0;
  double before = 0.0;
  const auto entry = [&](const std::string& colour, const std::string& text) {
    svg.rect(x, y, 10.0, 10.0, colour);
    svg.text(x + 13.0, y + 9.0, text, {.size = 10});
    x += 24.0 + 5.6 * static_cast<double>(text.size());
  };
  for (const GapLevel& level : gap_levels(Surface::socket, map.touching)) {
    if (level.up_to_mm == 0.0)
      entry(css(level.colour), "0 or less");
    else if (std::isfinite(level.up_to_mm))
      entry(css(level.colour),
            by_map ? formatted("to %.0f %%", 100.0 * level.up_to_mm) : formatted("to %.1f", level.up_to_mm));
    else
      entry(css(level.colour),
            by_map ? formatted("over %.0f %%", 100.0 * before) : formatted("over %.1f mm", before));
    before = level.up_to_mm;
  }
  entry(css(kNoGapColour), "no bone opposite");
  return y + 16.0;
}

}  // namespace

std::string clock_plot(const ClockMap& map, const Json& gaps) {
  constexpr double kHigh = 5.0;
  constexpr double kCurve = 84.0;
  const Across x;
  Svg svg("Gaps of the socket by hour of the rim's clock and by angle from the socket's axis");
  svg.text(4.0, 12.0, "Angle from the socket's axis, degrees", {.size = 10, .fill = kFaint});
  const double top = 18.0;
  const double bottom = top + kHigh * static_cast<double>(map.rows);
  add_cells(svg, map, x, top, kHigh);
  for (double angle = 0.0; angle <= ClockMap::kRowDeg * static_cast<double>(map.rows); angle += 30.0) {
    const double y = bottom - kHigh * angle / ClockMap::kRowDeg;
    svg.line(x.left - 3.0, y, x.left, y, kFaint);
    svg.text(x.left - 5.0, y + 4.0, formatted("%g", angle), {.size = 10, .anchor = "end", .fill = kFaint});
  }
  const Json& smallest = gaps["smallest_gap"];
  add_hours(svg, x, bottom, top);
  const bool by_map = gaps["impingement"].back()["gap_up_to_mm"].is_null();
  double y = add_legend(svg, map, by_map, bottom + 34.0) + 14.0;
  svg.text(4.0, y, "Smallest gap at each hour, mm", {.size = 10, .fill = kFaint});
  y += 8.0;
  add_hours(svg, x, y + kCurve, y);
  add_curve(svg, map, x, y, kCurve);
  if (smallest.is_object() && smallest["clock"].is_string())
    svg.line(x.at(hours_of(smallest["clock"])), y, x.at(hours_of(smallest["clock"])), y + kCurve, "#d4006a",
             "stroke-width=\"1.5\" stroke-dasharray=\"4 2\"");
  y = add_levels(svg, gaps, x, y + kCurve + 32.0);
  return svg.text_of(y);
}

}  // namespace impinge
