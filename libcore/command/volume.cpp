// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/volume.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include "command/answer_key.hpp"
#include "command/question_command.hpp"
#include "files/file_bytes.hpp"
#include "files/formatted.hpp"
#include "files/rows.hpp"
#include "files/temporary_file.hpp"
#include "joint/touch.hpp"
#include "report/volume_picture.hpp"

namespace impinge {
namespace {

// Version of the test and order of cells; verdicts of another version are not taken.
constexpr const char* kVerdicts = "volume 6";

// Verdicts of an interrupted run, as bytes: five words each, and a sixth that belongs to this place, question
// and version. From the first that does not match, everything is worked out again.
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
  const std::filesystem::path& file() const { return file_; }

  // Writes the new verdicts; those already known are in the file.
  void add(std::span<const CellVerdict> verdicts) {
    const std::size_t again = std::min(verdicts.size(), known_.size() - std::min(known_.size(), seen_));
    std::string bytes;
    for (std::size_t k = again; k < verdicts.size(); ++k) bytes += bytes_of(verdicts[k], seen_ + k);
    seen_ += verdicts.size();
    out_ << bytes << std::flush;
    require_good();
  }

  ~VerdictFile() {
    std::error_code ignored;
    if (seen_ == 0 && known_.empty()) std::filesystem::remove(file_, ignored);
  }
  VerdictFile(const VerdictFile&) = delete;
  VerdictFile& operator=(const VerdictFile&) = delete;

 private:
  using Words = std::array<std::uint32_t, 6>;

