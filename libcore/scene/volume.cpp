// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include <Eigen/Geometry>

#include "files/csv.hpp"
#include "files/file_bytes.hpp"
#include "files/formatted.hpp"
#include "files/stopwatch.hpp"
#include "files/temporary_file.hpp"
#include "joint/volume.hpp"
#include "scene/asked.hpp"
#include "scene/json_values.hpp"
#include "scene/question.hpp"
#include "scene/volume_picture.hpp"

namespace impinge {
namespace {

using nlohmann::json;

// Of the test of a cell and the order of cells: verdicts of another one are not taken.
constexpr const char* kVersion = "volume 2";

// Verdicts of an interrupted run, as bytes: four words each, and a fifth that only those of this place,
// question and version have. What does not match is worked out again, with all that follows.
class VerdictFile {
 public:
  VerdictFile(const std::filesystem::path& folder, const std::string& key)
      : file_(folder / ("volume-" + key + ".part")), key_(fnv1a(key)) {
    std::error_code unreadable;
    if (std::filesystem::is_regular_file(file_, unreadable) &&
        std::filesystem::file_size(file_, unreadable) > 0)
      read(read_bytes(file_));
    std::string bytes;
    for (std::size_t k = 0; k < known_.size(); ++k) bytes += bytes_of(known_[k], k);
    write_bytes(file_, bytes);  // a killed run may have cut a verdict
    out_.open(file_, std::ios::binary | std::ios::app);
    require_good();
  }

  const std::vector<CellVerdict>& known() const { return known_; }

  // Those that are known already are not written again.
  void add(std::span<const CellVerdict> verdicts) {
    const std::size_t again = std::min(verdicts.size(), known_.size() - std::min(known_.size(), seen_));
    std::string bytes;
    for (std::size_t k = again; k < verdicts.size(); ++k) bytes += bytes_of(verdicts[k], seen_ + k);
    seen_ += verdicts.size();
    out_ << bytes << std::flush;
    require_good();
  }

  ~VerdictFile() {
    if (seen_ == 0 && known_.empty()) remove();
  }
  VerdictFile(const VerdictFile&) = delete;
  VerdictFile& operator=(const VerdictFile&) = delete;

  void remove() {
    out_.close();
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }

 private:
  using Words = std::array<std::uint32_t, 5>;

  std::string bytes_of(const CellVerdict& verdict, std::size_t place) const {
    const CellHint& hint = verdict.hint;
    Words words{hint.ball_face, hint.socket_face, hint.vertex,
                static_cast<std::uint32_t>(verdict.state) + (hint.of_ball ? 4U : 0U)};
    std::string bytes(sizeof words, '\0');
    std::memcpy(bytes.data(), words.data(), sizeof words);
    words.back() = static_cast<std::uint32_t>(fnv1a(bytes, key_ + place) >> 32U);
    std::memcpy(bytes.data(), words.data(), sizeof words);
    return bytes;
  }
  void read(const std::string& bytes) {
    Words words;
    for (std::size_t at = 0; at + sizeof words <= bytes.size(); at += sizeof words) {
      std::memcpy(words.data(), bytes.data() + at, sizeof words);
      const CellVerdict verdict{static_cast<CellState>(words[3] % 4),
                                {words[0], words[1], words[2], words[3] >= 4}};
      if (words[3] >= 8 || bytes.compare(at, sizeof words, bytes_of(verdict, known_.size())) != 0) return;
      known_.push_back(verdict);
    }
  }
  void require_good() const {
    if (!out_) fail_writing(file_, errno);
  }

