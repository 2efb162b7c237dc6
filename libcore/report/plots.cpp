// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/plots.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "files/formatted.hpp"
#include "hip/named_motion.hpp"
#include "report/svg.hpp"

namespace impinge {
namespace {

constexpr const char* kSoft = "#566472";
constexpr const char* kBar = "#5b8db8";
constexpr const char* kUnsure = "#b4cade";
constexpr const char* kRange = "#1d4e7a";

// The axis of the range of motion.
struct AngleAxis {
  double left = 6.0;
  double right = Svg::kWidth - 10.0;
  double most = 150.0;

  double at(double angle) const { return left + (right - left) * std::clamp(angle, 0.0, most) / most; }
};

std::optional<double> number_in(const Json& object, const char* key) {
  return object[key].is_number() ? std::optional(object[key].get<double>()) : std::nullopt;
}

void add_bar(Svg& svg, const AngleAxis& x, const Json& limit, double y) {
  const double low = limit["low_deg"];
  const std::string state = limit["state"];
  svg.rect(x.left, y, x.right - x.left, 12.0, "#eef2f5");
  if (state == "unknown") svg.rect(x.at(low), y, x.right - x.at(low), 12.0, "url(#unknown)");
  const double sure = state == "limited" ? limit["centre_low_deg"].get<double>() : low;
  svg.rect(x.left, y, x.at(low) - x.left, 12.0, kUnsure);
  svg.rect(x.left, y, x.at(sure) - x.left, 12.0, kBar);
  if (low > x.most) svg.text(x.right - 3.0, y + 10.0, "›", {.anchor = "end", .fill = "#fff", .bold = true});
  if (state != "limited") return;
  const double from = limit["centre_low_deg"];
  const double to = number_in(limit, "centre_high_deg").value_or(x.most);
  const double middle = y + 6.0;
  svg.line(x.at(from), middle, x.at(to), middle, kRange, "stroke-width=\"2.5\"");
  for (const double end : {from, to})
    svg.line(x.at(end), y + 1.0, x.at(end), y + 11.0, kRange, "stroke-width=\"2\"");
}

// The limit, and its range over the error of the centre.
std::string end_words(const Json& limit) {
  if (limit["state"] != "limited") return reach_words(limit);
  const std::optional<double> high = number_in(limit, "centre_high_deg");
  return reach_words(limit) + "  (" + rounded_down(limit["centre_low_deg"], 0) + " to " +
         (high ? rounded_up(*high, 0) : std::string("?")) + ")";
}

// What meets, where, and whether the limit is in doubt.
std::string meeting_words(const Json& limit) {
  std::string text = limit["meets"].is_string() ? limit["meets"].get<std::string>() : "";
  if (limit["clock"].is_string())
    text += (text.empty() ? "" : ", ") + limit["clock"].get<std::string>() + " o'clock";
  const std::string what = limit["what"];
  if (const std::size_t at = what.find("sensitive to "); at != what.npos)
    text += (text.empty() ? "" : "; ") + what.substr(at, what.find(';', at) - at);
  return text;
}

// Mean and standard deviation as published, or those of a normal distribution with the published quartiles.
struct Spread {
  double mean = 0.0;
  double sd = 0.0;
};

std::optional<Spread> spread_of(const Json& row) {
  constexpr double kQuartiles = 1.349;  // standard deviations between the quartiles of a normal distribution
  if (row["published_mean"].is_number()) return Spread{row["published_mean"], row["published_sd"]};
  if (!row["published_median"].is_number()) return std::nullopt;
  const double apart =
      row["published_upper_quartile"].get<double>() - row["published_lower_quartile"].get<double>();
  return Spread{row["published_median"], apart / kQuartiles};
}

}  // namespace

std::string limits_plot(const Json& limits) {
  const std::vector<Json> rows = ball_limits(limits, false);
  AngleAxis x;
  double farthest = 0.0;
  for (const Json& row : rows) farthest = std::max(farthest, row["low_deg"].get<double>());
  x.most = std::clamp(30.0 * std::ceil((farthest + 5.0) / 30.0), 60.0, 180.0);
  Svg svg("How far each motion goes before bones meet, with its range over the centre of rotation");
  svg.add(
      "<pattern id=\"unknown\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\"><path d=\"M0 6L6 0\" "
      "stroke=\"#a7b3bd\"/></pattern>\n");
  double y = 6.0;
  for (const Json& row : rows) {
    svg.text(x.left, y + 10.0, motion_words(row["motion"]), {.size = 12, .bold = true});
    svg.text(x.right, y + 10.0, end_words(row), {.size = 12, .anchor = "end"});
    add_bar(svg, x, row, y + 15.0);
    svg.text(x.left, y + 38.0, meeting_words(row), {.size = 10, .fill = kSoft});
    y += 47.0;
  }
  for (double angle = 0.0; angle <= x.most; angle += 30.0) {
    svg.line(x.at(angle), y - 4.0, x.at(angle), y, kSoft);
    const char* const anchor = angle == 0.0 ? "start" : angle == x.most ? "end" : "middle";
    svg.text(x.at(angle), y + 11.0, formatted("%g°", angle), {.size = 10, .anchor = anchor, .fill = kSoft});
  }
  svg.text(
      x.left, y + 26.0,
      formatted(
          "Bar: free of contact. Line, and in brackets: the limit for any centre of rotation within %g mm.",
          limits["centre_within_mm"].get<double>()),
      {.size = 10, .fill = kSoft});
  return svg.text_of(y + 34.0);
}

std::string measures_plot(const Json& measures) {
  constexpr double kMost = 4.0;  // standard deviations
  constexpr double kLeft = 170.0;
  constexpr double kRight = Svg::kWidth - 12.0;
  const auto at = [kMost](double z) {
    return (kLeft + kRight) / 2.0 + (kRight - kLeft) / 2.0 * std::clamp(z, -kMost, kMost) / kMost;
  };
  Svg svg("Measures beside what is published of a population, in standard deviations from its mean");
  double y = 8.0;
  for (const Json& row : measures["measures"]) {
    const std::optional<Spread> spread = spread_of(row);
    if (!spread) continue;
    svg.text(4.0, y + 11.0, measure_words(row["measure"]), {.size = 12});
    svg.rect(at(-2.0), y + 2.0, at(2.0) - at(-2.0), 12.0, "#dbe5ee");
    svg.rect(at(-1.0), y + 2.0, at(1.0) - at(-1.0), 12.0, "#b4cade");
    svg.line(at(0.0), y, at(0.0), y + 16.0, "#6f8ba3");
    if (row["value"].is_number()) {
      const double z = (row["value"].get<double>() - spread->mean) / spread->sd;
      const double error =
          row["uncertainty"].is_number() ? row["uncertainty"].get<double>() / spread->sd : 0.0;
      svg.line(at(z - error), y + 8.0, at(z + error), y + 8.0, "#b3282d", "stroke-width=\"2\"");
      svg.add(formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"#b3282d\"/>\n", at(z), y + 8.0));
      if (std::abs(z) > kMost)
        svg.text(at(z) + (z > 0.0 ? -7.0 : 7.0), y + 12.0, formatted("%+.0f SD", z),
                 {.size = 10, .anchor = z > 0.0 ? "end" : "start", .bold = true});
    } else {
      svg.text(at(0.0), y + 12.0, "not measured", {.size = 10, .anchor = "middle", .fill = kSoft});
    }
    y += 20.0;
  }
  if (y == 8.0) return "";
  for (int z = -4; z <= 4; z += 2)
    svg.text(at(z), y + 10.0, formatted(z == 0 ? "%d" : "%+d", z),
             {.size = 10, .anchor = "middle", .fill = kSoft});
  svg.text(4.0, y + 10.0, "SD from the published mean", {.size = 10, .fill = kSoft});
  return svg.text_of(y + 18.0);
}

