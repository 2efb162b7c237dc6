// SPDX-License-Identifier: GPL-3.0-or-later
// All gaps of a pose, and what follows from them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "contact/euclidean_distance.hpp"
#include "files/fields.hpp"
#include "gap/gap_histogram.hpp"
#include "gap/gap_summary.hpp"
#include "gap/measured_gap.hpp"
#include "hip/gap_levels.hpp"
#include "joint/certificate.hpp"
#include "joint/needed_work.hpp"
#include "joint/touch.hpp"
#include "sphere/infinity.hpp"

namespace impinge {

/// Whose vertices are asked about.
enum class Scanned { both, ball, socket };
template <>
inline constexpr std::array<std::string_view, 3> words_of<Scanned>{"both", "ball", "socket"};

/// What is worked out besides the summaries.
enum class Output { gaps, bounds, distances, verdicts };
template <>
inline constexpr std::array<std::string_view, 4> words_of<Output>{"gaps", "bounds", "distances", "verdicts"};

struct GapsRequest {
  Motion pose;
  std::optional<std::string> scheme;
  std::optional<double> precision_deg;
  std::optional<double> max_error_mm;
  Scanned surfaces = Scanned::both;
  std::vector<Output> outputs;
  double cartilage_mm = 4.0;

  static constexpr std::tuple fields{
      Field{"pose", "", "of the ball, as flexion=90,internal_rotation=10", &GapsRequest::pose},
      Field{"scheme", "", "read gaps from tables of this sampling scheme, not from the faces",
            &GapsRequest::scheme},
      Field{"precision_deg", "deg", "spacing of the tables; also turns tables on [0.5 with a scheme]",
            &GapsRequest::precision_deg, kPositive},
      Field{"max_error_mm", "mm",
            "refuse an answer unless each gap is proven to be within this error; not with tables",
            &GapsRequest::max_error_mm, kPositive},
      Field{"surfaces", "", "whose vertices are measured", &GapsRequest::surfaces},
      Field{"outputs", "", "only these are worked out [all]", &GapsRequest::outputs},
      Field{"cartilage_mm", "mm", "thickness of both layers together", &GapsRequest::cartilage_mm,
            kNotNegative}};
  /// Throws std::invalid_argument for options that exclude each other.
  void check() const;

  bool asks(Output output) const { return outputs.empty() || std::ranges::count(outputs, output) > 0; }
  bool asks_bounds() const { return asks(Output::bounds) || asks(Output::verdicts); }  // verdicts need bounds
  bool scans(Surface of) const { return surfaces != (of == Surface::ball ? Scanned::socket : Scanned::ball); }
  /// Are tables used? Only if asked for: for one pose the faces are faster than filling a table.
  bool by_tables() const { return scheme || precision_deg; }
  std::string scheme_name() const { return scheme.value_or("rsid"); }  // scheme of the tables
  double precision() const { return precision_deg.value_or(0.5); }     // precision of the tables, degrees
};

template <>
inline constexpr std::tuple fields_of<ClockZone>{
    Field{"clock_from", "", "on the rim's clock",
          [](const ClockZone& zone) { return clock_text(zone.from); }},
    Field{"clock_to", "", "on the rim's clock", [](const ClockZone& zone) { return clock_text(zone.to); }},
    Field{"area_mm2", "mm^2", "in this stretch", &ClockZone::area}};

template <>
inline constexpr std::tuple fields_of<ClockFace>{
    Field{"twelve", "1", "direction of twelve o'clock: right, anterior, superior", &ClockFace::twelve},
    Field{"three", "1", "direction of three o'clock", &ClockFace::three}};

template <>
inline constexpr std::tuple fields_of<GapHistogram>{
    Field{"area_mm2", "mm^2", "of each bin", &GapHistogram::area},
    Field{"below_mm2", "mm^2", "of smaller gaps", &GapHistogram::below},
    Field{"beyond_mm2", "mm^2", "of larger gaps", &GapHistogram::beyond},
    Field{"without_gap_mm2", "mm^2", "where the other surface is not met", &GapHistogram::without}};

template <>
inline constexpr std::tuple fields_of<GapLevel>{
    Field{"up_to", "", "mm, or of a cartilage map the share of its thickness; null for the last",
          [](const GapLevel& level) {
            return level.up_to_mm < kInfinity ? std::optional(level.up_to_mm) : std::nullopt;
          }},
    Field{"meaning", "", "as a legend says it", &GapLevel::meaning},
    Field{"rgb", "1", "0 to 255", &GapLevel::colour}};

template <>
inline constexpr std::tuple fields_of<LeftOut>{
    Field{"what", "", "in one word", &LeftOut::what},
    Field{"meaning", "", "what that leaves out", &LeftOut::meaning},
    Field{"reason", "", "with the numbers that it rests on", &LeftOut::reason},
    Field{"bytes_saved", "bytes", "of memory; null where none", [](const LeftOut& item) {
            return item.bytes_saved == 0.0 ? std::nullopt : std::optional(item.bytes_saved);
          }}};

/// Vertices with gaps up to a level.
struct Impinged {
  std::size_t vertices = 0;
  double area_mm2 = 0.0;
  std::optional<std::vector<ClockZone>> clock_zones;

