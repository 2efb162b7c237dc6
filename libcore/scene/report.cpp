// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "detection/formatted.hpp"
#include "detection/gap_histogram.hpp"
#include "detection/gap_summary.hpp"
#include "experiment/csv.hpp"
#include "files/file_set.hpp"
#include "joint/close_zones.hpp"
#include "joint/gap_files.hpp"
#include "joint/gap_levels.hpp"
#include "mesh/ply_writer.hpp"
#include "scene/point_json.hpp"
#include "scene/question.hpp"

namespace impinge {
namespace {

using nlohmann::json;

// One surface with everything that the report says about it.
struct View {
  Surface surface;
  const std::filesystem::path& file;
  const JointPart& part;
  const SurfaceGaps& gaps;
  std::vector<Vec3> posed;  // socket's centre frame, mm
  std::vector<double> area;
  std::vector<double> against_cartilage;  // gaps in mm, or as shares of a map's thickness
  double touching = 0.0;                  // of these, where the layers of cartilage touch
};

View view(Surface surface, const SceneOptions& options, const Joint& joint, const Measurement& measurement) {
  const bool is_ball = surface == Surface::ball;
  View v{surface,
         is_ball ? options.ball : options.socket,
         is_ball ? joint.ball : joint.socket,
         is_ball ? measurement.ball : measurement.socket,
         {},
         {},
         {},
         joint.cartilage ? 1.0 : options.cartilage_mm};
  v.posed = v.part.mesh.vertices;
  if (is_ball) {
    for (Vec3& x : v.posed) x = to_socket(measurement.pose, x);
  }
  if (!v.gaps.gap.empty()) v.area = vertex_areas(v.part.mesh);  // else it was not scanned
  v.against_cartilage =
      joint.cartilage ? shares_of_cartilage(v.gaps.gap, v.posed, *joint.cartilage) : v.gaps.gap;
  return v;
}

json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json interval(double low, double high) { return json::array({number(low), number(high)}); }

json part_json(const View& v) {
  const MeshReport& mesh = v.part.validation;
  const StarShapeReport& star = v.part.star_shape;
  return {{"file", v.file.string()},
          {"vertices", mesh.vertices},
          {"faces", mesh.faces},
          {"boundary_edges", mesh.boundary_edges},
          {"non_manifold_edges", mesh.non_manifold_edges},
          {"degenerate_faces", mesh.degenerate_faces},
          {"duplicate_faces", mesh.duplicate_faces},
          {"flipped_faces", mesh.flipped_faces},
          {"components", mesh.components},
          {"star_shaped", star.star_shaped},
          {"directions_covered", star.covered},
          {"directions_met_more_than_once", star.violating},
          {"vertices_that_meet_the_other_surface", summarise(v.gaps.gap, v.area, 0.0).met}};
}

json zones_json(const View& v, double threshold, const std::optional<ClockFace>& dial,
                const Eigen::Matrix3d& axes) {
  if (!dial) return nullptr;
  if (v.gaps.gap.empty()) return json::array();  // not scanned
  std::vector<Vec3> places = v.posed;
  for (Vec3& x : places) x = axes * x;
  json zones = json::array();
  for (const ClockZone& zone : close_zones(*dial, {places, v.against_cartilage, v.area}, threshold)) {
    zones.push_back({{"from", clock_text(zone.from)}, {"to", clock_text(zone.to)}, {"area_mm2", zone.area}});
  }
  return zones;
}

// The dial as unit vectors of the joint frame.
json dial_json(const std::optional<ClockFace>& dial) {
  if (!dial) return nullptr;
  const auto vector = [](const Vec3& x) { return json::array({x.x(), x.y(), x.z()}); };
  return {{"twelve", vector(dial->twelve)}, {"three", vector(dial->three)}};
}

json impingement_json(const View& v, double threshold, const std::optional<ClockFace>& dial,
                      const Eigen::Matrix3d& axes) {
  const GapSummary found = summarise(v.against_cartilage, v.area, threshold);
  return {{"vertices", found.impinged},
          {"area_mm2", found.impinged_area},
          {"clock_zones", zones_json(v, threshold, dial, axes)}};
}

json smallest_json(const View& v, const Vec3& centre, const std::optional<ClockFace>& dial,
                   const Eigen::Matrix3d& axes) {
  const GapSummary found = summarise(v.gaps.gap, v.area, 0.0);
  if (!found.smallest) return nullptr;
  const std::size_t i = *found.smallest;
  return {{"gap_mm", found.smallest_gap},
          {"error_bound_mm", v.gaps.bound.empty() ? json(nullptr) : number(v.gaps.bound[i])},
          {"euclidean_distance_mm", v.gaps.distance.empty()
                                        ? json(nullptr)
                                        : interval(v.gaps.distance[i].lower_mm, v.gaps.distance[i].upper_mm)},
          {"surface", name(v.surface)},
          {"vertex", i},
          {"position", point_json(v.posed[i] + centre)},
          {"clock", dial ? json(clock_text(dial->hours(axes * v.posed[i]))) : json(nullptr)}};
}

json smaller(const json& a, const json& b) {
  if (a.is_null() || b.is_null()) return a.is_null() ? b : a;
  return a["gap_mm"] <= b["gap_mm"] ? a : b;
}

json centre_json(const Joint& joint) {
  json centre = point_json(joint.centre);
  centre["source"] = joint.fit ? "fitted" : "given";
  centre["radius_mm"] = joint.fit ? json(joint.fit->radius) : json(nullptr);
  centre["residual_rms_mm"] = joint.fit ? json(joint.fit->rms) : json(nullptr);
  centre["vertices_used"] = joint.fit ? json(joint.fit->points) : json(nullptr);
  return centre;
}

json levels_json(const View& v, bool map) {
  json levels = json::array();
  for (const GapLevel& level : gap_levels(v.surface, v.touching)) {
    levels.push_back({{map ? "up_to_share_of_cartilage" : "up_to_mm", number(level.up_to_mm)},
                      {"meaning", level.meaning},
                      {"rgb", level.colour}});
  }
  return levels;
}

json cartilage_json(const SceneOptions& options, const Joint& joint) {
  if (!joint.cartilage) return nullptr;
  const auto [least, most] = std::ranges::minmax(joint.cartilage->thickness);
  return {{"file", options.cartilage_map->string()},
          {"points", joint.cartilage->thickness.size()},
          {"thinnest_mm", least},
          {"thickest_mm", most}};
}

json histogram_json(const View& v) {
  if (v.gaps.gap.empty()) return nullptr;  // not scanned
  const GapHistogram found = gap_histogram(v.gaps.gap, v.area);
  return {{"area_mm2", found.area},
          {"below_mm2", found.below},
          {"beyond_mm2", found.beyond},
          {"without_gap_mm2", found.without}};
}

// In the pose of the scan no bone is in another one.
json warnings_json(const Joint& joint, const Measurement& measurement, const json& smallest) {
  json warnings = joint.warnings;
  const bool as_scanned = measurement.pose.rotation == Eigen::Matrix3d::Identity();
  if (as_scanned && !smallest.is_null() && smallest["gap_mm"] < 0.0) {
    warnings.push_back(
        "the bones overlap as scanned, where none can; check the centre, the frame and the "
        "segmentation of both meshes");
  }
  return warnings;
}

// Work that this scene did not need, and why.
json left_out(const Joint& joint, const std::vector<LeftOut>& planned) {
  json items = left_out_json(planned);
  if (joint.ball.star_shape.edge_on + joint.socket.star_shape.edge_on > 0) {
    items.push_back("faces whose plane holds the centre: they cover no direction");
  }
  return items;
}

// What the bounds of all vertices together prove: the smallest gap of any of them lies in the interval.
// Vertices without a finite bound (steep faces) are counted and left out of it.
json bounds_json(const View& ball, const View& socket) {
  if (ball.gaps.bound.empty()) return nullptr;
  double low = std::numeric_limits<double>::infinity();
  double high = low;
  double largest = 0.0;
  std::size_t unbounded = 0;
  for (const View* v : {&ball, &socket}) {
    for (std::size_t i = 0; i < v->gaps.gap.size(); ++i) {
      const double gap = v->gaps.gap[i];
      const double bound = v->gaps.bound[i];
      if (std::isnan(gap)) continue;
      if (std::isinf(bound)) {
        ++unbounded;
        continue;
      }
      low = std::min(low, gap - bound);
      high = std::min(high, gap + bound);
      largest = std::max(largest, bound);
    }
  }
  return {{"largest", largest},
          {"vertices_without_bound", unbounded},
          {"smallest_gap_between", json::array({number(low), number(high)})}};
}

// Gaps are radial. Where one is above the upper end of the Euclidean distance it overstates it for certain.
json distances_json(const View& ball, const View& socket) {
  if (ball.gaps.distance.empty()) return nullptr;
  constexpr double kOverstated = 1.1;
  double low = std::numeric_limits<double>::infinity();
  double high = low;
  double largest = 1.0;
  std::size_t overstated = 0;
  for (const View* v : {&ball, &socket}) {
    for (std::size_t i = 0; i < v->gaps.gap.size(); ++i) {
      const DistanceBracket& distance = v->gaps.distance[i];
      low = std::min(low, distance.lower_mm);
      high = std::min(high, distance.upper_mm);
      const double bound = v->gaps.bound.empty() ? 0.0 : v->gaps.bound[i];
      const double ratio = (std::abs(v->gaps.gap[i]) - bound) / distance.upper_mm;
      if (std::isnan(ratio)) continue;
      largest = std::max(largest, ratio);
      if (ratio > kOverstated) ++overstated;
    }
  }
  return {{"smallest_between", json::array({number(low), number(high)})},
          {"gaps_above_it_by_a_tenth", overstated},
          {"largest_gap_over_it", largest}};
}

const char* name(OverlayKind kind) {
  switch (kind) {
    case OverlayKind::ball_corner:
      return "ball vertex";
    case OverlayKind::socket_corner:
      return "socket vertex";
    case OverlayKind::crossing:
      break;
  }
  return "crossing of edges";
}

json vertex_verdicts_json(const VertexVerdicts& verdicts) {
  return {{"impinged", verdicts.impinged},
          {"clear_by_bound", verdicts.by_bound.clear},
          {"impinged_by_bound", verdicts.by_bound.impinged},
          {"undecided_by_bound", verdicts.by_bound.undecided},
          {"without_gap", verdicts.without_gap},
          {"bounds_refuted", verdicts.refuted}};
}

// What is certain about bone on bone.
json certificate_json(const std::optional<Certificate>& found) {
  if (!found) return nullptr;
  const Certificate& certificate = *found;
  const auto verdict = [](bool impinged) { return impinged ? "impinged" : "clear"; };
  const auto& deepest = certificate.deepest;
  return {{"surfaces", verdict(certificate.surfaces_impinged)},
          {"vertices", verdict(certificate.vertices_impinged())},
          {"ball", vertex_verdicts_json(certificate.ball)},
          {"socket", vertex_verdicts_json(certificate.socket)},
          {"deepest_mm", deepest ? json(deepest->depth) : json(nullptr)},
          {"deepest_at", deepest ? json(name(deepest->kind)) : json(nullptr)}};
}

std::string csv_of(const View& ball, const View& socket, const Vec3& centre) {
  const auto in_input_frame = [&centre](std::vector<Vec3> places) {
    for (Vec3& x : places) x += centre;
    return places;
  };
  const std::vector<Vec3> ball_places = in_input_frame(ball.posed);
  const std::vector<Vec3> socket_places = in_input_frame(socket.posed);
  return gaps_csv({ball.surface, ball_places, ball.gaps.gap},
                  {socket.surface, socket_places, socket.gaps.gap});
}

std::string distances_csv(const View& ball, const View& socket) {
  Table table;
  table.columns = {{"surface", "", "ball or socket"},
                   {"vertex", "1", "index in the input mesh after welding"},
                   {"gap_mm", "mm", "radial, as in gaps.csv"},
                   {"distance_lower_mm", "mm", "Euclidean distance from the other surface, lower end"},
                   {"distance_upper_mm", "mm", "upper end"}};
  for (const View* v : {&ball, &socket}) {
    for (std::size_t i = 0; i < v->posed.size(); ++i) {
      const DistanceBracket& distance = v->gaps.distance[i];
      table.add_row({name(v->surface), i, v->gaps.gap[i], distance.lower_mm, distance.upper_mm});
    }
  }
  return to_csv(table);
}

std::string part_ply(const View& v, const Vec3& centre) {
  TriangleMesh mesh{v.posed, v.part.mesh.faces};
  for (Vec3& x : mesh.vertices) x += centre;
  const auto levels = gap_levels(v.surface, v.touching);
  std::vector<Rgb> colours;
  for (const double gap : v.against_cartilage) colours.push_back(gap_colour(gap, levels));
  return ply_bytes(mesh, "gap", v.gaps.gap, colours);
}

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

std::string describe_certificate(const json& certificate) {
  if (certificate.is_null()) return "";
  const std::string surfaces = certificate["surfaces"];
  std::string text = "bone on bone        surfaces " + surfaces;
  if (surfaces == "impinged") {
    text += formatted(", by up to %.3f mm at a %s", certificate["deepest_mm"].get<double>(),
                      certificate["deepest_at"].get<std::string>().c_str());
  }
  return text + "; vertices " + certificate["vertices"].get<std::string>() + " (both decided exactly)\n";
}

}  // namespace

json summary(const SceneOptions& options, const Joint& joint, const Measurement& measurement) {
  const View ball = view(Surface::ball, options, joint, measurement);
  const View socket = view(Surface::socket, options, joint, measurement);
  const Eigen::Matrix3d axes = input_to_joint(options.axes);
  TriangleMesh in_joint_frame = joint.socket.mesh;
  for (Vec3& x : in_joint_frame.vertices) x = axes * x;
  const auto dial = clock_face(in_joint_frame);

  json thresholds = json::array();
  for (const double threshold : {0.0, ball.touching}) {
    if (threshold == 0.0 && !thresholds.empty()) continue;
    const bool by_map = joint.cartilage && threshold > 0.0;
    thresholds.push_back({{"gap_up_to_mm", by_map ? json(nullptr) : json(threshold)},
                          {"meaning", threshold == 0.0 ? "bone on bone" : "cartilage on cartilage"},
                          {"ball", impingement_json(ball, threshold, dial, axes)},
                          {"socket", impingement_json(socket, threshold, dial, axes)}});
  }
  const json smallest =
      smaller(smallest_json(ball, joint.centre, dial, axes), smallest_json(socket, joint.centre, dial, axes));
  const GapHistogram bins;
  return {{"units", {{"length", "mm"}, {"area", "mm^2"}, {"angle", "deg"}, {"time", "ms"}}},
          {"ball", part_json(ball)},
          {"socket", part_json(socket)},
          {"centre", centre_json(joint)},
          {"pose", options.pose},
          {"side", options.side ? json(*options.side == Side::left ? "left" : "right") : json(nullptr)},
          {"axes", options.axes},
          {"scheme", options.scheme},
          {"precision_deg", measurement.precision_deg},
          {"entries_per_table", measurement.entries},
          {"table_bytes", measurement.bytes},
          {"cartilage_mm", joint.cartilage ? json(nullptr) : json(options.cartilage_mm)},
          {"cartilage_map", cartilage_json(options, joint)},
          {"dial", dial_json(dial)},
          {"smallest_gap", smallest},
          {"gap_histogram",
           {{"first_mm", bins.first},
            {"bin_mm", bins.width},
            {"ball", histogram_json(ball)},
            {"socket", histogram_json(socket)}}},
          {"impingement", thresholds},
          {"error_bound_mm", bounds_json(ball, socket)},
          {"euclidean_distance_mm", distances_json(ball, socket)},
          {"certificate", certificate_json(measurement.certificate)},
          {"colours",
           {{"ball", levels_json(ball, joint.cartilage.has_value())},
            {"socket", levels_json(socket, joint.cartilage.has_value())},
            {"no_gap_rgb", kNoGapColour}}},
          {"left_out", left_out(joint, measurement.left_out)},
          {"warnings", warnings_json(joint, measurement, smallest)},
          {"times_ms",
           {{"fill_tables", measurement.fill_ms},
            {"scan", measurement.scan_ms},
            {"error_bounds", measurement.bound_ms},
            {"euclidean_distances", measurement.distance_ms},
            {"certificate",
             measurement.certificate ? json(1000.0 * measurement.certificate->seconds) : json(nullptr)}}}};
}

void write_scene(const SceneOptions& options, const Joint& joint, const Measurement& measurement,
                 const json& summary) {
  const View ball = view(Surface::ball, options, joint, measurement);
  const View socket = view(Surface::socket, options, joint, measurement);
  FileSet files;
  if (options.outputs.gaps) {
    for (const View* v : {&ball, &socket}) {
      if (v->gaps.gap.empty()) continue;
      files.add(options.out / (std::string(name(v->surface)) + ".ply"), part_ply(*v, joint.centre));
    }
    files.add(options.out / "gaps.csv", csv_of(ball, socket, joint.centre));
  }
  if (options.outputs.distances) files.add(options.out / "distances.csv", distances_csv(ball, socket));
  files.add(options.out / "summary.json", json_text(summary));
  files.commit();
}

std::string describe_scene(const json& summary) {
  const json& centre = summary["centre"];
  std::string text = formatted("centre of rotation  %.3f %.3f %.3f mm, %s", centre["x"].get<double>(),
                               centre["y"].get<double>(), centre["z"].get<double>(),
                               centre["source"].get<std::string>().c_str());
  if (centre["source"] == "fitted") {
    text += formatted(" (radius %.2f mm, residual %.2f mm rms over %zu vertices)",
                      centre["radius_mm"].get<double>(), centre["residual_rms_mm"].get<double>(),
                      centre["vertices_used"].get<std::size_t>());
  }
  text += formatted("\ntable               %s at %g degrees, %zu entries a surface\n",
                    summary["scheme"].get<std::string>().c_str(), summary["precision_deg"].get<double>(),
                    summary["entries_per_table"].get<std::size_t>());
  text += describe_certificate(summary["certificate"]);
  const json& smallest = summary["smallest_gap"];
  if (smallest.is_null()) return text + "smallest gap        none: the surfaces do not face each other\n";
  text += formatted("smallest gap        %.3f mm at %s vertex %zu", smallest["gap_mm"].get<double>(),
                    smallest["surface"].get<std::string>().c_str(), smallest["vertex"].get<std::size_t>());
  if (!smallest["clock"].is_null()) text += ", " + smallest["clock"].get<std::string>() + " o'clock";
  if (!smallest["error_bound_mm"].is_null()) {
    text += formatted(" (error of this gap by the table at most %.3f mm)",
                      smallest["error_bound_mm"].get<double>());
  }
  const json& distance = smallest["euclidean_distance_mm"];
  if (!distance.is_null()) {
    text += formatted("\nEuclidean distance  %.3f to %.3f mm there", distance[0].get<double>(),
                      distance[1].get<double>());
  }
  for (const json& level : summary["impingement"]) {
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
