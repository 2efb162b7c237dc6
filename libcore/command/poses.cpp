// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/poses.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "command/answer_key.hpp"
#include "command/question_command.hpp"
#include "files/file_bytes.hpp"
#include "files/formatted.hpp"
#include "files/rows.hpp"
#include "files/stopwatch.hpp"
#include "files/temporary_file.hpp"
#include "files/thread_team.hpp"

namespace impinge {
namespace {

constexpr const char* kRowsVersion = "poses 1";  // of the answers: rows of another version are not kept

// Poses with BlenderROMFinder's columns also get its column Valid_pose; 1 means no contact.
bool has_valid_pose(const PoseList& list, const PosesRequest& request) {
  return list.kind == PoseKind::steps && request.asks(PosesOutput::touch);
}

std::string head_of(const PoseList& list, const PosesRequest& request) {
  std::vector<Cell> names;
  for (const Column& column : columns_of<PoseRow>()) names.emplace_back(column.name);
  if (request.asks(PosesOutput::areas))
    for (const Column& column : columns_of<PoseAreas>()) names.emplace_back(column.name);
  for (const PoseColumn& column : list.columns)
    if (!column.name.empty()) names.emplace_back(column.name);
  if (has_valid_pose(list, request)) names.emplace_back("Valid_pose");
  return csv_line(names);
}

std::string text_of_row(const PosesRequest& request, const PoseList& list, const PoseRow& row) {
  std::vector<Cell> cells = cells_of(row);
  if (row.areas)
    for (Cell& cell : cells_of(*row.areas)) cells.push_back(std::move(cell));
  for (std::size_t k = 0; k < list.columns.size(); ++k)
    if (!list.columns[k].name.empty()) cells.emplace_back(list.values[(row.pose - 1) * list.width() + k]);
  if (has_valid_pose(list, request))
    cells.push_back(row.touch() == "yes" ? Cell("0") : row.touch() == "no" ? Cell("1") : Cell());
  return csv_line(cells);
}

// Adds a row to the summary from its text, since it may be from an earlier run.
void add_text(std::string_view row, PosesAnswer& all) {
  std::vector<std::string> cell;
  for (std::size_t k = 0; k < 8; ++k) {
    const std::size_t end = std::min(row.find_first_of(",\n"), row.size());
    cell.emplace_back(row.substr(0, end));
    row.remove_prefix(std::min(end + 1, row.size()));
  }
  std::optional<SmallestOfPoses> gap;
  if (!cell[3].empty()) gap = {0, std::stod(cell[3]), cell[4], std::stoull(cell[5]), {}};
  if (gap && !cell[6].empty()) gap->clock = cell[6];
  add_row(cell[1], gap, all);
}

// The rows, kept in a file if there is a folder for it.
class Rows {
 public:
  // Keeps the complete rows that the file has below the same head. `found` is without rows.
  Rows(const Work& work, const std::string& key, const std::string& head, PosesAnswer found)
      : found_(std::move(found)) {
    if (!work.out) return;
    whole_ = work.output("poses.csv");
    file_ = *work.out / ("poses-" + key + ".part");
    std::error_code unreadable;
    std::string bytes =
        std::filesystem::is_regular_file(file_, unreadable) && !std::filesystem::is_empty(file_, unreadable)
            ? read_bytes(file_)
            : std::string();
    bytes.resize(bytes.rfind('\n') + 1);  // a killed run may have cut a row
    if (!bytes.starts_with(head)) bytes = head;
    for (std::size_t at = head.size(); at < bytes.size(); at = bytes.find('\n', at) + 1)
      add_text(std::string_view(bytes).substr(at), found_);
    write_bytes(file_, bytes);
    out_.open(file_, std::ios::binary | std::ios::app);
    require_good();
  }

  // Afterwards the new rows can be read from the file.
  void add(const std::vector<std::string>& rows) {
    for (const std::string& row : rows) {
      add_text(row, found_);
      if (!file_.empty()) out_ << row;
    }
    out_.flush();
    require_good();
  }
  // The complete file; it stays until it is in place.
  std::vector<std::shared_ptr<TemporaryFile>> finished() {
    if (file_.empty()) return {};
    out_.close();
    require_good();
    return {std::make_shared<TemporaryFile>(whole_, file_)};
  }
  const PosesAnswer& found() const { return found_; }

