// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/limits.hpp"

#include <algorithm>

#include "command/question_command.hpp"
#include "files/formatted.hpp"
#include "files/rows.hpp"

namespace impinge {
namespace {

std::string bracket(const TurnLimit& limit) {
  std::string low = rounded_down(limit.low_deg, 1);
  switch (limit.state) {
    case LimitState::limited:
      return low;
    case LimitState::blocked:
      return "blocked";
    case LimitState::free:
      return "free to " + low;
    case LimitState::unknown:
      break;
  }
  return "free to " + low + ", unknown beyond";
}

// Such as "20.8 to 61.9 degrees".
std::string range_text(const CentreInterval& range) {
  const std::string from = rounded_down(range.low_deg, 1);
  if (!range.limited) return range.low_deg > 0.0 ? "none before " + from + " degrees" : "unknown";
  return from + " to " + rounded_up(range.high_deg, 1) + " degrees";
}

std::string row_of(const std::vector<std::string>& cells) {
  constexpr std::size_t kColumns[] = {25, 40, 64, 72, 91};
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    line += cells[k];
    if (k + 1 < cells.size()) line.resize(std::max(line.size() + 1, kColumns[k]), ' ');
  }
  return line.erase(line.find_last_not_of(' ') + 1) + "\n";
}

std::string kind_of(const LimitsAnswer& found) { return found.rim ? "rim alone" : "bone on bone"; }

// A line for each motion: contact about the ball's centre, and the gap of the cartilage if one is given.
std::string table_of(const LimitsAnswer& found) {
  const auto with_gap = [](const LimitAnswer& limit) { return limit.told.threshold_mm > 0.0; };
  const bool any_gap = std::any_of(found.limits.begin(), found.limits.end(), with_gap);
  const auto row = [any_gap](std::vector<std::string> cells) {
    if (!any_gap) cells.erase(cells.end() - 2);
    return row_of(cells);
  };
  std::string text =
      row({"limits, degrees", kind_of(found), formatted("centres within %g mm", found.centre_within_mm),
           "o'clock", "gap of cartilage", "what meets, and doubts"});
  for (const LimitAnswer& limit : found.limits) {
    if (with_gap(limit) || limit.centre == "socket") continue;
    const auto gap = std::find_if(found.limits.begin(), found.limits.end(), [&](const LimitAnswer& other) {
      return other.motion == limit.motion && with_gap(other);
    });
    const bool limited = limit.told.limit.state == LimitState::limited;
    text += row({limit.motion, bracket(limit.told.limit), limited ? range_text(limit.told.common) : "",
                 limit.clock().value_or(""), gap == found.limits.end() ? "" : bracket(gap->told.limit),
                 limit.what()});
  }
  return text;
}

std::string sentence(const LimitAnswer& of) {
  const TurnLimit& limit = of.told.limit;
  const std::string low = rounded_down(limit.low_deg, 1);
  switch (limit.state) {
    case LimitState::free:
      return "none up to " + low + " degrees";
    case LimitState::blocked:
      return "reached at the start" + (of.meets() ? ", " + *of.meets() : "");
    case LimitState::limited:
      return "between " + rounded_down(limit.low_deg, 4) + " and " + rounded_up(limit.high_deg, 4) +
             " degrees" + (of.hours ? " at " + clock_text(*of.hours) + " o'clock" : "") + ", " +
             of.meets().value_or("");
    case LimitState::unknown:
      break;
  }
  if (limit.leaves_mesh_deg && *limit.leaves_mesh_deg <= limit.low_deg)
    return "leaves the ball's mesh at " + low + " degrees, none before; unknown beyond";
  return "none up to " + low + " degrees, where surfaces graze; unknown beyond";
}

// Lines below a limit: what half a millimetre changes, and what more of the ball would change.
std::string doubts(const ToldLimit& told, double within_mm) {
  const TurnLimit& limit = told.limit;
  if (limit.state == LimitState::blocked) return "";
  const std::string below = "\n                    ";
  std::string text = below + formatted("any centre within %g mm: ", within_mm) + range_text(told.common) +
                     formatted("; play of the ball up to %g mm: ", within_mm) + range_text(told.play);
  if (told.half_mm_gap_deg)
    text += below + formatted("the gap falls to %g mm at ", within_mm) +
            rounded_down(*told.half_mm_gap_deg, 1) + " degrees";
  if (told.hangs_on_less()) text += formatted(": this answer is sensitive to less than %g mm", within_mm);
  if (limit.state == LimitState::limited && limit.leaves_mesh_deg)  // with more of the ball it stays impinged
    text += below + "the ball's mesh ends under the socket from " + rounded_down(*limit.leaves_mesh_deg, 1) +
            " degrees on: what is missing may come first";
  return text;
}

std::string details_of(const LimitsAnswer& found) {
  std::string text = "limit               of " + found.limits.front().motion + "\n";
  for (const LimitAnswer& limit : found.limits) {
    std::string label =
        limit.told.threshold_mm > 0.0 ? formatted("gap of %g mm", limit.told.threshold_mm) : kind_of(found);
    label.resize(std::max(label.size() + 1, std::size_t{20}), ' ');
    text += label + sentence(limit) + ", about the centre of the " + std::string(limit.centre) +
            doubts(limit.told, found.centre_within_mm) + "\n";
  }
  return text;
}

Told told(Session& session, const LimitsRequest& request, const Work& /*work*/) {
  const LimitsAnswer found = answer(session, request);
  Told told{.words = describe(found), .document = json_of(found), .table_name = "limits.csv"};
  told.table.columns = columns_of<LimitRow>();
  for (const LimitAnswer& limit : found.limits) told.table.add_row(cells_of<LimitRow>(limit));
  return told;
}

}  // namespace

std::string describe(const LimitsAnswer& found) {
  const bool one = std::all_of(found.limits.begin(), found.limits.end(), [&](const LimitAnswer& limit) {
    return limit.motion == found.limits.front().motion;
  });
  std::string text = one ? details_of(found) : table_of(found);
  if (found.rim_in_head_mm)
    text += "rim                 in the head as scanned, up to " + rounded_up(*found.rim_in_head_mm, 1) +
            " mm deep: there it meets the neck late, or not at all; see --overlap\n";
  return text;
}

QuestionCommand limits_question() {
  return question_of<LimitsRequest, LimitsAnswer>(
      "limits",
      "How far the joint turns before its bones meet, what meets what, and over which centres that holds.",
      "femur.ply pelvis.ply --side right", &told);
}

}  // namespace impinge
