// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/question.hpp"

#include <algorithm>
#include <cmath>

#include "gap/formatted.hpp"
#include "scene/asked.hpp"
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

json smallest_json(const SmallestGap& smallest, const Joint& joint, const Pose& pose) {
  const bool ball = smallest.scanned == Surface::ball;
  const Vec3& vertex = (ball ? joint.ball : joint.socket).mesh.vertices[smallest.vertex];
  return {{"gap_mm", smallest.gap_mm},
          {"surface", name(smallest.scanned)},
          {"vertex", smallest.vertex},
          {"position", point_json((ball ? to_socket(pose, vertex) : vertex) + joint.centre)}};
}

}  // namespace

json left_out_json(const std::vector<LeftOut>& left_out) {
  json items = json::array();
  for (const LeftOut& item : left_out) {
    const OmissionName& known = kOmissions[static_cast<std::size_t>(item.what)];
    items.push_back({{"what", known.name},
                     {"meaning", known.meaning},
                     {"reason", item.reason},
                     {"bytes_saved", item.bytes_saved == 0.0 ? json(nullptr) : json(item.bytes_saved)}});
  }
  return items;
}

std::string describe_left_out(const json& left_out) {
  if (left_out.empty()) return "left out            nothing\n";
  std::string text;
  for (const json& item : left_out) {
    text += text.empty() ? "left out            " : "                    ";
    if (item.is_string()) {
      text += item.get<std::string>() + "\n";
      continue;
    }
    text += item["meaning"].get<std::string>() + ": " + item["reason"].get<std::string>();
    if (!item["bytes_saved"].is_null()) {
      const double bytes = item["bytes_saved"];
      text += (bytes > 0.0 ? "; saves " : "; takes ") + size_text(bytes) + (bytes > 0.0 ? "" : " more");
    }
    text += "\n";
  }
  return text;
}

std::string describe_way(const json& way) { return "way                 " + way.get<std::string>() + "\n"; }

std::string json_text(const json& summary) {
  return summary.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

json question_summary(const SceneOptions& options, const Joint& joint, const QuestionAnswer& found) {
  const SceneAnswer& answer = found.answer;
  const bool touch = options.question == Question::touch;
  json report = asked_json(options, joint);
  report["units"]["memory"] = "bytes";
  report.update(
      {{"touch", touch ? json(static_cast<bool>(answer.touches.front())) : json(nullptr)},
       {"smallest_gap", answer.smallest ? smallest_json(*answer.smallest, joint, found.pose) : json(nullptr)},
       {"way", answer.path.reason},
       {"left_out", left_out_json(found.left_out)},
       {"table_bytes", answer.cost.bytes},
       {"entries_filled", answer.cost.entries},
       {"look_ups", answer.cost.look_ups},
       {"times_ms", {{"answer", found.milliseconds}}}});
  return report;
}

std::string describe_question(const json& summary) {
  if (summary["question"] == "touch")
    return std::string("touch               ") + (summary["touch"].get<bool>() ? "yes" : "no") + "\n";
  const json& smallest = summary["smallest_gap"];
  if (smallest.is_null()) return "smallest gap        none: the surfaces do not face each other\n";
  return formatted("smallest gap        %.3f mm at %s vertex %zu\n", smallest["gap_mm"].get<double>(),
                   smallest["surface"].get<std::string>().c_str(), smallest["vertex"].get<std::size_t>());
}

}  // namespace impinge
