// SPDX-License-Identifier: GPL-3.0-or-later
// @question  What does one question need, compared with all of them and with another library?
// @writes    scene_needs scene_needs_samples
// @bones     yes
// @timing    yes
// @seconds   18 300
// @links     harness 17_limit_time joint gaps_methods steps_methods
//
// The questions are touch, smallest gap and all gaps of a pose, limits of all named motions, the volume of
// all rotations and measures of a joint. Each is asked alone; together with all others and every output, as
// in a report; and of other libraries: FCL and ODE for whether surfaces meet, in steps for limits and in a
// grid of poses for the volume, Embree and CGAL along rays. Making trees and tables is part of each time.
// Before anything is timed the answers are compared: leaving out work may not change a bit of ours.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "12_scene_needs/questions.hpp"
#include "harness/driver.hpp"
#include "harness/timing.hpp"
#include "sphere/radial_table.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kFaces = 24000;  // faces of both surfaces of the generated hip
constexpr std::size_t kFacesInQuick = 4000;
constexpr int kRounds = 7;
constexpr int kRoundsInQuick = 3;

// A row: a way to answer a question, or all of them.
struct NeedsRow {
  const AskedJoint* joint = nullptr;
  std::string question;
  std::string way;
  std::function<Kept()> work;
  std::function<void()> before{};
  double share = 1.0;
  LookedAt looked_at{};
  double differs = 0.0;  // difference from our answer
  UsedMemory memory{kNoSurface, kNoSurface};
  std::shared_ptr<std::vector<double>> cpu_ms = std::make_shared<std::vector<double>>();

  std::vector<Cell> key() const { return {joint->name, question, way}; }
};

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) {
    return (std::isnan(x) && std::isnan(y)) ||
           std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

// NaN if the answers have other numbers.
double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::quiet_NaN();
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!std::isnan(a[k]) && !std::isnan(b[k])) largest = std::max(largest, std::abs(a[k] - b[k]));
  }
  return largest;
}

void add_rows(AskedJoint& joint, const Asking& asking, std::map<std::string, std::string>& labels,
              std::vector<NeedsRow>& rows) {
  const auto renew = [&joint] { joint.renew(); };
  const std::vector<AskedQuestion> questions = questions_of(joint, asking, labels);
  renew();
  const std::vector<Answered> all = everything(joint, asking);
  for (std::size_t q = 0; q < questions.size(); ++q) {
    const AskedQuestion& question = questions[q];
    renew();
    const std::vector<double> ours = question.ways.front().answer().numbers;
    if (!same_bits(ours, all[q].numbers))
      throw std::runtime_error(joint.name + ": the answer to '" + question.name + "' alone is not the same");
    for (const Way& way : question.ways) {
      const bool of_ours = &way == &question.ways.front();
      NeedsRow row{&joint, question.name, way.name, [answer = way.answer] { return answer().kept; }};
      row.before = of_ours ? std::function<void()>(renew) : std::function<void()>();
      row.share = way.share;
      if (of_ours)
        row.looked_at = question.looked_at;
      else
        row.differs = largest_difference(ours, way.answer().numbers);
      rows.push_back(std::move(row));
    }
  }
  NeedsRow row{
      &joint, "everything", "everything",
      [&joint, asking] { return Kept(std::make_shared<std::vector<Answered>>(everything(joint, asking))); },
      renew};
  row.looked_at = {joint.faces(), joint.bones.ball.vertices.size() + joint.bones.socket.vertices.size()};
  rows.push_back(std::move(row));
}

double cpu_now_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

TimingRun timed(const std::vector<NeedsRow>& rows, int rounds, Progress& progress) {
  std::vector<TimedCase> cases;
  for (const NeedsRow& row : rows) {
    TimedCase one;
    one.key = row.key();
    one.run = [&row] {
      const double before = cpu_now_ms();
      benchmark::DoNotOptimize(row.work());
      row.cpu_ms->push_back(cpu_now_ms() - before);
    };
    one.before = row.before;
    one.units = row.share;
    one.rounds = rounds;
    cases.push_back(std::move(one));
  }
  TimingOptions protocol;
  protocol.slow_ms = 50.0;
  protocol.repeat_share = 0.1;
  protocol.least_repeat_s = 0.5;
  return run_interleaved(cases, protocol, progress);
}

std::vector<Column> keys() {
  return {{"joint", "", "a generated hip, or the folder of a real joint; of whole bones where it has them"},
          {"question", "", "or everything: all of them and every output, by one session"},
          {"way", "", "needed: ours, asked that alone; everything; else a method of another library"}};
}

