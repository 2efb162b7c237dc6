// SPDX-License-Identifier: GPL-3.0-or-later
// All gaps of a pose, and what follows from them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "files/fields.hpp"
#include "gap/face_overlay.hpp"
#include "joint/measurement.hpp"
#include "joint/touch.hpp"

namespace impinge {

/// Whose vertices are asked about.
enum class Scanned { both, ball, socket };
template <>
inline constexpr std::array<std::string_view, 3> words_of<Scanned>{"both", "ball", "socket"};

/// What is worked out besides summaries.
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

  static constexpr auto fields() {
    using Asked = GapsRequest;
    return std::tuple{
        Field{"pose", "", "of the ball, from the pose of the scan, as flexion=90,internal_rotation=10",
              &Asked::pose},
        Field{"scheme", "", "read gaps from tables of this sampling scheme, not from the faces",
              &Asked::scheme},
        Field{"precision_deg", "deg", "spacing of the tables; also turns tables on [0.5 with a scheme]",
              &Asked::precision_deg, kPositive},
        Field{"max_error_mm", "mm",
              "refuse an answer unless each gap is proven to be within this error; not with tables",
              &Asked::max_error_mm, kPositive},
        Field{"surfaces", "", "whose vertices are measured", &Asked::surfaces},
        Field{"outputs", "", "only these are worked out [all]", &Asked::outputs},
        Field{"cartilage_mm", "mm", "thickness of both layers together", &Asked::cartilage_mm, kNotNegative}};
  }
  /// std::invalid_argument where what is asked does not go together.
  void check() const;
};

/// A stretch of the rim's clock.
struct ZoneDocument {
  std::string from;
  std::string to;
  double area_mm2 = 0.0;

  static constexpr auto fields() {
    using Zone = ZoneDocument;
    return std::tuple{Field{"clock_from", "", "on the rim's clock", &Zone::from},
                      Field{"clock_to", "", "on the rim's clock", &Zone::to},
                      Field{"area_mm2", "mm^2", "in this stretch", &Zone::area_mm2}};
  }
};

struct ImpingedDocument {
  std::size_t vertices = 0;
  double area_mm2 = 0.0;
  std::optional<std::vector<ZoneDocument>> clock_zones;

  static constexpr auto fields() {
    using Impinged = ImpingedDocument;
    return std::tuple{
        Field{"vertices", "1", "with such a gap", &Impinged::vertices},
        Field{"area_mm2", "mm^2", "of their share of the faces", &Impinged::area_mm2},
        Field{"clock_zones", "", "stretches of the rim's clock, the largest first; null without a clock",
              &Impinged::clock_zones}};
  }
};

struct ImpingementDocument {
  std::optional<double> gap_up_to_mm;
  std::string_view meaning;
  ImpingedDocument ball;
  ImpingedDocument socket;

  static constexpr auto fields() {
    using Level = ImpingementDocument;
    return std::tuple{
        Field{"gap_up_to_mm", "mm", "gaps up to this count; null where a map says how thick the cartilage is",
              &Level::gap_up_to_mm},
        Field{"meaning", "", "bone on bone, or cartilage on cartilage", &Level::meaning},
        Field{"ball", "", "of the ball's vertices", &Level::ball},
        Field{"socket", "", "of the socket's vertices", &Level::socket}};
  }
};

/// Area by gap.
struct HistogramDocument {
  std::vector<double> area_mm2;
  double below_mm2 = 0.0;
  double beyond_mm2 = 0.0;
  double without_gap_mm2 = 0.0;

  static constexpr auto fields() {
    using Bins = HistogramDocument;
    return std::tuple{
        Field{"area_mm2", "mm^2", "of each bin", &Bins::area_mm2},
        Field{"below_mm2", "mm^2", "of smaller gaps", &Bins::below_mm2},
        Field{"beyond_mm2", "mm^2", "of larger gaps", &Bins::beyond_mm2},
        Field{"without_gap_mm2", "mm^2", "where the other surface is not met", &Bins::without_gap_mm2}};
  }
};

struct HistogramsDocument {
  double first_mm = 0.0;
  double bin_mm = 0.0;
  std::optional<HistogramDocument> ball;
  std::optional<HistogramDocument> socket;

