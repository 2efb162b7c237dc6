// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/poses.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "files/csv.hpp"
#include "files/file_bytes.hpp"
#include "files/file_error.hpp"
#include "files/formatted.hpp"
#include "files/one_line.hpp"
#include "files/stopwatch.hpp"
#include "files/temporary_file.hpp"
#include "files/thread_team.hpp"
#include "hip/pose_travel.hpp"
#include "joint/pose_answer.hpp"
#include "joint/pose_series.hpp"
#include "scene/asked.hpp"

namespace impinge {
namespace {

using nlohmann::json;

PoseList list_of(const SceneOptions& options, const Joint& joint) {
  if (options.path) return parse_pose_grid(*options.path);
  PoseList list = read_poses(*options.poses, options.side);
  if (list.needs_side() && !options.side)
    throw FileError(*options.poses, "has angles that turn opposite ways on the two sides",
                    "say which with --side left or right");
  if (list.columns.empty() && joint.frames && joint.frames->femur)
    throw FileError(*options.poses,
                    "its matrices begin at the pose of the scan, and landmarks of the femur at neutral",
                    "give angles, or leave --landmarks out");
  return list;
}

std::string line_of(const std::vector<Cell>& cells) {
  std::string line;
  for (const Cell& cell : cells) line += (line.empty() ? "" : ",") + cell.text();
  return line + "\n";
}

std::string head_of(const PoseList& list, bool areas) {
  std::vector<Cell> names{"pose",    "touch",  "certified", "smallest_gap_mm",
                          "surface", "vertex", "clock",     "bound_mm"};
  if (areas) {
    for (const char* name :
         {"bone_ball_mm2", "bone_socket_mm2", "cartilage_ball_mm2", "cartilage_socket_mm2"})
      names.emplace_back(name);
  }
  for (const PoseColumn& column : list.columns) names.emplace_back(column.name);
  return line_of(names);
}

// Of all that the rows hang on.
std::string key_of(const SceneOptions& options, const Joint& joint, const PoseList& list) {
  std::string more = head_of(list, options.areas);
  for (const double value : list.values) more += Cell(value).text() + ",";
  return asked_key(options, joint, more);
}

constexpr const char* kUntracked = "untracked";  // in the place of touch

// What all rows say together, from their text: some of them may be from an earlier run.
struct Tally {
  std::size_t rows = 0;
  std::size_t touching = 0;
  std::size_t untracked = 0;
  std::size_t smallest_pose = 0;      // from 1
  std::vector<std::string> smallest;  // its row; empty where there is none

  void add(std::string_view row) {
    std::vector<std::string> cell;
    for (std::size_t k = 0; k < 8; ++k) {
      const std::size_t end = std::min(row.find_first_of(",\n"), row.size());
      cell.emplace_back(row.substr(0, end));
      row.remove_prefix(std::min(end + 1, row.size()));
    }
    ++rows;
    if (cell[1] == "yes") ++touching;
    if (cell[1] == kUntracked) ++untracked;
    if (cell[3].empty() || (!smallest.empty() && std::stod(cell[3]) >= std::stod(smallest[3]))) return;
    smallest_pose = rows;
    smallest = cell;
  }

  json smallest_json() const {
    if (smallest.empty()) return nullptr;
    return {{"pose", smallest_pose},
            {"gap_mm", std::stod(smallest[3])},
            {"surface", smallest[4]},
            {"vertex", std::stoull(smallest[5])},
            {"clock", smallest[6].empty() ? json(nullptr) : json(smallest[6])}};
  }
};

// The file that rows are added to.
class Part {
 public:
  // Keeps the whole rows below this head that it has.
  Part(std::filesystem::path file, const std::string& head) : file_(std::move(file)) {
    std::error_code unreadable;
    std::string bytes =
        std::filesystem::is_regular_file(file_, unreadable) && !std::filesystem::is_empty(file_, unreadable)
            ? read_bytes(file_)
            : std::string();
    bytes.resize(bytes.rfind('\n') + 1);  // a killed run may have cut a row
    if (!bytes.starts_with(head)) bytes = head;
    for (std::size_t at = head.size(); at < bytes.size(); at = bytes.find('\n', at) + 1)
      tally_.add(std::string_view(bytes).substr(at));
    write_bytes(file_, bytes);
    out_.open(file_, std::ios::binary | std::ios::app);
    require_good();
  }

  void add(const std::string& row) {
    out_ << row;
    tally_.add(row);
  }
  // What was added can be read.
  void flush() {
    out_.flush();
    require_good();
  }
  // Takes the place of a whole file.
  void become(const std::filesystem::path& whole) {
    out_.close();
    require_good();
    std::error_code error;
    std::filesystem::rename(file_, whole, error);
    if (error) fail_writing(whole, error.value());
  }
  const Tally& tally() const { return tally_; }

 private:
  void require_good() const {
    if (!out_) fail_writing(file_, errno);
  }

