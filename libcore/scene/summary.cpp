// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "gap/gap_histogram.hpp"
#include "gap/gap_summary.hpp"
#include "scene/asked.hpp"
#include "scene/impingement_json.hpp"
#include "scene/json_values.hpp"
#include "scene/proof_json.hpp"
#include "scene/question.hpp"
#include "scene/report.hpp"

namespace impinge {
namespace {

using nlohmann::json;

json part_json(const ReportedSurface& v) {
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

json outputs_json(const SceneOutputs& outputs) {
  json names = json::array();
  if (outputs.gaps) names.push_back("gaps");
  if (outputs.bounds) names.push_back("bounds");
  if (outputs.distances) names.push_back("distances");
  if (outputs.verdicts) names.push_back("verdicts");
  return names;
}

// null for 0: with an accuracy asked for, each gap has what is cheapest.
json positive_json(double value) { return value > 0.0 ? json(value) : json(nullptr); }

json cartilage_json(const SceneOptions& options, const Joint& joint) {
  if (!joint.cartilage) return nullptr;
  const auto [least, most] = std::ranges::minmax(joint.cartilage->thickness);
  return {{"file", options.cartilage_map->string()},
          {"points", joint.cartilage->thickness.size()},
          {"thinnest_mm", least},
          {"thickest_mm", most}};
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

}  // namespace

nlohmann::json summary(const SceneOptions& options, const Joint& joint, const Measurement& measurement) {
  const ReportedSurface ball = reported(Surface::ball, options, joint, measurement);
  const ReportedSurface socket = reported(Surface::socket, options, joint, measurement);
  const Eigen::Matrix3d axes = input_to_joint(options.axes);
  TriangleMesh in_joint_frame = joint.socket.mesh;
  for (Vec3& x : in_joint_frame.vertices) x = axes * x;
  const Whereabouts where{joint.centre, clock_face(in_joint_frame), axes};

  nlohmann::json thresholds = nlohmann::json::array();
  for (const double threshold : {0.0, ball.touching}) {
    if (threshold == 0.0 && !thresholds.empty()) continue;
    const bool by_map = joint.cartilage && threshold > 0.0;
    thresholds.push_back({{"gap_up_to_mm", by_map ? nlohmann::json(nullptr) : nlohmann::json(threshold)},
                          {"meaning", threshold == 0.0 ? "bone on bone" : "cartilage on cartilage"},
                          {"ball", impingement_json(ball, threshold, where)},
                          {"socket", impingement_json(socket, threshold, where)}});
  }
  const nlohmann::json smallest = smaller(smallest_json(ball, where), smallest_json(socket, where));
  const GapHistogram bins;
  json report = asked_json(options, joint);
  report.update(
      {{"ball", part_json(ball)},
       {"socket", part_json(socket)},
       {"outputs", outputs_json(options.outputs)},
       {"precision_deg", positive_json(measurement.precision_deg)},
       {"entries_per_table", measurement.entries},
       {"table_bytes", measurement.bytes},
       {"cartilage_mm", joint.cartilage ? nlohmann::json(nullptr) : nlohmann::json(options.cartilage_mm)},
       {"cartilage_map", cartilage_json(options, joint)},
       {"dial", dial_json(where.dial)},
       {"smallest_gap", smallest},
       {"gap_histogram",
        {{"first_mm", bins.first},
         {"bin_mm", bins.width},
         {"ball", histogram_json(ball)},
         {"socket", histogram_json(socket)}}},
       {"impingement", thresholds},
       {"error_bound_mm", bounds_json(ball, socket, measurement.smallest)},
       {"euclidean_distance_mm", distances_json(ball, socket)},
       {"certificate", certificate_json(measurement.certificate)},
       {"colours",
        {{"ball", levels_json(ball, joint.cartilage.has_value())},
         {"socket", levels_json(socket, joint.cartilage.has_value())},
         {"no_gap_rgb", kNoGapColour}}},
       {"way", measurement.way},
       {"left_out", left_out(joint, measurement.left_out)},
       {"warnings", warnings_json(joint, measurement, smallest)},
       {"times_ms",
        {{"fill_tables", measurement.fill_ms},
         {"scan", measurement.scan_ms},
         {"error_bounds", measurement.bound_ms},
         {"euclidean_distances", measurement.distance_ms},
         {"certificate", measurement.certificate ? nlohmann::json(1000.0 * measurement.certificate->seconds)
                                                 : nlohmann::json(nullptr)}}}});
  return report;
}

}  // namespace impinge
