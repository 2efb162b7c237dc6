// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/bones.hpp"

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "files/file_bytes.hpp"
#include "files/formatted.hpp"
#include "files/one_line.hpp"
#include "files/stopwatch.hpp"
#include "joint/joint_folder.hpp"
#include "scene/asked.hpp"
#include "scene/joint.hpp"
#include "scene/limit_table.hpp"
#include "scene/measure_table.hpp"
#include "scene/orientation.hpp"
#include "scene/question.hpp"
#include "scene/resection.hpp"
#include "scene/scene_files.hpp"
#include "scene/volume.hpp"

namespace impinge {
namespace {

using nlohmann::json;

// A column of joints.csv, and where the summary of a joint has it.
struct Headline {
  Column column;
  json::json_pointer at;
};

std::vector<Headline> headlines(const SceneOptions& options) {
  const auto at = [](const char* text) { return json::json_pointer(text); };
  if (options.volume) {
    return {{{"share_low", "1", "of all rotations that is free, at least"}, at("/share_low")},
            {{"share_high", "1", "at most"}, at("/share_high")},
            {{"reachable_low", "1", "of it from the pose of the scan, at least"}, at("/reachable_low")},
            {{"reachable_high", "1", "at most"}, at("/reachable_high")},
            {{"unknown", "1", "share of which nothing is known: the ball's mesh ends"}, at("/unknown")},
            {{"open", "1", "share that is undecided"}, at("/open")}};
  }
  if (options.change && options.change->of_socket) {
    return {{{"inclination_deg", "deg", "radiographic, of the socket as scanned"},
             at("/as_scanned/inclination_deg")},
            {{"anteversion_deg", "deg", "radiographic, as scanned"}, at("/as_scanned/anteversion_deg")},
            {{"state", "", "as scanned: free, blocked, open or unknown"}, at("/as_scanned/state")},
            {{"free_deg2", "deg^2", "area of the map"}, at("/area_deg2/free")},
            {{"blocked_deg2", "deg^2", "area of the map"}, at("/area_deg2/blocked")},
            {{"unknown_deg2", "deg^2", "area of the map"}, at("/area_deg2/unknown")},
            {{"open_deg2", "deg^2", "area of the map"}, at("/area_deg2/open")}};
  }
  if (options.change) {
    std::vector<Headline> cut{
        {{"volume_low_mm3", "mm^3", "of the least radial cut, at least"}, at("/volume_mm3/0")},
        {{"volume_high_mm3", "mm^3", "at most"}, at("/volume_mm3/1")},
        {{"area_low_mm2", "mm^2", "of the cut bone's surface, at least"}, at("/area_mm2/0")},
        {{"area_high_mm2", "mm^2", "at most"}, at("/area_mm2/1")},
        {{"depth_low_mm", "mm", "largest, at least"}, at("/depth_mm/0")},
        {{"depth_high_mm", "mm", "at most"}, at("/depth_mm/1")}};
    if (options.change->least) {
      cut.push_back(
          {{"least_volume_low_mm3", "mm^3", "of the least cut of all, at least"}, at("/least/volume_mm3/0")});
      cut.push_back({{"least_volume_high_mm3", "mm^3", "at most"}, at("/least/volume_mm3/1")});
    }
    return cut;
  }
  return {{{"touch", "", "do the surfaces touch, edges and all"}, at("/touch")},
          {{"smallest_gap_mm", "mm", "radial, of a vertex"}, at("/smallest_gap/gap_mm")},
          {{"surface", "", "whose vertex it is"}, at("/smallest_gap/surface")},
          {{"vertex", "1", "its place in the mesh"}, at("/smallest_gap/vertex")}};
}

Table joint_table(const SceneOptions& options) {
  Table table;
  table.columns = {{"joint", "", "its folder"}};
  for (const Headline& headline : headlines(options)) table.columns.push_back(headline.column);
  return table;
}

Cell cell_of(const json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  return value.is_string() ? Cell(value.get<std::string>()) : Cell();
}

void add_headlines(const std::string& joint, const SceneOptions& options, const json& summary, Table& table) {
  std::vector<Cell> row{joint};
  for (const Headline& headline : headlines(options))
    row.push_back(summary.contains(headline.at) ? cell_of(summary[headline.at]) : Cell());
  table.add_row(std::move(row));
}

// The options of one joint of the folder: what is given for all goes before its description.
SceneOptions options_of(const SceneOptions& all, const JointFolder& at) {
  SceneOptions options = all;
  options.ball = at.ball;
  options.socket = at.socket;
  if (all.volume || all.change) options.out = all.out / at.subject;
  if (!options.centre) options.centre = at.centre;
  if (!options.side) options.side = at.side;
  if (!options.axes_given && at.axes) {
    options.axes = *at.axes;
    options.axes_given = true;
  }
  return options;
}

// Its summary. A volume and a change have files in options.out too.
json answer_joint(Session& session, const SceneOptions& options, std::ostream& log) {
  SessionJoint& joint = *session.joint;
  if (options.volume) {
    require_writable_folder(options.out);
    return write_volume(options, session, log).document;
  }
  if (!options.change) return question_summary(options, joint, answer_question(joint, options));
  Stopwatch watch;
  if (options.change->of_socket) {
    const OrientAnswer found = answer(session, orientation_request(options));
    json summary = orientation_summary(options, joint, found, watch.lap_ms());
    require_writable_folder(options.out);
    write_orientation(options, found, summary);
    return summary;
  }
  const ResectAnswer found = answer(session, resection_request(options));
  json summary = resection_summary(options, joint, found, watch.lap_ms());
  require_writable_folder(options.out);
  write_resection(options, found, summary);
  return summary;
}

// Rows of one joint, and what its summary says of it.
json ask(const SceneOptions& options, const std::string& joint, Table& table, std::ostream& log) {
  Session session = load_joint(options);
  for (const std::string& warning : session.joint->joint.warnings)
    log << "scene: warning: " << one_line(warning) << std::endl;
  if (options.limit != nullptr) {
    add_limits(joint, answer_motions(session, options), table);
  } else if (options.measures) {
    add_measure_rows(joint, answer_measures(*session.joint), table);
  } else {
    add_headlines(joint, options, answer_joint(session, options, log), table);
  }
  json said = asked_json(options, session.joint->joint);
  json known{{"joint", joint}};
  for (const char* key : {"ball", "socket", "centre", "side", "axes", "warnings"}) known[key] = said[key];
  return known;
}

// A line that names the joint.
std::string reason(const JointFolder& at, const std::exception& error) {
  const std::string folder = at.ball.parent_path().string();
  const std::string what = one_line(error.what());
  return what.find(folder) == what.npos ? folder + ": " + what : what;
}

}  // namespace

json answer_bones(const SceneOptions& options, std::ostream& log) {
  Stopwatch watch;
  const JointFolders folders = find_joints(*options.bones);
  Table table = options.limit != nullptr ? limit_table()
                : options.measures       ? measure_table()
                                         : joint_table(options);
  json joints = json::array();
  json left_out = folders.left_out;
  for (std::size_t k = 0; k < folders.joints.size(); ++k) {
    const JointFolder& at = folders.joints[k];
    log << "scene: joint " << k + 1 << " of " << folders.joints.size() << ", " << one_line(at.subject)
        << std::endl;
    try {
      joints.push_back(ask(options_of(options, at), at.subject, table, log));
    } catch (const std::exception& error) {
      left_out.push_back(reason(at, error));
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

std::string describe_bones(const SceneOptions& options, const json& summary) {
  const bool files = options.volume || options.change;
  return formatted("joints              %zu, in %zu rows\n", summary["joints"].size(),
                   summary["rows"].get<std::size_t>()) +
         (files ? "files of a joint    in " + options.out.string() + "/ and its name\n" : "");
}

}  // namespace impinge
