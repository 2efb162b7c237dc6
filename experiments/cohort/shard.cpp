// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/shard.hpp"

#include <charconv>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include "cohort/answers.hpp"
#include "files/file_bytes.hpp"
#include "files/stopwatch.hpp"
#include "harness/digest.hpp"
#include "harness/machine.hpp"

namespace impinge::lab {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr double kSecondsBetweenWrites = 5.0;  // what a killed run loses

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::string line_of(const std::vector<Cell>& cells) {
  std::string line;
  for (const Cell& cell : cells) line += (line.empty() ? "" : ",") + cell.text();
  return line + "\n";
}

void write_shard(const fs::path& file, const Study& study, const ShardHips& hips, const ShardRows& found) {
  const json head{{"study", study.digest},
                  {"first", hips.first},
                  {"last", hips.last},
                  {"rows", found.rows},
                  {"sha256", sha256_hex(found.csv)},
                  {"seconds", found.seconds},
                  {"cpu", found.cpu}};
  write_bytes(file, head.dump() + "\n" + found.csv);
}

// Of this study, or an empty folder that becomes its.
void claim_folder(const fs::path& folder, const Study& study) {
  const fs::path file = folder / "study.json";
  const std::string text = study.text.dump(2) + "\n";
  if (fs::exists(file)) {
    if (holds(file, text)) return;
    throw std::runtime_error(
        folder.string() +
        " holds another study, or one of another number of hips: choose another folder with "
        "--out");
  }
  write_bytes(file, text);
}

}  // namespace

ShardName parse_shard(const std::string& text) {
  const char* const end = text.data() + text.size();
  ShardName shard;
  const auto [slash, wrong] = std::from_chars(text.data(), end, shard.i);
  if (wrong == std::errc() && slash != end && *slash == '/') {
    const auto [rest, wrong_too] = std::from_chars(slash + 1, end, shard.of);
    if (wrong_too == std::errc() && rest == end && shard.i >= 1 && shard.i <= shard.of) return shard;
  }
  throw std::invalid_argument("'" + text + "' is no shard; give i/K with i from 1 to K, as 3/12");
}

ShardHips hips_of(const ShardName& shard, std::size_t hips) {
  const std::size_t each = hips / shard.of;
  const std::size_t more = hips % shard.of;  // so many shards have one more
  const auto before = [&](std::size_t i) { return i * each + std::min(i, more); };
  return {before(shard.i - 1), before(shard.i)};
}

fs::path shard_file(const fs::path& folder, const ShardName& shard) {
  return folder / "shards" / (std::to_string(shard.i) + "-of-" + std::to_string(shard.of) + ".rows");
}

std::vector<Column> cohort_columns(const Study& study) {
  std::vector<Column> columns{{"hip", "1", "number of the hip, from 0"}};
  for (const auto& list : {Members(study).description_columns(), answer_columns(study)})
    columns.insert(columns.end(), list.begin(), list.end());
  return columns;
}

std::vector<Cell> cohort_row(const Study& study, const Members& members, std::size_t j) {
  const Member member = members.member(j);
  std::vector<Cell> cells{j};
  cells.insert(cells.end(), member.description.begin(), member.description.end());
  for (Cell& cell : answers(study, member)) cells.push_back(std::move(cell));
  return cells;
}

ShardRows read_shard(const fs::path& file, const Study& study, const ShardHips& hips) {
  const auto broken = [&](const std::string& why) -> std::runtime_error {
    return std::runtime_error(file.string() + ": " + why + "; remove it and work out this shard again");
  };
  const std::string bytes = read_bytes(file);
  const std::size_t end = bytes.find('\n');
  const json head = json::parse(bytes.substr(0, end), nullptr, /*allow_exceptions=*/false);
  if (end == std::string::npos || !head.is_object()) throw broken("is no shard");
  try {
    if (head.at("study") != study.digest) throw broken("is of another study");
    if (head.at("first") != hips.first || head.at("last") != hips.last) throw broken("is of other hips");
    ShardRows found{head.at("rows"), bytes.substr(end + 1), head.at("seconds"), head.at("cpu")};
    if (head.at("sha256") != sha256_hex(found.csv))
      throw broken("is broken, its rows are not those that were written");
    return found;
  } catch (const json::exception&) {
    throw broken("is no shard");
  }
}

ShardRun run_shard(const Study& study, const ShardName& shard, const fs::path& folder) {
  const Members members(study);
  claim_folder(folder, study);
  const fs::path file = shard_file(folder, shard);
  require_writable_folder(file.parent_path());
  ShardRun run{hips_of(shard, members.size()), 0, 0.0};
  ShardRows found;
  if (fs::exists(file)) found = read_shard(file, study, run.hips);
  run.kept = found.rows;
  found.cpu = this_machine().cpu;
  const double before = found.seconds;
  const double start = processor_seconds();
  Stopwatch watch;
  double since_write = 0.0;
  const auto save = [&] {
    run.seconds = processor_seconds() - start;
    found.seconds = before + run.seconds;
    write_shard(file, study, run.hips, found);
    since_write = 0.0;
  };
  for (std::size_t j = run.hips.first + found.rows; j < run.hips.last; ++j) {
    found.csv += line_of(cohort_row(study, members, j));
    ++found.rows;
    since_write += watch.lap_s();
    if (since_write > kSecondsBetweenWrites) save();
  }
  if (run.kept < found.rows || found.rows == 0) save();
  return run;
}

}  // namespace impinge::lab