 private:
  void require_good() const {
    if (!file_.empty() && !out_) fail_writing(file_, errno);
  }

  std::filesystem::path file_;
  std::filesystem::path whole_;
  std::ofstream out_;
  PosesAnswer found_;
};

void answer_all(const SessionJoint& joint, const PoseList& list, const PoseSeries& series,
                const PosesRequest& request, const Work& work, Rows& rows) {
  Stopwatch watch;
  double answer_ms = 0.0;
  double said_ms = 0.0;
  const std::size_t kept = rows.found().number_of_poses;
  if (kept > 0) work.say(formatted("%zu of %zu poses were answered before", kept, list.size()));
  for (std::size_t pose = kept; pose < list.size();) {
    constexpr std::size_t kRowsOfAThread = 512;  // between two writes
    std::vector<std::string> texts(std::min(work.threads * kRowsOfAThread, list.size() - pose));
    on_threads(work.threads, [&](std::size_t thread) {
      for (std::size_t k = thread; k < texts.size(); k += work.threads) {
        const bool tracked = list.tracked(pose + k);
        PoseRow row = tracked ? series.answer(pose_in(joint, list, pose + k)) : PoseRow{.tracked = false};
        row.pose = pose + k + 1;
        texts[k] = text_of_row(request, list, row);
      }
    });
    rows.add(texts);
    pose += texts.size();
    answer_ms += watch.lap_ms();
    constexpr double kSilence = 2000.0;  // ms
    if (answer_ms < said_ms + kSilence || pose == list.size()) continue;
    said_ms = answer_ms;
    const double left =
        answer_ms * static_cast<double>(list.size() - pose) / static_cast<double>(pose - kept);
    work.say(formatted("pose %zu of %zu, %.0f s left", pose, list.size(), left / 1e3));
  }
}

std::string describe_poses(const PosesAnswer& found) {
  std::string text = formatted("poses               %zu", found.number_of_poses);
  if (found.touching) text += formatted(", %zu of them touch", *found.touching);
  if (found.unknown.value_or(0) > 0)
    text += formatted(", of %zu it is not known: they hang on an opening of a mesh", *found.unknown);
  if (found.untracked > 0)
    text += formatted(", %zu without numbers: untracked in poses.csv", found.untracked);
  text += "\n";
  if (!found.smallest_gap) return text;
  return text +
         formatted("smallest gap        %.3f mm%s at %s vertex %zu in pose %zu\n", found.smallest_gap->gap_mm,
                   found.smallest_gap->gap_mm < 0.0 ? ", depth along a ray," : "",
                   found.smallest_gap->surface.c_str(), found.smallest_gap->vertex, found.smallest_gap->pose);
}

Told told(Session& session, const PosesRequest& request, const Work& work) {
  const SessionJoint& joint = *session.joint;
  const PoseList list = list_of(request, joint);
  const PoseSeries series(joint, request);
  const std::string head = head_of(list, request);
  std::string given = std::string(kRowsVersion) + head;
  given += std::to_string(static_cast<int>(list.kind)) + ",";
  for (const double value : list.values) given += Cell(value).text() + ",";
  PosesAnswer none;
  if (request.asks(PosesOutput::touch)) none.touching = none.unknown = 0;
  if (const std::string doubt = doubt_of(request, joint, list); !doubt.empty()) {
    work.warn(doubt);
    none.doubt = doubt;
  }
  Rows rows(work, answer_key(joint, json_of(request), given), head, none);
  answer_all(joint, list, series, request, work, rows);
  Told told{.words = describe_poses(rows.found()), .document = json_of(rows.found())};
  told.wrote = rows.finished();
  told.row_of_one = {{"poses", "/number_of_poses"},
                     {"touching", "/touching"},
                     {"unknown", "/unknown"},
                     {"smallest_gap_mm", "/smallest_gap/gap_mm"}};
  return told;
}

}  // namespace

QuestionCommand poses_question() {
  return question_of<PosesRequest, PosesAnswer>(
      "poses", "Contact and the smallest gap in each of many poses.",
      "femur.ply pelvis.ply --side right --path flexion=0..120/1 --out path", &told);
}

}  // namespace impinge