  std::filesystem::path file_;
  std::ofstream out_;
  Tally tally_;
};

std::string row_of(const SessionJoint& joint, const PoseList& list, std::size_t pose,
                   const SeriesAnswer& answer) {
  std::vector<Cell> cells{pose + 1, Cell(), Cell(), Cell(), Cell(), Cell(), Cell(), Cell()};
  if (!list.tracked(pose)) cells[1] = kUntracked;
  if (answer.touch) {
    const BodyPairs::Verdict& touch = *answer.touch;
    if (touch.contact != Contact::unknown) cells[1] = touch.contact == Contact::yes;
    cells[2] =
        touch.contact == Contact::no || (touch.contact == Contact::yes && touch.rule != ContactRule::radii);
  }
  if (const auto& smallest = answer.smallest) {
    cells[3] = smallest->least.gap_mm;
    cells[4] = name(smallest->least.at.scanned);
    cells[5] = smallest->least.at.vertex;
    if (joint.dial) cells[6] = clock_text(joint.dial->hours(joint.axes * smallest->place));
    cells[7] = smallest->bound_mm;
  }
  if (const auto& areas = answer.areas) {
    for (const double area :
         {(*areas)[0].bone, (*areas)[1].bone, (*areas)[0].cartilage, (*areas)[1].cartilage})
      cells.emplace_back(area);
  }
  for (std::size_t k = 0; k < list.columns.size(); ++k)
    cells.emplace_back(list.values[pose * list.width() + k]);
  return line_of(cells);
}

Pose pose_in(const SessionJoint& joint, const PoseList& list, std::size_t row) {
  return list.columns.empty() ? pose_about(joint.joint.centre, list.rotation(row), list.translation(row))
                              : pose_of(joint, list.motion(row));
}

// One line where matrices are in another unit or frame; empty where they look right.
std::string doubt_of(const SceneOptions& options, const SessionJoint& joint, const PoseList& list) {
  if (!list.columns.empty()) return {};
  const auto pose_at = [&](std::size_t row) {
    return list.tracked(row) ? pose_in(joint, list, row) : Pose();
  };
  const std::string doubt = doubtful_travel(joint.joint, list.size(), pose_at, 1);
  return doubt.empty() ? doubt : options.poses->string() + ": " + doubt;
}

}  // namespace

json answer_poses(const SceneOptions& options, const SessionJoint& joint, std::ostream& log) {
  Stopwatch watch;
  const PoseList list = list_of(options, joint.joint);
  const PoseSeries series(joint.joint, {.touch = options.question != Question::first_contact,
                                        .smallest_gap = options.question != Question::touch,
                                        .areas = options.areas,
                                        .cartilage_mm = options.cartilage_mm});
  Part part(options.out / ("poses-" + key_of(options, joint.joint, list) + ".part"),
            head_of(list, options.areas));
  const std::string doubt = doubt_of(options, joint, list);
  if (!doubt.empty()) log << "scene: warning: " << one_line(doubt) << std::endl;
  const double ready_ms = watch.lap_ms();
  const std::size_t kept = part.tally().rows;
  if (kept > 0)
    log << "scene: " << kept << " of " << list.size() << " poses were answered before" << std::endl;
  double answer_ms = 0.0;
  double said_ms = 0.0;
  const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  for (std::size_t pose = kept; pose < list.size();) {
    constexpr std::size_t kRowsOfAThread = 512;  // between two writes
    std::vector<std::string> rows(std::min(threads * kRowsOfAThread, list.size() - pose));
    on_threads(threads, [&](std::size_t thread) {
      for (std::size_t k = thread; k < rows.size(); k += threads)
        rows[k] =
            row_of(joint, list, pose + k,
                   list.tracked(pose + k) ? series.answer(pose_in(joint, list, pose + k)) : SeriesAnswer());
    });
    for (const std::string& row : rows) part.add(row);
    part.flush();
    pose += rows.size();
    answer_ms += watch.lap_ms();
    constexpr double kSilence = 2000.0;  // ms
    if (answer_ms < said_ms + kSilence || pose == list.size()) continue;
    said_ms = answer_ms;
    const double left =
        answer_ms * static_cast<double>(list.size() - pose) / static_cast<double>(pose - kept);
    log << "scene: pose " << pose << " of " << list.size() << formatted(", %.0f s left", left / 1e3)
        << std::endl;
  }
  part.become(options.out / "poses.csv");
  answer_ms += watch.lap_ms();
  const Tally& tally = part.tally();
  json summary = asked_json(options, joint.joint);
  if (!doubt.empty()) summary["warnings"].push_back(doubt);
  summary.update(
      {{"number_of_poses", list.size()},
       {"untracked", tally.untracked},
       {"touching", options.question == Question::first_contact ? json(nullptr) : json(tally.touching)},
       {"smallest_gap", tally.smallest_json()},
       {"times_ms", {{"ready", ready_ms}, {"answer", answer_ms}}}});
  return summary;
}

std::string describe_poses(const json& summary) {
  std::string text = formatted("poses               %zu", summary["number_of_poses"].get<std::size_t>());
  if (!summary["touching"].is_null())
    text += formatted(", %zu of them touch", summary["touching"].get<std::size_t>());
  if (const auto lost = summary["untracked"].get<std::size_t>(); lost > 0)
    text += formatted(", %zu without numbers: untracked in poses.csv", lost);
  text += "\n";
  const json& smallest = summary["smallest_gap"];
  if (smallest.is_null()) return text;
  return text + formatted("smallest gap        %.3f mm at %s vertex %zu in pose %zu\n",
                          smallest["gap_mm"].get<double>(), smallest["surface"].get<std::string>().c_str(),
                          smallest["vertex"].get<std::size_t>(), smallest["pose"].get<std::size_t>());
}

}  // namespace impinge
