// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/impingement_json.hpp"

#include "gap/gap_histogram.hpp"
#include "gap/gap_summary.hpp"
#include "hip/close_zones.hpp"
#include "scene/json_values.hpp"

namespace impinge {
namespace {

using nlohmann::json;

json zones_json(const ReportedSurface& v, double threshold, const Whereabouts& where) {
  if (!where.dial) return nullptr;
  if (v.gaps.gap.empty()) return json::array();  // not scanned
  std::vector<Vec3> places = v.posed;
  for (Vec3& x : places) x = where.axes * x;
  json zones = json::array();
  for (const ClockZone& zone : close_zones(*where.dial, {places, v.against_cartilage, v.area}, threshold)) {
    zones.push_back({{"from", clock_text(zone.from)}, {"to", clock_text(zone.to)}, {"area_mm2", zone.area}});
  }
  return zones;
}

}  // namespace

nlohmann::json dial_json(const std::optional<ClockFace>& dial) {
  if (!dial) return nullptr;
  const auto vector = [](const Vec3& x) { return nlohmann::json::array({x.x(), x.y(), x.z()}); };
  return {{"twelve", vector(dial->twelve)}, {"three", vector(dial->three)}};
}

nlohmann::json impingement_json(const ReportedSurface& v, double threshold, const Whereabouts& where) {
  const GapSummary found = summarise(v.against_cartilage, v.area, threshold);
  return {{"vertices", found.impinged},
          {"area_mm2", found.impinged_area},
          {"clock_zones", zones_json(v, threshold, where)}};
}

nlohmann::json smallest_json(const ReportedSurface& v, const Whereabouts& where) {
  const GapSummary found = summarise(v.gaps.gap, v.area, 0.0);
  if (!found.smallest) return nullptr;
  const std::size_t i = *found.smallest;
  return {{"gap_mm", found.smallest_gap},
          {"error_bound_mm", v.gaps.bound.empty() ? nlohmann::json(nullptr) : number_json(v.gaps.bound[i])},
          {"euclidean_distance_mm",
           v.gaps.distance.empty() ? nlohmann::json(nullptr)
                                   : interval_json(v.gaps.distance[i].lower_mm, v.gaps.distance[i].upper_mm)},
          {"surface", name(v.surface)},
          {"vertex", i},
          {"position", point_json(v.posed[i] + where.centre)},
          {"clock", where.dial ? nlohmann::json(clock_text(where.dial->hours(where.axes * v.posed[i])))
                               : nlohmann::json(nullptr)}};
}

nlohmann::json smaller(const nlohmann::json& a, const nlohmann::json& b) {
  if (a.is_null() || b.is_null()) return a.is_null() ? b : a;
  return a["gap_mm"] <= b["gap_mm"] ? a : b;
}

nlohmann::json levels_json(const ReportedSurface& v, bool map) {
  nlohmann::json levels = nlohmann::json::array();
  for (const GapLevel& level : gap_levels(v.surface, v.touching)) {
    levels.push_back({{map ? "up_to_share_of_cartilage" : "up_to_mm", number_json(level.up_to_mm)},
                      {"meaning", level.meaning},
                      {"rgb", level.colour}});
  }
  return levels;
}

nlohmann::json histogram_json(const ReportedSurface& v) {
  if (v.gaps.gap.empty()) return nullptr;  // not scanned
  const GapHistogram found = gap_histogram(v.gaps.gap, v.area);
  return {{"area_mm2", found.area},
          {"below_mm2", found.below},
          {"beyond_mm2", found.beyond},
          {"without_gap_mm2", found.without}};
}

}  // namespace impinge