std::string motion_words(const std::string& name) {
  const NamedMotion& motion = named_motion(name);
  if (name == motion.growing) return spaced(name);
  if (name == "fadir") return "FADIR: internal rotation at 90° of flexion, 15° of adduction";
  if (name == "faber") return "FABER: external rotation at 45° of flexion, 30° of abduction";
  return spaced(motion.growing) + formatted(" at %g° of flexion", motion.start.flexion);
}

std::string measure_words(const std::string& name) {
  if (name.rfind("alpha_at_", 0) != 0) return spaced(name);
  std::string hour = name.substr(9);
  std::replace(hour.begin(), hour.end(), '_', ':');
  return "alpha angle at " + hour + (hour.find(':') == hour.npos ? ":00" : "");
}

std::optional<double> published_distance(const Json& measure) {
  const std::optional<Spread> spread = spread_of(measure);
  if (!spread || !measure["value"].is_number()) return std::nullopt;
  return (measure["value"].get<double>() - spread->mean) / spread->sd;
}

std::vector<Json> ball_limits(const Json& limits, bool cartilage) {
  std::vector<Json> rows;
  for (const Json& limit : limits["limits"])
    if (limit["centre"] == "ball" && (limit["threshold_mm"] > 0.0) == cartilage) rows.push_back(limit);
  return rows;
}

std::string reach_words(const Json& limit) {
  const std::string low = rounded_down(limit["low_deg"], 1) + "°";
  if (limit["state"] == "blocked") return "begins in contact";
  if (limit["state"] == "free") return "free to " + low;
  return limit["state"] == "unknown" ? low + ", unknown beyond" : low;
}

}  // namespace impinge
