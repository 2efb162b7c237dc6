// SPDX-License-Identifier: GPL-3.0-or-later
// The report on one joint: several questions at once, each answered as it is alone.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "joint/gaps.hpp"
#include "joint/limits.hpp"
#include "joint/measures.hpp"
#include "joint/volume.hpp"

namespace impinge {

/// Parts that may be left out.
enum class ReportPart { limits, volume, measures };
template <>
inline constexpr std::array<std::string_view, 3> words_of<ReportPart>{"limits", "volume", "measures"};

struct ReportRequest {
  Motion pose;
  std::vector<ReportPart> without;
  double width = 0.2;
  std::optional<double> cartilage_mm;

  static constexpr std::tuple fields{
      Field{"pose", "", "whose gaps are shown, as flexion=90,internal_rotation=10 [all angles 0]",
            &ReportRequest::pose},
      Field{"without", "", "what is left out; `volume` takes longest [nothing]", &ReportRequest::without},
      Field{"width", "1", "of the volume: share of all rotations that may stay undecided, up to 1",
            &ReportRequest::width, Range{.least = 0.0, .most = 1.0, .above = true}},
      Field{"cartilage_mm", "mm", "thickness of both layers together [4 for gaps, none for limits]",
            &ReportRequest::cartilage_mm, kNotNegative}};
  bool has(ReportPart part) const { return std::ranges::count(without, part) == 0; }
  /// Gaps up to this are asked about, too.
  double threshold_mm() const { return has(ReportPart::limits) ? cartilage_mm.value_or(0.0) : 0.0; }
  static constexpr const char* kThresholdOption = "--cartilage";
};

/// The answers to the questions.
struct ReportAnswer {
  GapsAnswer gaps;
  std::optional<LimitsAnswer> limits;
  std::optional<VolumeAnswer> volume;
  std::optional<MeasureAnswer> measures;

  static constexpr std::tuple fields{
      Field{"gaps", "", "as `impinge gaps` has it, without bounds and distances", &ReportAnswer::gaps},
      Field{"limits", "", "as `impinge limits` has it; null if left out", &ReportAnswer::limits},
      Field{"volume", "", "as `impinge volume` has it; null if left out", &ReportAnswer::volume},
      Field{"measures", "", "as `impinge measure` has it; null if left out", &ReportAnswer::measures}};
};

/// Throws std::invalid_argument without a side, and what its questions throw. `how` is for the volume.
ReportAnswer answer(Session& session, const ReportRequest& request,
                    VolumeSettings how = {.most_cells = kMostVolumeCells});

}  // namespace impinge
