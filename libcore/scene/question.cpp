// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/question.hpp"

#include <algorithm>
#include <cmath>

#include "files/formatted.hpp"
#include "scene/asked.hpp"
#include "scene/contact.hpp"
#include "scene/json_values.hpp"

namespace impinge {
namespace {

using nlohmann::json;

// Megabytes as a person reads them.
std::string size_text(double bytes) {
  const double size = std::abs(bytes);
  if (size >= 1e6) return formatted("%.3g MB", size / 1e6);
  if (size >= 1e3) return formatted("%.3g kB", size / 1e3);
  return formatted("%.0f bytes", size);
}

json smallest_json(const SmallestGap& smallest, const SessionJoint& joint, const Pose& pose) {
  const Vec3 place = posed_places(joint, pose, smallest.scanned)[smallest.vertex];
  return {{"gap_mm", smallest.gap_mm},
          {"surface", name(smallest.scanned)},
          {"vertex", smallest.vertex},
          {"position", point_json(place + joint.joint.centre)}};
}

}  // namespace

json left_out_json(const std::vector<LeftOut>& left_out) {
  json items = json::array();
  for (const LeftOut& item : left_out) {
    items.push_back({{"what", item.what},
                     {"meaning", item.meaning},
                     {"reason", item.reason},
                     {"bytes_saved", item.bytes_saved == 0.0 ? json(nullptr) : json(item.bytes_saved)}});
  }
  return items;
}

std::string describe_way(const std::string& way, const std::vector<LeftOut>& left_out, bool edge_on) {
  std::string items;
  const auto add = [&items](const std::string& item) {
    items += (items.empty() ? "left out            " : "                    ") + item + "\n";
  };
  for (const LeftOut& item : left_out) {
    const bool saves = item.bytes_saved > 0.0;
    const std::string bytes =
        (saves ? "; saves " : "; takes ") + size_text(item.bytes_saved) + (saves ? "" : " more");
    add(std::string(item.meaning) + ": " + item.reason + (item.bytes_saved == 0.0 ? "" : bytes));
  }
  if (edge_on) add(kEdgeOnLeftOut);
  if (items.empty()) add("nothing");
  return "way                 " + way + "\n" + items;
}

bool edge_on_faces(const Joint& joint) {
  return joint.ball.star_shape.edge_on + joint.socket.star_shape.edge_on > 0;
}

std::string json_text(const json& summary) {
  return summary.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

json question_summary(const SceneOptions& options, const SessionJoint& joint, const QuestionAnswer& found) {
  const SceneAnswer& answer = found.answer;
  const bool touch = options.question == Question::touch;
  const bool known = touch && (!found.contact || found.contact->contact != Contact::unknown);
  json report = asked_json(options, joint.joint);
  report["units"]["memory"] = "bytes";
  report.update(
      {{"touch", known ? json(static_cast<bool>(answer.touches.front())) : json(nullptr)},
       {"contact", found.contact ? contact_json(joint.joint, *found.contact) : json(nullptr)},
       {"smallest_gap", answer.smallest ? smallest_json(*answer.smallest, joint, found.pose) : json(nullptr)},
       {"way", found.way},
       {"left_out", left_out_json(answer.left_out)},
       {"table_bytes", answer.bytes},
       {"entries_filled", answer.entries},
       {"look_ups", answer.look_ups},
       {"times_ms", {{"answer", found.milliseconds}}}});
  return report;
}

std::string describe_question(const SceneOptions& options, const Joint& joint, const QuestionAnswer& found) {
  if (found.contact) return describe_contact(joint, *found.contact);
  if (options.question == Question::touch)
    return std::string("touch               ") + (found.answer.touches.front() ? "yes" : "no") + "\n";
  const auto& smallest = found.answer.smallest;
  if (!smallest) return "smallest gap        none: the surfaces do not face each other\n";
  return formatted("smallest gap        %.3f mm at %s vertex %zu\n", smallest->gap_mm,
                   name(smallest->scanned).data(), smallest->vertex);
}

}  // namespace impinge