Cell count_or_none(const std::optional<std::size_t>& count) { return count ? Cell(*count) : Cell(); }
Cell bytes_or_none(double bytes) { return std::isnan(bytes) ? Cell() : Cell(bytes); }

Table table_of(const std::vector<NeedsRow>& rows, const TimingRun& timing) {
  Table table{keys(), {}};
  table.columns.insert(
      table.columns.end(),
      {{"faces", "1", "of both sides"},
       {"vertices", "1", "likewise"},
       {"cpu_ms", "ms", "processor time from the meshes to the answer, median"},
       {"cpu_iqr_ms", "ms", "interquartile range of it"},
       {"times_needed", "1", "processor time over that of ours, asked that alone"},
       {"median_ms", "ms", "the same, wall clock, median"},
       {"iqr_ms", "ms", "interquartile range of it"},
       {"peak_bytes", "bytes", "most memory beyond that of the meshes; empty: not counted"},
       {"touched_bytes", "bytes", "pages of memory that were read or written, the meshes' included"},
       {"faces_looked_at", "1",
        "one by one, beside making trees of all; of everything all; empty: not counted"},
       {"vertices_looked_at", "1", "likewise"},
       {"differs", "", "largest difference of a number of the answer from ours, mm, deg or 1"},
       {"extrapolated", "", "yes: the time is that of some poses, scaled to all"},
       {"inconclusive", "", "yes: the spread or that of the control of its run is too large"}});
  double needed_ms = 1.0;
  for (const NeedsRow& row : rows) {
    const Timing& wall = find(timing, row.key());
    const Summary cpu = summarise(*row.cpu_ms);
    const double cpu_ms = cpu.median / row.share;
    if (row.way == "needed") needed_ms = cpu_ms;
    std::vector<Cell> cells = row.key();
    cells.insert(
        cells.end(),
        {row.joint->faces(), row.joint->bones.ball.vertices.size() + row.joint->bones.socket.vertices.size(),
         cpu_ms, cpu.iqr / row.share, row.question == "everything" ? Cell() : Cell(cpu_ms / needed_ms),
         wall.summary.median, wall.summary.iqr, bytes_or_none(row.memory.peak_bytes),
         bytes_or_none(row.memory.touched_bytes), count_or_none(row.looked_at.faces),
         count_or_none(row.looked_at.vertices), row.differs, row.share < 1.0, wall.inconclusive});
    table.add_row(std::move(cells));
  }
  return table;
}

// The generated hip, and real joints with whole bones; a quick run takes the one with the fewest faces.
std::vector<TurnedJoint> joints_of(DriverRun& run) {
  std::vector<TurnedJoint> joints{generated_hip(run.quick() ? kFacesInQuick : kFaces)};
  if (!run.bones) return joints;
  std::vector<TurnedJoint> whole = whole_joints(*run.bones, run.progress);
  std::ranges::sort(whole, {}, &TurnedJoint::faces);
  if (run.quick() && whole.size() > 1) whole.resize(1);
  std::ranges::move(whole, std::back_inserter(joints));
  return joints;
}

void body(DriverRun& run) {
  const Asking asking = run.quick() ? Asking{0.2, 0.1, 50} : Asking{0.05, 0.1, 500};
  std::map<std::string, std::string> labels{{"needed", "impinge, this alone"},
                                            {"everything", "impinge, everything"}};
  std::vector<std::unique_ptr<AskedJoint>> joints;
  std::vector<NeedsRow> rows;
  for (const TurnedJoint& joint : joints_of(run)) {
    joints.push_back(std::make_unique<AskedJoint>(joint));
    add_rows(*joints.back(), asking, labels, rows);
    run.progress.say("compared the answers of " + joint.name);
  }
  for (NeedsRow& row : rows) {
    if (row.share == 1.0)
      row.memory = used_memory(
          row.before ? row.before : [] {}, row.work);
  }
  const TimingRun timing = timed(rows, run.quick() ? kRoundsInQuick : kRounds, run.progress);
  Result result{"scene_needs", "What does one question need, beside all of them and beside other libraries?",
                table_of(rows, timing)};
  result.parameters = {{"pose", "flexion=60"}, {"volume_width", asking.width}, {"step_deg", asking.step_deg}};
  result.labels = labels;
  write_timed(run, result, keys(), timing);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv,
      {"12_scene_needs", "What one question needs, and what it leaves out.", /*takes_bones=*/true}, body);
}