  std::filesystem::path file_;
  std::uint64_t key_;
  std::vector<CellVerdict> known_;
  std::size_t seen_ = 0;
  std::ofstream out_;
};

std::string row_of(const VolumeCell& at) {
  const Quaternion4 q = centre(at.cell);
  const std::array<Cell, 10> cells{at.cell.level,
                                   at.cell.number,
                                   q[0],
                                   q[1],
                                   q[2],
                                   q[3],
                                   angular_radius(at.cell) / kDegree,
                                   share(at.cell),
                                   name(at.state),
                                   at.reachable      ? Cell(true)
                                   : at.within_reach ? Cell()
                                                     : Cell(false)};
  std::string line;
  for (const Cell& cell : cells) line += (line.empty() ? "" : ",") + cell.text();
  return line + "\n";
}

void write_cells(const std::filesystem::path& path, const MotionVolume& volume) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 24;
  TemporaryFile file(path);
  std::string text = "level,cell,w,x,y,z,radius_deg,share,state,reachable\n";
  volume.for_each([&](const VolumeCell& at) {
    text += row_of(at);
    if (text.size() < kAtOnce) return;
    file.write(text);
    text.clear();
  });
  file.write(text);
  file.rename();
}

json stop_json(const VolumeStop& stop, const Joint& joint) {
  const VolumeLimit& limit = stop.limit;
  json found{{"motion", stop.motion->name},
             {"low_deg", limit.low_deg},
             {"high_deg", limit.high_deg ? json(*limit.high_deg) : json(nullptr)},
             {"clock", stop.hours ? json(clock_text(*stop.hours)) : json(nullptr)},
             {"ball_direction", stop.on_ball ? point_json(*stop.on_ball) : json(nullptr)}};
  add_part_names(joint, stop.ball_part, stop.socket_part, found);
  return found;
}

json volume_json(const SceneOptions& options, const SessionJoint& joint, const VolumeAnswer& answer) {
  const VolumeShares& shares = answer.volume.shares();
  json report = asked_json(options, joint.joint);
  report["units"]["share"] = "1";
  json motions = json::array();
  for (const VolumeStop& stop : answer.stops) motions.push_back(stop_json(stop, joint.joint));
  report.update({{"share_low", shares.low()},
                 {"share_high", shares.high()},
                 {"reachable_low", shares.reached()},
                 {"reachable_high", shares.within_reach()},
                 {"neutral_blocked", shares.reachable_high == 0.0},
                 {"unknown", shares.unknown},
                 {"open", shares.open},
                 {"cells_asked", shares.cells},
                 {"motions", motions}});
  return report;
}

}  // namespace

json write_volume(const SceneOptions& options, const SessionJoint& joint, std::ostream& log) {
  const VolumeOptions& asked = *options.volume;
  VerdictFile part(options.out, asked_key(options, joint.joint, kVersion));
  if (!part.known().empty())
    log << "scene: " << part.known().size() << " cells were decided before" << std::endl;
  Stopwatch watch;
  double silent_ms = 0.0;
  std::size_t cells = 0;
  VolumeRequest request;
  request.question = {asked.gap_mm, asked.centre_within_mm};
  request.settings.width = asked.width;
  request.settings.most_cells = kMostVolumeCells;
  request.settings.known = part.known();
  request.settings.reached = [&](std::span<const CellVerdict> batch, double open) {
    part.add(batch);
    cells += batch.size();
    silent_ms += watch.lap_ms();
    constexpr double kSilence = 2000.0;  // ms
    if (silent_ms < kSilence) return;
    silent_ms = 0.0;
    log << "scene: " << cells
        << formatted(" cells, %.3f of all rotations open, %.3f wanted", open, asked.width) << std::endl;
  };
  const VolumeAnswer answer = answer_volume(joint, request);
  write_cells(options.out / "volume.csv", answer.volume);
  if (joint.side) write_if_changed(options.out / "volume.svg", volume_picture(answer.volume, *joint.side));
  json found = volume_json(options, joint, answer);
  write_if_changed(options.out / "volume.json", json_text(found));
  part.remove();
  return found;
}

std::string describe_volume(const json& found) {
  const auto percent = [&](const char* key) { return 100.0 * found[key].get<double>(); };
  std::string text = formatted("free                %.2f to %.2f %% of all rotations", percent("share_low"),
                               percent("share_high"));
  if (percent("unknown") > 0.0)
    text += formatted("; of %.2f %% nothing is known: the ball's mesh ends there", percent("unknown"));
  if (found["neutral_blocked"].get<bool>())
    return text + "\nreachable           none: the pose of the scan is blocked\n";
  text += formatted("\nreachable           %.2f to %.2f %% from the pose of the scan without contact\n",
                    percent("reachable_low"), percent("reachable_high"));
  if (percent("open") > 100.0 * found["width"].get<double>())
    text += formatted("undecided           %.2f %%: more than was wanted, after %zu cells\n", percent("open"),
                      found["cells_asked"].get<std::size_t>());
  return text;
}

}  // namespace impinge