  static constexpr std::tuple fields{
      Field{"vertices", "1", "with such a gap", &Impinged::vertices},
      Field{"area_mm2", "mm^2", "of their share of the faces", &Impinged::area_mm2},
      Field{"clock_zones", "", "stretches of the rim's clock, the largest first; null without a clock",
            &Impinged::clock_zones}};
};

struct Impingement {
  std::optional<double> gap_up_to_mm;
  std::string_view meaning;
  Impinged ball;
  Impinged socket;

  static constexpr std::tuple fields{
      Field{"gap_up_to_mm", "mm", "gaps up to this count; null where a map says how thick the cartilage is",
            &Impingement::gap_up_to_mm},
      Field{"meaning", "", "bone on bone, or cartilage on cartilage", &Impingement::meaning},
      Field{"ball", "", "of the ball's vertices", &Impingement::ball},
      Field{"socket", "", "of the socket's vertices", &Impingement::socket}};
};

/// Area of the surface by the size of its gaps.
struct GapHistograms {
  std::optional<GapHistogram> ball;
  std::optional<GapHistogram> socket;

  static constexpr std::tuple fields{
      Field{"first_mm", "mm", "where the first bin begins",
            [](const auto& /*both*/) { return GapHistogram().first; }},
      Field{"bin_mm", "mm", "width of a bin", [](const auto& /*both*/) { return GapHistogram().width; }},
      Field{"ball", "", "null if it was not asked about", &GapHistograms::ball},
      Field{"socket", "", "null if it was not asked about", &GapHistograms::socket}};
};

struct DistancesDocument {
  std::array<double, 2> smallest_between_mm{kInfinity, kInfinity};
  std::size_t gaps_above_it_by_a_tenth = 0;
  double largest_gap_over_it = 1.0;

  static constexpr std::tuple fields{
      Field{"smallest_between_mm", "mm", "proven ends of the smallest distance of a vertex",
            &DistancesDocument::smallest_between_mm},
      Field{"gaps_above_it_by_a_tenth", "1",
            "vertices whose gap overstates their distance by a tenth and more",
            &DistancesDocument::gaps_above_it_by_a_tenth},
      Field{"largest_gap_over_it", "1", "largest ratio of gap and distance",
            &DistancesDocument::largest_gap_over_it}};
};

struct ColoursDocument {
  std::vector<GapLevel> ball;
  std::vector<GapLevel> socket;

  static constexpr std::tuple fields{Field{"ball", "", "of ball.ply", &ColoursDocument::ball},
                                     Field{"socket", "", "of socket.ply", &ColoursDocument::socket},
                                     Field{"no_gap_rgb", "1", "where the other surface is not met",
                                           [](const auto& /*both*/) { return kNoGapColour; }}};
};

/// What the gaps and their bounds prove about a pose. Counts the vertices of both surfaces that have a gap.
struct PoseVerdicts {
  VerdictCount vertices;      // clear, impinged or undecided by their bounds
  std::size_t unbounded = 0;  // undecided vertices without a finite bound
  double largest_mm = 0.0;
  double median_mm = 0.0;    // the upper one if there are two
  SmallestBetween smallest;  // interval of the smallest gap

  static constexpr std::tuple fields{
      Field{"largest_mm", "mm", "finite bound on the error of a gap", &PoseVerdicts::largest_mm},
      Field{"median_mm", "mm", "of the finite bounds", &PoseVerdicts::median_mm},
      Field{"vertices_without_bound", "1", "with a gap, of whose error nothing is proven",
            &PoseVerdicts::unbounded},
      Field{"smallest_gap_between_mm", "mm", "proven ends of the smallest gap",
            [](const auto& proven) {
              return std::array{proven.smallest.low, proven.smallest.high};
            }},
      Field{"vertices_measured_on_the_faces", "1", "to find that out",
            via(&PoseVerdicts::smallest, &SmallestBetween::measured)}};
};

/// Results for the vertices of one surface, one value a vertex; empty if not asked for.
struct SurfaceAnswer {
  std::vector<double> gap;    // mm, NaN where the other surface is not met; empty if it was not scanned
  std::vector<double> bound;  // mm, proven bound on the gap's error; NaN without a gap, infinite if unproven
  std::vector<DistanceBracket> distance;  // Euclidean, from each vertex to the other surface

