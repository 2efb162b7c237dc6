// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/bones.hpp"

#include <stdexcept>

#include "files/file_bytes.hpp"
#include "files/one_line.hpp"
#include "files/stopwatch.hpp"
#include "gap/formatted.hpp"
#include "scene/asked.hpp"
#include "scene/joint.hpp"
#include "scene/joint_folder.hpp"
#include "scene/limit_table.hpp"
#include "scene/measure_table.hpp"
#include "scene/scene_files.hpp"
#include "session/measurement.hpp"

namespace impinge {
namespace {

using nlohmann::json;

Table joint_table() {
  Table table;
  table.columns = {{"joint", "", "its folder"},
                   {"touch", "", "do the surfaces touch, edges and all"},
                   {"smallest_gap_mm", "mm", "radial, of a vertex"},
                   {"surface", "", "whose vertex it is"},
                   {"vertex", "1", "its place in the mesh"}};
  return table;
}

// The options of one joint of the folder: what is given for all goes before its description.
SceneOptions options_of(const SceneOptions& all, const JointFolder& at) {
  SceneOptions options = all;
  options.ball = at.ball;
  options.socket = at.socket;
  if (!options.centre) options.centre = at.centre;
  if (!options.side) options.side = at.side;
  if (!options.axes_given && at.axes) {
    options.axes = *at.axes;
    options.axes_given = true;
  }
  return options;
}

void add_answer(const std::string& joint, const QuestionAnswer& found, bool touch, Table& table) {
  const auto& smallest = found.answer.smallest;
  table.add_row({joint, touch ? Cell(static_cast<bool>(found.answer.touches.front())) : Cell(),
                 smallest ? Cell(smallest->gap_mm) : Cell(),
                 smallest ? Cell(name(smallest->scanned)) : Cell(),
                 smallest ? Cell(smallest->vertex) : Cell()});
}

// Rows of one joint, and what its summary says of it.
json ask(const SceneOptions& options, const std::string& joint, Table& table) {
  Session session = load_joint(options);
  if (options.limit != nullptr) {
    add_limits(joint, answer_motions(session, options), table);
  } else if (options.measures) {
    add_measure_rows(joint, answer_measures(*session.joint), table);
  } else {
    add_answer(joint, answer_question(*session.joint, options), options.question == Question::touch, table);
  }
  json said = asked_json(options, session.joint->joint);
  json known{{"joint", joint}};
  for (const char* key : {"ball", "socket", "centre", "side", "axes", "warnings"}) known[key] = said[key];
  return known;
}

}  // namespace

json answer_bones(const SceneOptions& options, std::ostream& log) {
  Stopwatch watch;
  const JointFolders folders = find_joints(*options.bones);
  Table table = options.limit != nullptr ? limit_table() : options.measures ? measure_table() : joint_table();
  json joints = json::array();
  json left_out = folders.left_out;
  for (std::size_t k = 0; k < folders.joints.size(); ++k) {
    const JointFolder& at = folders.joints[k];
    log << "scene: joint " << k + 1 << " of " << folders.joints.size() << ", " << one_line(at.subject)
        << std::endl;
    try {
      joints.push_back(ask(options_of(options, at), at.subject, table));
    } catch (const std::exception& error) {
      left_out.push_back(one_line(error.what()));
    }
  }
  for (const json& reason : left_out)
    log << "scene: warning: left out: " << reason.get<std::string>() << std::endl;
  if (joints.empty())
    throw std::runtime_error(options.bones->string() +
                             ": none of its joints could be used; see the lines above");
  write_if_changed(options.out / scene_files(options).front(), to_csv(table));
  return {{"bones", options.bones->string()},
          {"joints", joints},
          {"left_out", left_out},
          {"rows", table.rows.size()},
          {"times_ms", {{"answer", watch.lap_ms()}}}};
}

std::string describe_bones(const json& summary) {
  return formatted("joints              %zu, in %zu rows\n", summary["joints"].size(),
                   summary["rows"].get<std::size_t>());
}

}  // namespace impinge
