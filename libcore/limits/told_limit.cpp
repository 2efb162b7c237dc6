// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/told_limit.hpp"

#include "files/formatted.hpp"
#include "hip/length_unit.hpp"

namespace impinge {
namespace {

// mm: of a ball that reaches less far, as one in metres, nothing is told for other centres, since all pairs
// of faces may meet about some.
constexpr double kLeastReach = 4.0 * kErrorOfInput;

std::optional<double> first_reached(const TurnLimit& limit) {
  const bool reached = limit.state == LimitState::limited || limit.state == LimitState::blocked;
  return reached ? std::optional(limit.low_deg) : std::nullopt;
}

}  // namespace

bool ToldLimit::hangs_on_centre() const {
  const bool ends = limit.state == LimitState::limited || limit.state == LimitState::blocked;
  const bool later = !common.limited || common.high_deg - limit.high_deg > kOfNote;
  return (ends && later) || limit.low_deg - common.low_deg > kOfNote;
}

bool ToldLimit::hangs_on_play() const {
  if (limit.state == LimitState::blocked || !half_mm_gap_deg) return false;
  return limit.state != LimitState::limited || limit.low_deg - *half_mm_gap_deg > kOfNote;
}

std::string ToldLimit::sensitivity() const {
  if (!hangs_on_less()) return {};
  return formatted("sensitive to %g mm of ", kErrorOfInput) + (!hangs_on_play()    ? "the centre"
                                                               : hangs_on_centre() ? "the centre and of play"
                                                                                   : "play");
}

ToldLimit told_limit(const TurnLimits& limits, const JointTurn& turn, double threshold_mm,
                     double largest_deg) {
  ToldLimit told;
  const bool contact = threshold_mm == 0.0;
  told.threshold_mm = threshold_mm;
  told.limit =
      contact ? limits.first_contact(turn, largest_deg) : limits.gap_of(turn, threshold_mm, largest_deg);
  told.common = told.play = {0.0, largest_deg, false};
  if (reach_of(limits.meshes().ball).farthest > kLeastReach) {
    CentreQuestion question{CentreDoubt::common, kErrorOfInput, threshold_mm};
    told.common = limits.centre_interval(turn, told.limit, largest_deg, question);
    question.doubt = CentreDoubt::play;
    told.play = limits.centre_interval(turn, told.limit, largest_deg, question);
  }
  if (contact) told.half_mm_gap_deg = first_reached(limits.gap_of(turn, kErrorOfInput, largest_deg));
  // At a limit itself bones touch, without such a gap before; beyond low nothing is known.
  const bool at_limit = told.limit.state == LimitState::limited && told.half_mm_gap_deg == told.limit.low_deg;
  if (at_limit || told.half_mm_gap_deg > told.limit.low_deg) told.half_mm_gap_deg.reset();
  return told;
}

}  // namespace impinge