  std::string bytes_of(const CellVerdict& verdict, std::size_t place) const {
    const CellHint& hint = verdict.hint;
    const auto half = [&](std::size_t k) { return std::uint32_t{static_cast<std::uint16_t>(hint.shift[k])}; };
    Words words{hint.ball_face, hint.socket_face, hint.vertex,
                static_cast<std::uint32_t>(verdict.state) + (hint.of_ball ? 4U : 0U) + (half(0) << 16U),
                half(1) + (half(2) << 16U)};
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
      const auto half = [](std::uint32_t bits) {
        return static_cast<std::int16_t>(static_cast<std::uint16_t>(bits));
      };
      const ShiftSteps shift{half(words[3] >> 16U), half(words[4]), half(words[4] >> 16U)};
      const CellVerdict verdict{static_cast<CellState>(words[3] % 4),
                                {words[0], words[1], words[2], (words[3] & 4U) != 0, shift}};
      if (bytes.compare(at, sizeof words, bytes_of(verdict, known_.size())) != 0) return;
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

std::shared_ptr<TemporaryFile> write_cells(const std::filesystem::path& path, const MotionVolume& volume,
                                           bool with_play) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 24;
  auto file = std::make_shared<TemporaryFile>(path);
  std::string text;
  std::vector<Column> columns = columns_of<VolumeRow>();
  if (with_play) std::ranges::copy(columns_of<ShiftRow>(), std::back_inserter(columns));
  for (const Column& column : columns) text += (text.empty() ? "" : ",") + column.name;
  text += "\n";
  volume.for_each([&](const VolumeCell& at) {
    auto cells = cells_of(volume_row(at));
    if (with_play) std::ranges::copy(cells_of(shift_row(at)), std::back_inserter(cells));
    text += csv_line(cells);
    if (text.size() < kAtOnce) return;
    file->write(text);
    text.clear();
  });
  file->write(text);
  return file;
}

// Why the width may be out of reach; empty where it is not.
std::string never_decided(const SessionJoint& joint, const BodyPairs& bodies) {
  const auto pair = bodies.without_inside();
  if (!pair) return {};
  const auto named = [](const JointPart& of, std::size_t body, const char* bone) {
    return body_name(of.parts, body).value_or(bone);
  };
  return "openings leave it open what is inside of " +
         named(joint.joint.ball, pair->ball, "the ball's bone") + " and of " +
         named(joint.joint.socket, pair->socket, "the socket's bone") +
         ": rotations in which these meet stay undecided; close the openings, or crop both meshes to the "
         "joint";
}

std::string words_of_volume(const VolumeAnswer& found, const VolumeRequest& request, const Joint& joint,
                            const std::string& why) {
  const VolumeShares& shares = found.shares();
  std::string text = formatted("free                %.2f to %.2f %% of all rotations", 100.0 * shares.low(),
                               100.0 * shares.high());
  if (shares.unknown > 0.0)
    text += formatted("; of %.2f %% nothing is known: the ball's mesh ends there", 100.0 * shares.unknown);
  if (request.play_mm > 0.0)
    text += formatted("; each with some shift of the ball, up to %g mm", request.play_mm);
  text += formatted(
      "\nmobility            %.2f to %.2f million degrees^3 of 14.85, weighted by the cosine\n"
      "                    of bones alone: ligaments and muscles forbid most of what bones allow",
      1e-6 * found.mobility_low_deg3(), 1e-6 * found.mobility_high_deg3());
  if (found.by_radii && shares.high() < 1.0) text += "\n" + std::string(kBlockedByRadii);
  if (found.neutral_blocked())
    return text + formatted("\nreachable           none: the %s is blocked\n", name_of_rest(joint));
  text += formatted("\nreachable           %.2f to %.2f %% from the %s without contact\n",
                    100.0 * shares.reached(), 100.0 * shares.within_reach(), name_of_rest(joint));
  if (request.play_mm > 0.0)
    text += "                    at least: without a shift, for between two shifts bones may meet\n";
  if (shares.open > request.width)
    text += formatted("undecided           %.2f %%: more than was wanted, after %zu cells\n",
                      100.0 * shares.open, shares.cells) +
            (why.empty() ? "" : "                    " + why + "\n");
  return text;
}

// Until the answer is in place, volume-KEY.part holds what was worked out. A later run continues from there
// and ends with the same bytes.
VolumeAnswer refined(Session& session, const VolumeRequest& request, const Work& work, Told& told) {
  std::optional<VerdictFile> part;
  if (work.out) part.emplace(*work.out, answer_key(*session.joint, json_of(request), kVerdicts));
  VolumeSettings how{.most_cells = kMostVolumeCells, .threads = work.threads};
  if (part) how.known = part->known();
  if (!how.known.empty()) work.say(std::to_string(how.known.size()) + " cells were decided before");
  Stopwatch watch;
  double silent_ms = 0.0;
  std::size_t cells = 0;
  how.reached = [&](std::span<const CellVerdict> batch, double open) {
    if (part) part->add(batch);
    cells += batch.size();
    constexpr double kSilence = 2000.0;  // ms
    if ((silent_ms += watch.lap_ms()) < kSilence) return;
    silent_ms = 0.0;
    work.say(std::to_string(cells) +
             formatted(" cells, %.3f of all rotations open, %.3f wanted", open, request.width));
  };
  VolumeAnswer found = answer(session, request, how);
  if (work.out) told.wrote = {write_cells(work.output("volume.csv"), found.volume, request.play_mm > 0.0)};
  if (part) told.spent = {part->file()};
  return found;
}

}  // namespace

Told tell_volume(Session& session, const VolumeRequest& request, const Work& work) {
  Told told{};
  const std::string why = never_decided(*session.joint, session.joint->bodies());
  if (!why.empty()) work.say(why);
  const VolumeAnswer found = refined(session, request, work, told);
  told.words = words_of_volume(found, request, session.joint->joint, why);
  told.document = json_of(found);
  for (const char* share : {"share_low", "share_high", "reachable_low", "reachable_high", "unknown", "open"})
    told.row_of_one.push_back({share, std::string("/") + share});
  if (!work.out) return told;
  if (session.joint->side)
    told.files.push_back({"volume.svg", volume_picture(found.volume, *session.joint->side)});
  if (session.joint->side)
    told.files.push_back({"mobility.svg", mobility_picture(found.volume, *session.joint->side)});
  told.files.push_back({"volume.json", text_of(told.document)});
  return told;
}

QuestionCommand volume_question() {
  return question_of<VolumeRequest, VolumeAnswer>(
      "volume", "Which share of all rotations is free of contact, and can be reached: proven, to the edges.",
      "femur.ply pelvis.ply --side left --width 0.01", &tell_volume);
}

}  // namespace impinge
