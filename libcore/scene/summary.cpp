// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "hip/gap_levels.hpp"
#include "scene/asked.hpp"
#include "scene/contact.hpp"
#include "scene/json_values.hpp"
#include "scene/proof_json.hpp"
#include "scene/question.hpp"
#include "scene/report.hpp"

namespace impinge {
namespace {

using nlohmann::json;

json part_json(const std::filesystem::path& file, const JointPart& part, std::size_t met) {
  const MeshReport& mesh = part.validation;
  const StarShapeReport& star = part.star_shape;
  json found{{"file", file.string()},
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
             {"vertices_that_meet_the_other_surface", met}};
  add_taken(part, found);
  return found;
}

json outputs_json(const PoseOutputs& outputs) {
  json names = json::array();
  if (outputs.gaps) names.push_back("gaps");
  if (outputs.bounds) names.push_back("bounds");
  if (outputs.distances) names.push_back("distances");
  if (outputs.verdicts) names.push_back("verdicts");
  return names;
}

json cartilage_json(const SceneOptions& options, const Joint& joint) {
  if (!joint.cartilage) return nullptr;
  const auto [least, most] = std::ranges::minmax(joint.cartilage->thickness);
  return {{"file", options.cartilage_map->string()},
          {"points", joint.cartilage->thickness.size()},
          {"thinnest_mm", least},
          {"thickest_mm", most}};
}

// Unit vectors of the joint frame.
json dial_json(const std::optional<ClockFace>& dial) {
  if (!dial) return nullptr;
  const auto vector = [](const Vec3& x) { return json::array({x.x(), x.y(), x.z()}); };
  return {{"twelve", vector(dial->twelve)}, {"three", vector(dial->three)}};
}

json smallest_json(const SessionJoint& joint, const PoseAnswer& found) {
  if (!found.smallest) return nullptr;
  const SmallestOfPose& smallest = *found.smallest;
  const SurfaceAnswer& of = found.of(smallest.surface);
  const std::size_t i = smallest.vertex;
  json distance;
  if (!of.distance.empty()) distance = interval_json(of.distance[i].lower_mm, of.distance[i].upper_mm);
  return {{"gap_mm", smallest.gap_mm},
          {"error_bound_mm", of.bound.empty() ? json(nullptr) : number_json(of.bound[i])},
          {"euclidean_distance_mm", distance},
          {"surface", name(smallest.surface)},
          {"vertex", i},
          {"position", point_json(smallest.place + joint.joint.centre)},
          {"clock", smallest.hours ? json(clock_text(*smallest.hours)) : json(nullptr)}};
}

// Area by gap; null if the surface was not scanned.
json histogram_json(const SurfaceAnswer& found) {
  if (found.gap.empty()) return nullptr;
  return {{"area_mm2", found.histogram.area},
          {"below_mm2", found.histogram.below},
          {"beyond_mm2", found.histogram.beyond},
          {"without_gap_mm2", found.histogram.without}};
}

// Null of a joint without parts.
json nearest_json(const std::optional<NearestPartDocument>& part, const Joint& joint) {
  if (!part) return nullptr;
  json found{{"distance_mm", part->distance_mm}, {"touch", part->touch}};
  add_part_names(joint, part->ball_part.value_or(""), part->socket_part.value_or(""), found);
  return found;
}

json impinged_json(const SessionJoint& joint, const GapSummary& found, const std::vector<ClockZone>& zones) {
  json clock_zones;
  if (joint.dial) clock_zones = json::array();
  for (const ClockZone& zone : zones)
    clock_zones.push_back(
        {{"from", clock_text(zone.from)}, {"to", clock_text(zone.to)}, {"area_mm2", zone.area}});
  return {{"vertices", found.impinged}, {"area_mm2", found.impinged_area}, {"clock_zones", clock_zones}};
}

// Vertices, area and stretches of the dial with bone on bone, and where the layers of cartilage touch.
json impingement_json(const SessionJoint& joint, const PoseAnswer& found) {
  const SurfaceAnswer& ball = found.ball;
  const SurfaceAnswer& socket = found.socket;
  json levels = json::array({{{"gap_up_to_mm", 0.0},
                              {"meaning", "bone on bone"},
                              {"ball", impinged_json(joint, ball.bone, ball.bone_zones)},
                              {"socket", impinged_json(joint, socket.bone, socket.bone_zones)}}});
  if (ball.touching == 0.0) return levels;
  levels.push_back({{"gap_up_to_mm", joint.joint.cartilage ? json(nullptr) : json(ball.touching)},
                    {"meaning", "cartilage on cartilage"},
                    {"ball", impinged_json(joint, ball.cartilage, ball.cartilage_zones)},
                    {"socket", impinged_json(joint, socket.cartilage, socket.cartilage_zones)}});
  return levels;
}

// Colours and where they end: of a map as shares of its thickness.
json levels_json(Surface surface, const SurfaceAnswer& found, bool map) {
  json levels = json::array();
  for (const GapLevel& level : gap_levels(surface, found.touching)) {
    levels.push_back({{map ? "up_to_share_of_cartilage" : "up_to_mm", number_json(level.up_to_mm)},
                      {"meaning", level.meaning},
                      {"rgb", level.colour}});
  }
  return levels;
}

// Work that this scene did not need, and why.
json left_out(const Joint& joint, const std::vector<LeftOut>& planned) {
  json items = left_out_json(planned);
  if (edge_on_faces(joint)) items.push_back(kEdgeOnLeftOut);
  return items;
}

json times_json(const Measurement& found) {
  return {{"fill_tables", found.fill_ms},
          {"scan", found.scan_ms},
          {"error_bounds", found.bound_ms},
          {"euclidean_distances", found.distance_ms},
          {"radial_overlap", found.certificate ? json(1000.0 * found.certificate->seconds) : json(nullptr)}};
}

}  // namespace

nlohmann::json summary(const SceneOptions& options, const SessionJoint& joint, const Measurement& found) {
  const Joint& read = joint.joint;
  const bool map = read.cartilage.has_value();
  const GapHistogram bins;
  json report = asked_json(options, read);
  report.update({{"ball", part_json(options.ball, read.ball, found.ball.all.met)},
                 {"socket", part_json(options.socket, read.socket, found.socket.all.met)},
                 {"outputs", outputs_json(options.outputs)},
                 // null for 0: of the faces.
                 {"precision_deg", found.precision_deg > 0.0 ? json(found.precision_deg) : json(nullptr)},
                 {"entries_per_table", found.entries},
                 {"table_bytes", found.bytes},
                 {"cartilage_mm", map ? json(nullptr) : json(options.cartilage_mm)},
                 {"cartilage_map", cartilage_json(options, read)},
                 {"dial", dial_json(joint.dial)},
                 {"smallest_gap", smallest_json(joint, found)},
                 {"nearest_part", nearest_json(found.part, read)},
                 {"gap_histogram",
                  {{"first_mm", bins.first},
                   {"bin_mm", bins.width},
                   {"ball", histogram_json(found.ball)},
                   {"socket", histogram_json(found.socket)}}},
                 {"impingement", impingement_json(joint, found)},
                 {"error_bound_mm", bounds_json(found.proven)},
                 {"euclidean_distance_mm", distances_json(found)},
                 {"contact", found.contact ? contact_json(read, *found.contact) : json(nullptr)},
                 {"radial_overlap", certificate_json(found.certificate)},
                 {"colours",
                  {{"ball", levels_json(Surface::ball, found.ball, map)},
                   {"socket", levels_json(Surface::socket, found.socket, map)},
                   {"no_gap_rgb", kNoGapColour}}},
                 {"way", found.way},
                 {"left_out", left_out(read, found.left_out)},
                 {"times_ms", times_json(found)}});
  return report;
}

}  // namespace impinge
