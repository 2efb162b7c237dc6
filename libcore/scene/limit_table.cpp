// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/limit_table.hpp"

#include <algorithm>

#include "files/formatted.hpp"
#include "hip/named_motion.hpp"
#include "scene/asked.hpp"
#include "scene/limit.hpp"

namespace impinge {
namespace {

Cell cell_of(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

void add(const std::string& joint, const std::string& motion, const LimitAnswer& answer, Table& table) {
  const ToldLimit& told = answer.told;
  table.add_row({joint, motion, told.threshold_mm, answer.about, name(told.limit.state), told.limit.low_deg,
                 told.limit.high_deg, told.common.low_deg,
                 told.common.limited ? Cell(told.common.high_deg) : Cell(), cell_of(told.half_mm_gap_deg),
                 answer.hours ? Cell(clock_text(*answer.hours)) : Cell(), what_of(answer)});
}

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

}  // namespace

std::vector<MotionLimits> answer_motions(Session& session, const SceneOptions& options) {
  std::vector<MotionLimits> answers;
  for (const NamedMotion& motion : named_motions()) {
    const bool asked = options.all_motions || motion.name == options.motion_asked;
    if (!asked) continue;
    const Motion& start = options.all_motions ? motion.start : options.motion;
    answers.push_back(
        {std::string(motion.name), answer_limits(session, {.start = start,
                                                           .growing = std::string(motion.growing),
                                                           .cartilage_mm = options.cartilage_mm})});
  }
  return answers;
}

Table limit_table() {
  Table table;
  table.columns = {{"joint", "", "its folder, or empty"},
                   {"motion", "", "what grows, and from where"},
                   {"threshold_mm", "mm", "0: contact of the surfaces; else the gap of a vertex"},
                   {"centre", "", "about whose centre the ball turns"},
                   {"state", "", "limited, free, blocked or unknown"},
                   {"low_deg", "deg", "free up to here"},
                   {"high_deg", "deg", "where limited, not free here"},
                   {"centre_low_deg", "deg", "free up to here for every common centre within 0.5 mm"},
                   {"centre_high_deg", "deg", "and not free here for any"},
                   {"half_mm_gap_deg", "deg", "where the gap of a vertex first falls to 0.5 mm"},
                   {"clock", "h", "where the surfaces touch"},
                   {"what", "", "what meets what, and what a reader must know"}};
  return table;
}

void add_limits(const std::string& joint, const std::vector<MotionLimits>& motions, Table& table) {
  for (const auto& [motion, found] : motions) {
    add(joint, motion, found.contact, table);
    if (found.socket) add(joint, motion, *found.socket, table);
    if (found.cartilage.told.threshold_mm > 0.0) add(joint, motion, found.cartilage, table);
  }
}

nlohmann::json limits_summary(const SceneOptions& options, const SessionJoint& joint,
                              const std::vector<MotionLimits>& motions, double milliseconds) {
  nlohmann::json report = asked_json(options, joint.joint);
  report["motions"] = nlohmann::json::array();
  for (const auto& [motion, found] : motions) {
    const nlohmann::json whole = limit_summary(options, joint, found, 0.0);
    nlohmann::json item{{"motion", motion}};
    for (const char* key : {"largest_angle_deg", "contact", "cartilage"}) item[key] = whole[key];
    report["motions"].push_back(item);
  }
  report.update({{"cartilage_mm", options.cartilage_mm},
                 {"centre_within_mm", kErrorOfInput},
                 {"times_ms", {{"answer", milliseconds}}}});
  return report;
}

std::string describe_motions(const std::vector<MotionLimits>& motions) {
  const auto row = [](const std::vector<std::string>& cells) {
    constexpr std::size_t kColumns[] = {25, 40, 64, 72, 91};
    std::string line;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      line += cells[k];
      if (k + 1 < cells.size()) line.resize(std::max(line.size() + 1, kColumns[k]), ' ');
    }
    return line.erase(line.find_last_not_of(' ') + 1) + "\n";
  };
  std::string text = row({"limits, degrees", "bone on bone", formatted("centres within %g mm", kErrorOfInput),
                          "o'clock", "gap of cartilage", "what meets, and doubts"});
  for (const auto& [motion, found] : motions) {
    const LimitAnswer& contact = found.contact;
    const bool limited = contact.told.limit.state == LimitState::limited;
    text += row({motion, bracket(contact.told.limit), limited ? range_text(contact.told.common) : "",
                 contact.hours ? clock_text(*contact.hours) : "", bracket(found.cartilage.told.limit),
                 what_of(contact)});
  }
  return text;
}

}  // namespace impinge
