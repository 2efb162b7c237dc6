// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "hip/gap_levels.hpp"
#include "joint/document.hpp"
#include "sphere/scheme_choice.hpp"

namespace impinge {
namespace {

constexpr const char* kEdgeOn = "faces whose plane holds the centre: they cover no direction";

PoseOutputs outputs_of(const std::vector<Output>& asked) {
  const auto has = [&asked](Output output) {
    return asked.empty() || std::find(asked.begin(), asked.end(), output) != asked.end();
  };
  return {has(Output::gaps), has(Output::bounds), has(Output::distances), has(Output::verdicts)};
}

PoseQuestion question_of(const GapsRequest& request) {
  PoseQuestion asked;
  asked.motion = request.pose;
  asked.max_error_mm = request.max_error_mm;
  asked.cartilage_mm = request.cartilage_mm;
  asked.scan_ball = request.surfaces != Scanned::socket;
  asked.scan_socket = request.surfaces != Scanned::ball;
  asked.outputs = outputs_of(request.outputs);
  if (request.scheme || request.precision_deg)
    asked.precision_deg = request.precision_deg.value_or(kUsualPrecision);
  if (request.scheme) asked.scheme = *request.scheme;
  return asked;
}

SmallestGapDocument smallest_of(const SessionJoint& joint, const Measurement& found) {
  const SmallestOfPose& smallest = *found.smallest;
  const SurfaceAnswer& of = found.of(smallest.surface);
  const std::size_t i = smallest.vertex;
  SmallestGapDocument gap{.gap_mm = smallest.gap_mm,
                          .error_bound_mm = {},
                          .euclidean_distance_mm = {},
                          .surface = smallest.surface,
                          .vertex = i,
                          .position = smallest.place + joint.joint.centre,
                          .clock = {}};
  if (!of.bound.empty()) gap.error_bound_mm = of.bound[i];
  if (!of.distance.empty()) gap.euclidean_distance_mm = {of.distance[i].lower_mm, of.distance[i].upper_mm};
  if (smallest.hours) gap.clock = clock_text(*smallest.hours);
  return gap;
}

ImpingedDocument impinged_of(const SessionJoint& joint, const GapSummary& found,
                             const std::vector<ClockZone>& zones) {
  ImpingedDocument impinged{found.impinged, found.impinged_area, {}};
  if (!joint.dial) return impinged;
  impinged.clock_zones.emplace();
  for (const ClockZone& zone : zones)
    impinged.clock_zones->push_back({clock_text(zone.from), clock_text(zone.to), zone.area});
  return impinged;
}

std::vector<ImpingementDocument> impingement_of(const SessionJoint& joint, const PoseAnswer& found) {
  const auto& [ball, socket] = std::tie(found.ball, found.socket);
  std::vector<ImpingementDocument> levels{{0.0, "bone on bone",
                                           impinged_of(joint, ball.bone, ball.bone_zones),
                                           impinged_of(joint, socket.bone, socket.bone_zones)}};
  if (ball.touching == 0.0) return levels;
  levels.push_back({joint.joint.cartilage ? std::nullopt : std::optional(ball.touching),
                    "cartilage on cartilage", impinged_of(joint, ball.cartilage, ball.cartilage_zones),
                    impinged_of(joint, socket.cartilage, socket.cartilage_zones)});
  return levels;
}

std::optional<HistogramDocument> histogram_of(const SurfaceAnswer& found) {
  if (found.gap.empty()) return std::nullopt;
  return HistogramDocument{found.histogram.area, found.histogram.below, found.histogram.beyond,
                           found.histogram.without};
}

BoundsDocument bounds_of(const PoseVerdicts& proven) {
  return {proven.largest_mm,
          proven.median_mm,
          proven.unbounded,
          {proven.smallest.low, proven.smallest.high},
          proven.smallest.measured};
}

DistancesDocument distances_of(const PoseAnswer& found) {
  constexpr double kOverstated = 1.1;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  DistancesDocument distances{{kNone, kNone}, 0, 1.0};
  for (const SurfaceAnswer* of : {&found.ball, &found.socket}) {
    for (std::size_t i = 0; i < of->gap.size(); ++i) {
      const DistanceBracket& distance = of->distance[i];
      distances.smallest_between_mm[0] = std::min(distances.smallest_between_mm[0], distance.lower_mm);
      distances.smallest_between_mm[1] = std::min(distances.smallest_between_mm[1], distance.upper_mm);
      const double bound = of->bound.empty() ? 0.0 : of->bound[i];
      const double ratio = (std::abs(of->gap[i]) - bound) / distance.upper_mm;
      if (std::isnan(ratio)) continue;
      distances.largest_gap_over_it = std::max(distances.largest_gap_over_it, ratio);
      if (ratio > kOverstated) ++distances.gaps_above_it_by_a_tenth;
    }
  }
  return distances;
}

VerdictsDocument verdicts_of_vertices(const VertexVerdicts& found) {
  return {found.impinged,           found.by_bound.clear, found.by_bound.impinged,
          found.by_bound.undecided, found.without_gap,    found.refuted};
}

RadialOverlapDocument overlap_of(const Certificate& found) {
  RadialOverlapDocument overlap{.overlap = found.surfaces_impinged,
                                .deepest_mm = {},
                                .deepest_at = {},
                                .ball = verdicts_of_vertices(found.ball),
                                .socket = verdicts_of_vertices(found.socket)};
  if (!found.deepest) return overlap;
  overlap.deepest_mm = found.deepest->depth;
  overlap.deepest_at = found.deepest->kind;
  return overlap;
}

std::vector<LevelDocument> levels_of(Surface surface, const SurfaceAnswer& found) {
  std::vector<LevelDocument> levels;
  for (const GapLevel& level : gap_levels(surface, found.touching)) {
    LevelDocument one{std::nullopt, level.meaning, {level.colour[0], level.colour[1], level.colour[2]}};
    if (std::isfinite(level.up_to_mm)) one.up_to = level.up_to_mm;
    levels.push_back(one);
  }
  return levels;
}

std::vector<LeftOutDocument> left_out_of(const Joint& joint, const Measurement& found) {
  std::vector<LeftOutDocument> items;
  for (const LeftOut& item : found.left_out) {
    items.push_back({std::string(item.what), std::string(item.meaning), item.reason,
                     item.bytes_saved == 0.0 ? std::nullopt : std::optional(item.bytes_saved)});
  }
  if (joint.ball.star_shape.edge_on + joint.socket.star_shape.edge_on > 0)
    items.push_back({"edge_on_faces", kEdgeOn, "", {}});
  return items;
}

}  // namespace

void GapsRequest::check() const {
  const PoseQuestion asked = question_of(*this);
  if (asked.by_tables() && max_error_mm)
    throw std::invalid_argument(
        "max_error_mm: is of gaps of the faces, and a scheme or precision asks for tables; leave one out");
  const PoseOutputs& compared = asked.outputs;
  if (surfaces != Scanned::both && (compared.bounds || compared.distances || compared.verdicts))
    throw std::invalid_argument(
        "surfaces: one alone has neither bounds, distances nor verdicts; ask for the outputs gaps alone");
  if (scheme) in_field("scheme", [&] { with_scheme(*scheme, []<class S>() {}); });
  if (asked.by_tables())
    in_field("precision_deg",
             [&] { with_scheme(asked.scheme, [&]<class S>() { S::with_precision(*asked.precision_deg); }); });
}

GapsAnswer answer(Session& session, const GapsRequest& request) {
  request.check();
  const PoseQuestion asked = question_of(request);
  GapsAnswer answer;
  answer.found = measure(session, asked);
  const SessionJoint& joint = *session.joint;
  const Measurement& found = answer.found;
  if (found.contact) answer.contact = contact_of(joint.joint, *found.contact);
  if (found.smallest) answer.smallest_gap = smallest_of(joint, found);
  answer.nearest_part = found.part;
  if (found.certificate) answer.radial_overlap = overlap_of(*found.certificate);
  answer.impingement = impingement_of(joint, found);
  const GapHistogram bins;
  answer.gap_histogram = {bins.first, bins.width, histogram_of(found.ball), histogram_of(found.socket)};
  if (found.proven) answer.error_bound = bounds_of(*found.proven);
  if (!found.ball.distance.empty()) answer.euclidean_distance = distances_of(found);
  answer.vertices_with_gap = {found.ball.all.met, found.socket.all.met};
  if (found.precision_deg > 0.0) answer.precision_deg = found.precision_deg;
  answer.entries_per_table = found.entries;
  answer.table_bytes = found.bytes;
  if (joint.dial) answer.dial = {joint.dial->twelve, joint.dial->three};
  answer.colours = {levels_of(Surface::ball, found.ball),
                    levels_of(Surface::socket, found.socket),
                    {kNoGapColour[0], kNoGapColour[1], kNoGapColour[2]}};
  answer.way = found.way;
  answer.left_out = left_out_of(joint.joint, found);
  return answer;
}

}  // namespace impinge