  std::vector<double> against_cartilage;  // gaps in mm, or as shares of the map's thickness if there is one
  GapSummary all;                         // of `gap`
  Impinged bone;                          // of against_cartilage, up to 0
  Impinged cartilage;                     // of against_cartilage, up to GapsAnswer::touching
  GapHistogram histogram;                 // of the gaps
};

/// Gaps, and all that rests on them, are between the main surfaces: vertices of parts have none. Distances
/// are to any bone of the other side.
struct GapsAnswer {
  Pose pose;              // pose of the ball, with its shift; gaps are for its rotation alone
  SurfaceAnswer ball;     // vertices of the ball against the socket
  SurfaceAnswer socket;   // vertices of the socket against the ball
  double touching = 0.0;  // value of against_cartilage at which the layers touch
  bool by_map = false;    // does a map give the thickness of the cartilage? Then `touching` is 1
  double scan_ms = 0.0;   // both scans
  std::optional<ContactDocument> contact;
  std::optional<SmallestOfPose> smallest_gap;
  std::optional<NearestPartDocument> nearest_part;
  std::optional<Certificate> radial_overlap;
  std::optional<PoseVerdicts> error_bound;
  std::optional<double> precision_deg;
  std::size_t entries_per_table = 0;
  std::size_t table_bytes = 0;
  std::optional<ClockFace> dial;
  std::string_view way;
  std::vector<LeftOut> left_out;

  const SurfaceAnswer& of(Surface surface) const { return surface == Surface::ball ? ball : socket; }
  SurfaceAnswer& of(Surface surface) { return surface == Surface::ball ? ball : socket; }
  std::vector<Impingement> impingement() const;
  GapHistograms gap_histogram() const;
  std::optional<DistancesDocument> euclidean_distance() const;
  ColoursDocument colours() const;

  static constexpr std::tuple fields{
      Field{"contact", "", "of all bones, decided exactly; null if not asked for", &GapsAnswer::contact},
      Field{"smallest_gap", "", "of a vertex of the main surfaces; null where they do not face each other",
            &GapsAnswer::smallest_gap},
      Field{"nearest_part", "",
            "the bones nearest to each other of which one is a part; null without parts, distances and "
            "verdicts",
            &GapsAnswer::nearest_part},
      Field{"radial_overlap", "",
            "of the main surfaces along rays, which is no contact by itself; null if not asked for",
            &GapsAnswer::radial_overlap},
      Field{"impingement", "", "bone on bone, and cartilage on cartilage", &GapsAnswer::impingement},
      Field{"gap_histogram", "", "area by gap", &GapsAnswer::gap_histogram},
      Field{"error_bound", "", "what is proven of the gaps' errors; null if not asked for",
            &GapsAnswer::error_bound},
      Field{"euclidean_distance", "", "beside the gaps; null if not asked for",
            &GapsAnswer::euclidean_distance},
      Field{"vertices_with_gap", "1", "of ball and socket",
            [](const auto& found) {
              return std::array{found.ball.all.met, found.socket.all.met};
            }},
      Field{"precision_deg", "deg", "of the tables; null where the faces were measured",
            &GapsAnswer::precision_deg},
      Field{"entries_per_table", "1", "0 without tables", &GapsAnswer::entries_per_table},
      Field{"table_bytes", "bytes", "of both tables", &GapsAnswer::table_bytes},
      Field{"dial", "", "where the rim's clock looks; null without one", &GapsAnswer::dial},
      Field{"colours", "", "of the meshes that are written", &GapsAnswer::colours},
      Field{"way", "", "how the gaps were found, and why so", &GapsAnswer::way},
      Field{"left_out", "", "what the question did not need", &GapsAnswer::left_out}};
};

/// Finds all gaps in a pose, either on the faces (gap/measured_gap.hpp) or by a table in double of each
/// surface. A table is filled completely only for bounds and verdicts (joint/needed_work.hpp). Throws
/// std::runtime_error, one line, if the tables do not fit in memory (it names the bytes that they would take)
/// or max_error_mm is less than rounding allows; std::invalid_argument for options that exclude each other.
GapsAnswer answer(Session& session, const GapsRequest& request);

}  // namespace impinge