  static constexpr auto fields() {
    using Both = HistogramsDocument;
    return std::tuple{Field{"first_mm", "mm", "where the first bin begins", &Both::first_mm},
                      Field{"bin_mm", "mm", "width of a bin", &Both::bin_mm},
                      Field{"ball", "", "null if it was not asked about", &Both::ball},
                      Field{"socket", "", "null if it was not asked about", &Both::socket}};
  }
};

struct BoundsDocument {
  double largest_mm = 0.0;
  double median_mm = 0.0;
  std::size_t vertices_without_bound = 0;
  std::array<double, 2> smallest_gap_between_mm{};
  std::size_t vertices_measured_on_the_faces = 0;

  static constexpr auto fields() {
    using Bounds = BoundsDocument;
    return std::tuple{Field{"largest_mm", "mm", "finite bound on the error of a gap", &Bounds::largest_mm},
                      Field{"median_mm", "mm", "of the finite bounds", &Bounds::median_mm},
                      Field{"vertices_without_bound", "1", "with a gap, of whose error nothing is proven",
                            &Bounds::vertices_without_bound},
                      Field{"smallest_gap_between_mm", "mm", "proven ends of the smallest gap",
                            &Bounds::smallest_gap_between_mm},
                      Field{"vertices_measured_on_the_faces", "1", "to find that out",
                            &Bounds::vertices_measured_on_the_faces}};
  }
};

struct DistancesDocument {
  std::array<double, 2> smallest_between_mm{};
  std::size_t gaps_above_it_by_a_tenth = 0;
  double largest_gap_over_it = 0.0;

  static constexpr auto fields() {
    using Found = DistancesDocument;
    return std::tuple{
        Field{"smallest_between_mm", "mm", "proven ends of the smallest distance of a vertex",
              &Found::smallest_between_mm},
        Field{"gaps_above_it_by_a_tenth", "1",
              "vertices whose gap overstates their distance by a tenth and more",
              &Found::gaps_above_it_by_a_tenth},
        Field{"largest_gap_over_it", "1", "largest ratio of gap and distance", &Found::largest_gap_over_it}};
  }
};

/// Of the vertices of one surface (joint/certificate.hpp).
struct VerdictsDocument {
  std::size_t impinged = 0;
  std::size_t clear_by_bound = 0;
  std::size_t impinged_by_bound = 0;
  std::size_t undecided_by_bound = 0;
  std::size_t without_gap = 0;
  std::size_t bounds_refuted = 0;

  static constexpr auto fields() {
    using Count = VerdictsDocument;
    return std::tuple{
        Field{"impinged", "1", "vertices with a gap of 0 or less, exactly", &Count::impinged},
        Field{"clear_by_bound", "1", "vertices that gap and bound prove clear", &Count::clear_by_bound},
        Field{"impinged_by_bound", "1", "and impinged", &Count::impinged_by_bound},
        Field{"undecided_by_bound", "1", "and neither", &Count::undecided_by_bound},
        Field{"without_gap", "1", "vertices without one", &Count::without_gap},
        Field{"bounds_refuted", "1", "verdicts by bound that the exact test contradicts",
              &Count::bounds_refuted}};
  }
};

/// Of the main surfaces, along rays from the centre: no contact by itself.
struct RadialOverlapDocument {
  bool overlap = false;
  std::optional<double> deepest_mm;
  std::optional<OverlayKind> deepest_at;
  VerdictsDocument ball;
  VerdictsDocument socket;

  static constexpr auto fields() {
    using Found = RadialOverlapDocument;
    return std::tuple{
        Field{"overlap", "", "does the ball reach the socket along some ray? Exact, between vertices too",
              &Found::overlap},
        Field{"deepest_mm", "mm", "along a ray; null without overlap", &Found::deepest_mm},
        Field{"deepest_at", "", "what is there", &Found::deepest_at},
        Field{"ball", "", "of its vertices", &Found::ball},
        Field{"socket", "", "of its vertices", &Found::socket}};
  }
};

struct DialDocument {
  Vec3 twelve = Vec3::Zero();
  Vec3 three = Vec3::Zero();

  static constexpr auto fields() {
    return std::tuple{
        Field{"twelve", "1", "direction of twelve o'clock: right, anterior, superior", &DialDocument::twelve},
        Field{"three", "1", "direction of three o'clock", &DialDocument::three}};
  }
};

