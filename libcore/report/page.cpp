// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

#include "files/formatted.hpp"
#include "report/plots.hpp"
#include "report/svg.hpp"

namespace impinge {

extern const std::string_view kReportStyle;  // style.css

namespace {

constexpr const char* kNotice = "Research software, no medical device: nothing here may guide a treatment.";

std::string text_or(const Json& value, const std::string& otherwise = "") {
  return value.is_string() ? value.get<std::string>() : otherwise;
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

// A script that may stand between the tags of a page.
std::string script_text(std::string_view script) {
  return replaced(replaced(std::string(script), "</script", "<\\/script"), "<!--", "<\\!--");
}

std::string section(const char* id, const char* title, const std::string& inner, const char* more = "") {
  if (inner.empty()) return "";
  return formatted("<section id=\"%s\"%s>\n<h2>%s</h2>\n", id, more, title) + inner + "</section>\n";
}

std::string paragraph(const std::string& text, const char* more = " class=\"soft\"") {
  return "<p" + std::string(more) + ">" + escaped(text) + "</p>\n";
}

// The rows of a table. Each cell knows the head of its column; the first cell is the head of its row.
class HtmlTable {
 public:
  explicit HtmlTable(std::vector<std::string> heads) : heads_(std::move(heads)) {}
  void add(const std::vector<std::string>& cells) {
    rows_ += "<tr><th scope=\"row\">" + escaped(cells.front()) + "</th>";
    for (std::size_t k = 1; k < cells.size(); ++k)
      rows_ += "<td data-label=\"" + escaped(heads_[k]) + "\">" + escaped(cells[k]) + "</td>";
    rows_ += "</tr>\n";
  }
  std::string text() const {
    std::string head;
    for (const std::string& one : heads_) head += "<th scope=\"col\">" + escaped(one) + "</th>";
    return "<table>\n<thead><tr>" + head + "</tr></thead>\n<tbody>\n" + rows_ + "</tbody>\n</table>\n";
  }

 private:
  std::vector<std::string> heads_;
  std::string rows_{};
};

std::string fact(const std::string& name, const std::string& value, bool strong = false) {
  return "<dt>" + escaped(name) + "</dt><dd>" + (strong ? "<strong>" : "") + escaped(value) +
         (strong ? "</strong>" : "") + "</dd>\n";
}

// Is the femur's neutral pose known by landmarks, so that angles count from there and not from the scan?
bool from_neutral(const Json& joint) {
  return joint["landmarks"].is_object() && joint["landmarks"]["scanned_flexion_deg"].is_number();
}

std::string pose_words(const Json& pose) {
  std::string text;
  for (const auto& angle : pose.items())
    if (angle.value() != 0.0)
      text +=
          (text.empty() ? "" : ", ") + spaced(angle.key()) + formatted(" %g°", angle.value().get<double>());
  return text.empty() ? "all angles 0" : text;
}

std::string percent(const Json& low, const Json& high) {
  return rounded_down(100.0 * low.get<double>(), 1) + " to " + rounded_up(100.0 * high.get<double>(), 1) +
         " %";
}

std::vector<std::string> limit_warnings(const Json& answer) {
  std::vector<std::string> lines;
  if (answer["limits"].is_null()) return lines;
  const std::vector<Json> limits = ball_limits(answer["limits"], false);
  const auto add = [&](const char* what, const std::function<bool(const Json&)>& has) {
    std::string names;
    std::size_t count = 0;
    for (const Json& limit : limits) {
      if (!has(limit)) continue;
      names += (names.empty() ? "" : "; ") + motion_words(limit["motion"]);
      ++count;
    }
    if (count > 0)
      lines.push_back(formatted("%zu of %zu motions ", count, limits.size()) + what + names + ".");
  };
  add("begin where bones touch already: ", [](const Json& limit) { return limit["state"] == "blocked"; });
  add("come to an opening of a mesh, where it is not known whether one bone is inside the other (give both "
      "whole, or crop both): ",
      [](const Json& limit) { return limit["unknown_by"] == "opening"; });
  add("go to where the ball's mesh ends or surfaces graze, and perhaps farther: ",
      [](const Json& limit) { return limit["state"] == "unknown" && limit["unknown_by"] != "opening"; });
  add("are sensitive: with 0.5 mm of another centre or of play their limit may be more than 5° off: ",
      [](const Json& limit) { return limit["hangs_on_less_than_half_mm"] && limit["state"] != "blocked"; });
  if (const Json& cut = answer["limits"]["ball_cut_mm"]; cut.is_number())
    lines.push_back(
        formatted("The ball's bone is cut off %.1f mm from the centre, through its neck: what is "
                  "missing beyond stops no motion, so that limits may be too large.",
                  cut.get<double>()));
  return lines;
}

// Warnings that make the joint doubtful, then those about its answers, then remarks on its meshes.
std::vector<std::string> warnings_of(const ReportParts& parts) {
  std::vector<std::string> lines;
  for (const Json& line : parts.joint["warnings"]) {
    lines.push_back(line.get<std::string>());
    lines.back() += lines.back().ends_with('.') ? "" : ".";
  }
  std::vector<std::string> of_answers = limit_warnings(parts.answer);
  const Json& volume = parts.answer["volume"];
  if (volume.is_object() && volume["unknown"] > 0.0)
    of_answers.push_back(formatted("Of %.1f %% of all rotations nothing is known: a mesh ends there.",
                                   100.0 * volume["unknown"].get<double>()));
  if (parts.viewer.empty()) of_answers.push_back("The bones are not drawn: " + viewer_missing() + ".");
  const auto at = lines.begin() + static_cast<std::ptrdiff_t>(std::min(parts.doubts, lines.size()));
  lines.insert(at, of_answers.begin(), of_answers.end());
  return lines;
}

std::string warnings_section(const ReportParts& parts) {
  const std::vector<std::string> lines = warnings_of(parts);
  std::string inner = "<ul>\n";
  for (const std::string& line : lines) inner += "<li>" + escaped(line) + "</li>\n";
  if (lines.empty()) return section("warnings", "Warnings", paragraph("None."), " class=\"wide\"");
  return section("warnings", "Read this first", inner + "</ul>\n", " class=\"wide\"");
}

std::string contact_words(const Json& contact) {
  if (contact["state"] == "no") return "none";
  if (contact["state"] == "unknown") return "not known: a mesh is open";
  std::string text = "yes";
  if (contact["by"].is_string()) text += ", " + contact["by"].get<std::string>();
  for (const char* part : {"ball_part", "socket_part"})
    if (contact[part].is_string()) text += ", " + contact[part].get<std::string>();
  return text;
}

std::string smallest_words(const Json& gap) {
  if (gap.is_null()) return "none: the surfaces do not face each other";
  return formatted("%.2f mm", gap["gap_mm"].get<double>() + 0.0) +
         (gap["clock"].is_string() ? " at " + gap["clock"].get<std::string>() + " o'clock" : "");
}

// The limits that a reader looks for first.
std::string first_limits(const Json& limits) {
  std::string facts;
  for (const Json& limit : ball_limits(limits, false)) {
    const std::string name = limit["motion"];
    if (name == "flexion" || name == "internal_rotation_at_90")
      facts += fact(motion_words(name),
                    reach_words(limit) + (limit["meets"].is_string() ? ", " + text_or(limit["meets"]) : ""));
  }
  return facts;
}

// Measures that are two standard deviations or more from the published mean.
std::string unusual_measures(const Json& measures) {
  std::string names;
  for (const Json& row : measures["measures"]) {
    const std::optional<double> z = published_distance(row);
    if (z && std::abs(*z) > 2.0)
      names += (names.empty() ? "" : "; ") + measure_words(row["measure"]) +
               formatted(" %.3g (%+.1f SD)", row["value"].get<double>(), *z);
  }
  return names.empty() ? "none" : names;
}

std::string glance_section(const Json& answer) {
  const Json& gaps = answer["gaps"];
  std::string facts = fact("Contact of the bones", contact_words(gaps["contact"]), true) +
                      fact("Smallest gap", smallest_words(gaps["smallest_gap"]), true);
  if (answer["limits"].is_object()) facts += first_limits(answer["limits"]);
  const Json& volume = answer["volume"];
  if (volume.is_object())
    facts += fact("Rotations without contact",
                  percent(volume["share_low"], volume["share_high"]) + " of all rotations");
  if (answer["measures"].is_object())
    facts += fact("Measures beyond 2 SD of published ones", unusual_measures(answer["measures"]));
  return section("glance", "At a glance", "<dl>\n" + facts + "</dl>\n");
}

std::string input_section(const ReportParts& parts) {
  const Json& joint = parts.joint;
  const auto bone = [&](const char* which, const std::string& name) {
    const Json& said = joint[which];
    std::string text = name + formatted(", %zu faces", said["faces"].get<std::size_t>());
    if (said["taken"].is_object())
      text += formatted("; %zu of them are the joint, the rest counts as bone",
                        said["taken"]["faces"].get<std::size_t>());
    return text;
  };
  const Json& centre = joint["centre"];
  const Json& at = centre["position"];
  std::string centre_text = formatted("%.2f, %.2f, %.2f mm, %s", at[0].get<double>(), at[1].get<double>(),
                                      at[2].get<double>(), centre["source"].get<std::string>().c_str());
  if (centre["radius_mm"].is_number())
    centre_text += formatted(" (sphere of %.2f mm, residual %.2f mm rms)", centre["radius_mm"].get<double>(),
                             centre["residual_rms_mm"].get<double>());
  std::string facts = fact("Ball", bone("ball", parts.ball)) + fact("Socket", bone("socket", parts.socket)) +
                      fact("Side", text_or(joint["side"])) +
                      fact("Axes of the meshes", text_or(joint["axes"]) + " (where +x, +y, +z point)") +
                      fact("Centre of rotation", centre_text) +
                      fact("Pose shown", pose_words(parts.request["pose"]));
  facts += fact("Cartilage", joint["cartilage_map"].is_null()
                                 ? formatted("%g mm, both layers together",
                                             parts.request.value("cartilage_mm", Json()).is_number()
                                                 ? parts.request["cartilage_mm"].get<double>()
                                                 : GapsRequest().cartilage_mm)
                                 : std::string("a map, both layers together"));
  std::string from = from_neutral(joint) ? "neutral, by landmarks" : "the pose of the scan";
  if (joint["landmarks"].is_object())
    from +=
        formatted(" (pelvic tilt %.1f° in the scan)", joint["landmarks"]["pelvic_tilt_deg"].get<double>());
  facts += fact("Angles are counted from", from);
  return section("input", "What was looked at", "<dl>\n" + facts + "</dl>\n");
}

// Does a map give the thickness of the cartilage? Then levels are shares of it (joint/gaps.hpp).
bool has_map(const ReportParts& parts) { return !parts.joint["cartilage_map"].is_null(); }

std::string legend(const Json& colours, bool by_map) {
  const auto css = [](const Json& rgb) {
    return formatted("#%02x%02x%02x", rgb[0].get<int>(), rgb[1].get<int>(), rgb[2].get<int>());
  };
  std::string rows;
  const auto add = [&](const Json& rgb, const std::string& text) {
    rows += "<li><span class=\"swatch\" style=\"background:" + css(rgb) + "\"></span>" + escaped(text) +
            "</li>\n";
  };
  double before = 0.0;
  for (const Json& level : colours["ball"]) {
    if (level["up_to"].is_null()) continue;
    const double up_to = level["up_to"];
    add(level["rgb"], up_to == 0.0 ? std::string("gap of 0 mm or less")
                      : by_map ? formatted("%.0f to %.0f %% of the cartilage", 100.0 * before, 100.0 * up_to)
                               : formatted("%.1f to %.1f mm", before, up_to));
    before = up_to;
  }
  const std::string beyond = by_map ? "beyond the cartilage" : formatted("over %.1f mm", before);
  add(colours["ball"].back()["rgb"], "ball, " + beyond);
  add(colours["socket"].back()["rgb"], "socket, " + beyond);
  add(colours["no_gap_rgb"], "no bone opposite");
  return "<ul class=\"legend\">\n" + rows + "</ul>\n";
}

// `near`: the viewer's distance, as a share of the distance from which everything is seen.
std::string figure(const char* view, double near, const char* shown, const char* caption) {
  return formatted(
      "<figure data-view=\"%s\" data-near=\"%g\" data-shown=\"%s\"><figcaption>%s</figcaption></figure>\n",
      view, near, shown, caption);
}

std::string views_section(const ReportParts& parts) {
  if (parts.viewer.empty()) return "";
  const char* compass =
      "<svg id=\"compass\" viewBox=\"-44 -44 88 88\" role=\"img\" aria-label=\"R right, L left, A "
      "anterior, P posterior, S superior, I inferior of the patient\"></svg>";
  return section(
      "views", "The bones, coloured by gap",
      std::string("<div id=\"turn\"><div class=\"stage\"><canvas id=\"view\" tabindex=\"0\" role=\"img\" "
                  "aria-label=\"The joint in three dimensions; drag to turn it\"></canvas>") +
          compass + "</div>\n<div id=\"controls\"></div></div>\n<p id=\"no-views\" hidden></p>\n" +
          "<noscript><p>The bones are drawn by a script of this page, which this browser does not "
          "run.</p></noscript>\n" +
          "<div class=\"stills\">\n" + figure("anterior", 0.55, "ball socket smallest", "From the front") +
          figure("posterior", 0.55, "ball socket smallest", "From behind") +
          figure("lateral", 0.4, "socket clock smallest", "The socket from the side, ball taken away") +
          figure("medial", 0.4, "ball smallest", "The ball from the midline, socket taken away") +
          "</div>\n" + legend(parts.answer["gaps"]["colours"], has_map(parts)) +
          paragraph("A gap is the joint space along a ray from the centre of rotation. The dot is the "
                    "smallest one; it is seen through bone."),
      " class=\"wide\"");
}

std::string clock_section(const ReportParts& parts) {
  if (parts.clock.empty())
    return section("clock", "Gaps round the rim",
                   paragraph("The socket looks straight up, down, forward or back, so "
                             "that its rim has no clock."));
  return section(
      "clock", "Gaps round the rim",
      parts.clock +
          paragraph("The socket, unrolled: 12 o'clock is superior and 3 anterior on both sides. Bars "
                    "below say where a gap is so small. The dashed line is the smallest gap." +
                    std::string(has_map(parts) ? " Colours say what share of the cartilage a gap is." : "")));
}

std::string limits_section(const ReportParts& parts) {
  if (parts.limits.empty()) return "";
  return section(
      "limits", "Range of motion",
      parts.limits +
          paragraph("Proven for the meshes, about the centre of the ball; no pose is sampled. Soft "
                    "tissue is not there, so that a patient turns less far."));
}

// The range over all centres, or all play.
std::string range_words(const Json& limit, const std::string& of) {
  const Json& high = limit[of + "_high_deg"];
  return rounded_down(limit[of + "_low_deg"], 1) + " to " +
         (high.is_number() ? rounded_up(high, 1) + "°" : "unknown");
}

std::string limits_table(const Json& limits) {
  if (limits.is_null()) return "";
  const std::vector<Json> cartilage = ball_limits(limits, true);
  std::vector<std::string> heads{
      "Motion",
      "bones meet",
      "about the socket's centre",
      formatted("for centres within %g mm", limits["centre_within_mm"].get<double>()),
      formatted("for play up to %g mm", limits["centre_within_mm"].get<double>()),
      "gap of 0.5 mm",
      "o'clock",
      "what meets, and doubts"};
  if (!cartilage.empty()) heads.emplace_back("gap of cartilage");
  HtmlTable table(heads);
  for (const Json& limit : ball_limits(limits, false)) {
    std::vector<std::string> cells(heads.size());
    cells[0] = motion_words(limit["motion"]);
    cells[1] = reach_words(limit);
    for (const Json& other : limits["limits"])
      if (other["motion"] == limit["motion"] && other["centre"] == "socket") cells[2] = reach_words(other);
    if (limit["state"] == "limited") {
      cells[3] = range_words(limit, "centre");
      cells[4] = range_words(limit, "play");
    }
    if (limit["half_mm_gap_deg"].is_number()) cells[5] = rounded_down(limit["half_mm_gap_deg"], 1) + "°";
    cells[6] = text_or(limit["clock"]);
    cells[7] = text_or(limit["what"]);
    for (const Json& other : cartilage)
      if (other["motion"] == limit["motion"])
        cells.back() = other["state"] == "blocked" ? "from the start" : reach_words(other);
    table.add(cells);
  }
  return section("limits-table", "Range of motion in numbers", table.text(), " class=\"wide\"");
}

std::string volume_section(const ReportParts& parts) {
  const Json& volume = parts.answer["volume"];
  if (volume.is_null()) return "";
  const std::string start = from_neutral(parts.joint) ? "neutral pose" : "pose of the scan";
  std::string text =
      percent(volume["share_low"], volume["share_high"]) + " of all rotations are free of contact; ";
  text += volume["neutral_blocked"] ? "none can be reached, since the " + start + " is blocked"
                                    : percent(volume["reachable_low"], volume["reachable_high"]) +
                                          " can be reached from the " + start + " without contact";
  text += formatted(
      ". Both ends are proven; %.0f %% may stay undecided here, impinge volume --width 0.01 decides more.",
      100.0 * parts.request["width"].get<double>());
  if (volume["by_radii"])
    text +=
        " Blocked includes where the ball reaches beyond the socket along a ray though no surfaces meet, as "
        "the socket is a sheet; limits may go further.";
  return section("rotations", "All rotations at once", parts.volume + paragraph(text));
}

std::string published_words(const Json& row) {
  if (row["published_mean"].is_number())
    return formatted("%.4g ± %.2g", row["published_mean"].get<double>(), row["published_sd"].get<double>());
  if (row["published_median"].is_number())
    return formatted("%.4g (%.4g to %.4g)", row["published_median"].get<double>(),
                     row["published_lower_quartile"].get<double>(),
                     row["published_upper_quartile"].get<double>());
  return "";
}

std::string measures_section(const ReportParts& parts) {
  if (parts.measures.empty()) return "";
  return section("measures", "Measures beside published ones",
                 parts.measures +
                     paragraph("Dot: this joint, with how far it moves when it is measured otherwise. Bands: "
                               "one and two standard deviations of the published group."));
}

// Two decimals for a share, one for all else.
std::string measured_words(const Json& row) {
  const int decimals = row["unit"] == "1" ? 2 : 1;
  std::string text = formatted("%.*f", decimals, row["value"].get<double>());
  if (!row["uncertainty"].is_number()) return text;
  const double error = row["uncertainty"];
  const double least = 0.5 * std::pow(10.0, -decimals);
  return text +
         (error < least ? formatted(" ± less than %g", 2.0 * least) : formatted(" ± %.*f", decimals, error));
}

std::string unit_words(const std::string& unit) {
  if (unit == "1") return "";
  return unit == "deg" ? "°" : " " + unit;
}

std::string measures_table(const Json& measures) {
  if (measures.is_null()) return "";
  HtmlTable table({"Measure", "this joint", "published", "of whom"});
  std::string sources;
  for (const Json& row : measures["measures"]) {
    const std::string unit = unit_words(row["unit"]);
    std::vector<std::string> cells{measure_words(row["measure"]), text_or(row["state"]), "", ""};
    if (row["value"].is_number()) cells[1] = measured_words(row) + unit;
    if (row["published_source"].is_string()) {
      const std::string source = row["published_source"];
      if (sources.find(source) == sources.npos) sources += (sources.empty() ? "" : "; ") + source;
      cells[2] = published_words(row) + unit;
      cells[3] =
          source.substr(0, source.find(',')) + ": " + replaced(text_or(row["published_of"]), "+-", "±");
    }
    table.add(cells);
  }
  return section("measures-table", "Measures in numbers",
                 table.text() + paragraph("Published: mean ± standard deviation, or median (quartiles). " +
                                          sources + "."),
                 " class=\"wide\"");
}

}  // namespace

std::string viewer_missing() {
  return "this program was built without analysis/node_modules/three or esbuild; experiments/reproduce "
         "--only joint3d fetches both, then build it again";
}

std::string report_page(const ReportParts& parts) {
  const std::string title =
      "Joint report: " + parts.ball + " in " + parts.socket + ", " + text_or(parts.joint["side"]);
  std::string page =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<meta http-equiv=\"Content-Security-Policy\" "
      "content=\"default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: "
      "blob:\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>" +
      escaped(title) + "</title>\n<style>" + std::string(kReportStyle) +
      "</style>\n</head>\n<body>\n<header>\n<h1>" + escaped(title) + "</h1>\n" +
      paragraph(parts.program + ". Lengths in mm, angles in degrees. " + kNotice) + "</header>\n<main>\n";
  const auto column = [](const std::string& sections) {
    return "<div class=\"column\">\n" + sections + "</div>\n";
  };
  page += warnings_section(parts) + glance_section(parts.answer) + input_section(parts) +
          views_section(parts) + column(limits_section(parts) + measures_section(parts)) +
          column(clock_section(parts) + volume_section(parts)) + limits_table(parts.answer["limits"]) +
          measures_table(parts.answer["measures"]);
  page += "</main>\n<footer>\n" +
          paragraph(
              "What is proven holds for these two meshes: it does not cover how they differ from the bones, "
              "nor the error of the centre beyond the ranges given. summary.json, which the program writes "
              "beside its report, has all numbers.") +
          "</footer>\n";
  if (!parts.viewer.empty())
    page += "<script type=\"application/json\" id=\"scene\">" + script_text(parts.scene.dump()) +
            "</script>\n<script>" + script_text(parts.viewer) + "</script>\n";
  return page + "</body>\n</html>\n";
}

}  // namespace impinge
