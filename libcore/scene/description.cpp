// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/formatted.hpp"
#include "scene/report.hpp"

namespace impinge {
namespace {

using nlohmann::json;

std::string describe_zones(const json& zones) {
  if (zones.is_null()) return "no clock positions: the socket looks straight up, down, forward or back";
  std::string text;
  for (const json& zone : zones) {
    if (zone["from"] == zone["to"]) return "all round the clock";
    text +=
        (text.empty() ? "" : ", ") + zone["from"].get<std::string>() + "-" + zone["to"].get<std::string>();
  }
  return text.empty() ? "nowhere" : "at " + text + " o'clock";
}

std::string describe_table(const json& summary) {
  const auto entries = summary["entries_per_table"].get<std::size_t>();
  if (!summary["max_error_mm"].is_null()) {
    const auto error = summary["max_error_mm"].get<double>();
    if (entries == 0) return formatted("table               none: gaps within %g mm, of the faces\n", error);
    return formatted("table               %zu entries in both, and the faces: gaps within %g mm\n", entries,
                     error);
  }
  return formatted("table               %s at %g degrees, %zu entries a surface\n",
                   summary["scheme"].get<std::string>().c_str(), summary["precision_deg"].get<double>(),
                   entries);
}

std::string describe_certificate(const json& certificate) {
  if (certificate.is_null()) return "";
  const std::string surfaces = certificate["surfaces"];
  std::string text = "bone on bone        surfaces " + surfaces;
  if (surfaces == "impinged") {
    text += ", by up to " + rounded_up(certificate["deepest_mm"], 3) + " mm at a " +
            certificate["deepest_at"].get<std::string>();
  }
  return text + "; vertices " + certificate["vertices"].get<std::string>() + " (both decided exactly)\n";
}

}  // namespace

std::string describe_scene(const nlohmann::json& summary) {
  const nlohmann::json& centre = summary["centre"];
  std::string text = formatted("centre of rotation  %.3f %.3f %.3f mm, %s", centre["x"].get<double>(),
                               centre["y"].get<double>(), centre["z"].get<double>(),
                               centre["source"].get<std::string>().c_str());
  if (centre["source"] == "fitted") {
    text += formatted(" (radius %.2f mm, residual %.2f mm rms over %zu vertices)",
                      centre["radius_mm"].get<double>(), centre["residual_rms_mm"].get<double>(),
                      centre["vertices_used"].get<std::size_t>());
  }
  text += "\n" + describe_table(summary);
  text += describe_certificate(summary["certificate"]);
  const nlohmann::json& smallest = summary["smallest_gap"];
  if (smallest.is_null()) return text + "smallest gap        none: the surfaces do not face each other\n";
  text += formatted("smallest gap        %.3f mm at %s vertex %zu", smallest["gap_mm"].get<double>(),
                    smallest["surface"].get<std::string>().c_str(), smallest["vertex"].get<std::size_t>());
  if (!smallest["clock"].is_null()) text += ", " + smallest["clock"].get<std::string>() + " o'clock";
  if (!smallest["error_bound_mm"].is_null()) {
    text += " (error of this gap by the table at most " + rounded_up(smallest["error_bound_mm"], 3) + " mm)";
  }
  const nlohmann::json& distance = smallest["euclidean_distance_mm"];
  if (!distance.is_null()) {
    text += "\nEuclidean distance  " + rounded_down(distance[0], 3) + " to " + rounded_up(distance[1], 3) +
            " mm there";
  }
  for (const nlohmann::json& level : summary["impingement"]) {
    text += level["gap_up_to_mm"].is_null()
                ? std::string("\ncartilage touches   ")
                : formatted("\nimpinged at %3g mm   ", level["gap_up_to_mm"].get<double>());
    const std::size_t found =
        level["ball"]["vertices"].get<std::size_t>() + level["socket"]["vertices"].get<std::size_t>();
    if (found == 0) {
      text += "nowhere";
      continue;
    }
    text += formatted("ball %.1f mm^2 %s; socket %.1f mm^2 %s", level["ball"]["area_mm2"].get<double>(),
                      describe_zones(level["ball"]["clock_zones"]).c_str(),
                      level["socket"]["area_mm2"].get<double>(),
                      describe_zones(level["socket"]["clock_zones"]).c_str());
  }
  return text + "\n";
}

}  // namespace impinge