/// Colours of gaps up to a level.
struct LevelDocument {
  std::optional<double> up_to;
  std::string_view meaning;
  std::array<int, 3> rgb{};

  static constexpr auto fields() {
    using Level = LevelDocument;
    return std::tuple{
        Field{"up_to", "", "mm, or of a cartilage map the share of its thickness; null for the last",
              &Level::up_to},
        Field{"meaning", "", "as a legend says it", &Level::meaning},
        Field{"rgb", "1", "0 to 255", &Level::rgb}};
  }
};

struct ColoursDocument {
  std::vector<LevelDocument> ball;
  std::vector<LevelDocument> socket;
  std::array<int, 3> no_gap_rgb{};

  static constexpr auto fields() {
    using Colours = ColoursDocument;
    return std::tuple{Field{"ball", "", "of ball.ply", &Colours::ball},
                      Field{"socket", "", "of socket.ply", &Colours::socket},
                      Field{"no_gap_rgb", "1", "where the other surface is not met", &Colours::no_gap_rgb}};
  }
};

struct LeftOutDocument {
  std::string what;
  std::string meaning;
  std::string reason;
  std::optional<double> bytes_saved;

  static constexpr auto fields() {
    using Item = LeftOutDocument;
    return std::tuple{Field{"what", "", "in one word", &Item::what},
                      Field{"meaning", "", "what that leaves out", &Item::meaning},
                      Field{"reason", "", "with the numbers that it rests on", &Item::reason},
                      Field{"bytes_saved", "bytes", "of memory; null where none", &Item::bytes_saved}};
  }
};

struct GapsAnswer {
  std::optional<ContactDocument> contact;
  std::optional<SmallestGapDocument> smallest_gap;
  std::optional<NearestPartDocument> nearest_part;
  std::optional<RadialOverlapDocument> radial_overlap;
  std::vector<ImpingementDocument> impingement;
  HistogramsDocument gap_histogram;
  std::optional<BoundsDocument> error_bound;
  std::optional<DistancesDocument> euclidean_distance;
  std::array<std::size_t, 2> vertices_with_gap{};
  std::optional<double> precision_deg;
  std::size_t entries_per_table = 0;
  std::size_t table_bytes = 0;
  std::optional<DialDocument> dial;
  ColoursDocument colours;
  std::string way;
  std::vector<LeftOutDocument> left_out;
  Measurement found;  // by vertex

  static constexpr auto fields() {
    using Gaps = GapsAnswer;
    return std::tuple{
        Field{"contact", "", "of all bones, decided exactly; null if not asked for", &Gaps::contact},
        Field{"smallest_gap", "", "of a vertex of the main surfaces; null where they do not face each other",
              &Gaps::smallest_gap},
        Field{"nearest_part", "",
              "the bones nearest to each other of which one is a part; null without parts",
              &Gaps::nearest_part},
        Field{"radial_overlap", "",
              "of the main surfaces along rays, which is no contact by itself; null if not asked for",
              &Gaps::radial_overlap},
        Field{"impingement", "", "bone on bone, and cartilage on cartilage", &Gaps::impingement},
        Field{"gap_histogram", "", "area by gap", &Gaps::gap_histogram},
        Field{"error_bound", "", "what is proven of the gaps' errors; null if not asked for",
              &Gaps::error_bound},
        Field{"euclidean_distance", "", "beside the gaps; null if not asked for", &Gaps::euclidean_distance},
        Field{"vertices_with_gap", "1", "of ball and socket", &Gaps::vertices_with_gap},
        Field{"precision_deg", "deg", "of the tables; null where the faces were measured",
              &Gaps::precision_deg},
        Field{"entries_per_table", "1", "0 without tables", &Gaps::entries_per_table},
        Field{"table_bytes", "bytes", "of both tables", &Gaps::table_bytes},
        Field{"dial", "", "where the rim's clock looks; null without one", &Gaps::dial},
        Field{"colours", "", "of the meshes that are written", &Gaps::colours},
        Field{"way", "", "how the gaps were found, and why so", &Gaps::way},
        Field{"left_out", "", "what the question did not need", &Gaps::left_out}};
  }
};

/// std::runtime_error, one line, as measure() (joint/measurement.hpp); std::invalid_argument for what does
/// not go together.
GapsAnswer answer(Session& session, const GapsRequest& request);

}  // namespace impinge
