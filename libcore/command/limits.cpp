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

// Such as "20.8 to 61.9".
std::string range_text(const CentreInterval& range, const std::string& unit = "") {
  const std::string from = rounded_down(range.low_deg, 1);
  if (!range.limited) return range.low_deg > 0.0 ? "none before " + from + unit : "unknown";
  return from + " to " + rounded_up(range.high_deg, 1) + unit;
}

// Rows whose columns stand below each other.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> width(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size() + 2);
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) line += row[k] + std::string(width[k] - row[k].size(), ' ');
    text += line.erase(line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string kind_of(const LimitsAnswer& found) { return found.rim ? "rim alone" : "bone on bone"; }

bool of_gap(const LimitAnswer& limit) { return limit.told.threshold_mm > 0.0; }
bool of_socket(const LimitAnswer& limit) { return limit.centre == "socket"; }
bool of_contact(const LimitAnswer& limit) { return !of_gap(limit) && !of_socket(limit); }

// A line for each motion: contact about both centres, and the gap of the cartilage if one is given.
std::string table_of(const LimitsAnswer& found) {
  const bool any_socket = std::any_of(found.limits.begin(), found.limits.end(), of_socket);
  const bool any_gap = std::any_of(found.limits.begin(), found.limits.end(), of_gap);
  const auto row = [&](std::vector<std::string> cells) {
    if (!any_gap) cells.erase(cells.end() - 2);
    if (!any_socket) cells.erase(cells.begin() + 2);
    return cells;
  };
  std::vector<std::vector<std::string>> rows{row({"limits, degrees", kind_of(found), "about socket",
                                                  formatted("centre within %g mm", found.centre_within_mm),
                                                  formatted("play up to %g mm", found.centre_within_mm),
                                                  "o'clock", "gap of cartilage", "what meets, and doubts"})};
  for (const LimitAnswer& limit : found.limits) {
    if (!of_contact(limit)) continue;
    const auto other = [&](bool (*is)(const LimitAnswer&)) {
      const auto at = std::find_if(found.limits.begin(), found.limits.end(), [&](const LimitAnswer& of) {
        return of.motion == limit.motion && is(of);
      });
      return at == found.limits.end() ? "" : bracket(at->told.limit);
    };
    const bool moves = limit.told.limit.state != LimitState::blocked;
    rows.push_back(row({limit.motion, bracket(limit.told.limit), other(&of_socket),
                        moves ? range_text(limit.told.common) : "", moves ? range_text(limit.told.play) : "",
                        limit.clock().value_or(""), other(&of_gap), limit.what()}));
  }
  return aligned(rows);
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
  if (of.unknown_by == UnknownBy::end_of_ball)
    return "leaves the ball's mesh at " + low + " degrees, none before; unknown beyond";
  return "none up to " + low + " degrees; beyond, " +
         (of.unknown_by == UnknownBy::opening
              ? "whether one bone is inside the other hangs on an opening of a mesh"
              : "unknown since surfaces graze there");
}

// Lines below a limit: what half a millimetre changes, and what more of the ball would change.
std::string doubts(const ToldLimit& told, double within_mm) {
  const TurnLimit& limit = told.limit;
  if (limit.state == LimitState::blocked) return "";
  const std::string below = "\n                    ";
  std::string text =
      below + formatted("any centre within %g mm: ", within_mm) + range_text(told.common, " degrees") +
      formatted("; play of the ball up to %g mm: ", within_mm) + range_text(told.play, " degrees");
  if (told.half_mm_gap_deg)
    text += below + formatted("the gap falls to %g mm at ", within_mm) +
            rounded_down(*told.half_mm_gap_deg, 1) + " degrees";
  if (told.hangs_on_less())
    text += below + told.sensitivity() + formatted(", by more than %g degrees", kOfNote);
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

std::string describe_angles(const Joint& joint) {
  return std::string("angles              from the ") + name_of_rest(joint) +
         "; limits are rounded down, upper ends of ranges up\n";
}

void warn_of_missing(const LimitsAnswer& found, const Work& work) {
  const auto hangs = std::count_if(found.limits.begin(), found.limits.end(), [](const LimitAnswer& limit) {
    return of_contact(limit) && limit.unknown_by == UnknownBy::opening;
  });
  const auto all = std::count_if(found.limits.begin(), found.limits.end(), &of_contact);
  if (hangs > 0)
    work.warn(
        formatted("%td of %td motions come to an opening of a mesh, where it is not known whether one "
                  "bone is inside the other: give both bones whole, or crop both, or close the opening",
                  hangs, all));
  if (found.ball_cut_mm)
    work.warn(
        formatted("the ball's bone is cut off %.1f mm from the centre, through its neck: what is missing "
                  "beyond, of a femur trochanters and shaft, stops no motion, so that limits may be too "
                  "large; give the whole bone",
                  *found.ball_cut_mm));
}

Told told(Session& session, const LimitsRequest& request, const Work& work) {
  const LimitsAnswer found = answer(session, request);
  warn_of_missing(found, work);
  const Joint& joint = session.joint->joint;
  Told told{.words = describe_centre(joint) + describe_angles(joint) + describe(found),
            .document = json_of(found),
            .table_name = "limits.csv"};
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
  if (!one && std::any_of(found.limits.begin(), found.limits.end(), [](const LimitAnswer& limit) {
        return of_contact(limit) && limit.told.hangs_on_less();
      }))
    text += formatted("sensitive           means that the limit may be more than %g degrees off\n", kOfNote);
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
