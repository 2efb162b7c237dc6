// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/shard.hpp"

#include <charconv>
#include <cmath>
#include <ctime>
#include <optional>
#include <stdexcept>
#include <string>

#include "cohort/answers.hpp"
#include "cohort/member.hpp"
#include "cohort/summary.hpp"
#include "files/file_bytes.hpp"
#include "files/file_set.hpp"
#include "files/stopwatch.hpp"
#include "harness/provenance.hpp"
#include "report/answer_document.hpp"

namespace impinge::lab {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr double kSecondsBetweenWrites = 5.0;  // work that a killed run loses at most

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::string line_of(const std::vector<Cell>& cells) {
  std::string line;
  for (const Cell& cell : cells) line += (line.empty() ? "" : ",") + cell.text();
  return line + "\n";
}

void write_shard(const fs::path& file, const Study& study, const Members& members, const ShardHips& hips,
                 const ShardRows& found) {
  const json head{{"study", study.digest},
                  {"joints", members.digest()},
                  {"commit", commit()},
                  {"first", hips.first},
                  {"last", hips.last},
                  {"rows", found.rows},
                  {"sha256", sha256_hex(found.csv)},
                  {"seconds", found.seconds},
                  {"cpu", found.cpu}};
  write_bytes(file, head.dump() + "\n" + found.csv);
}

// Takes a folder that is empty or belongs to this study.
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

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t kNamed = 10;  // shards named in one line

// Reads "i-of-K.rows"; none for other files.
std::optional<ShardName> shard_named(const fs::path& file) {
  if (file.extension() != ".rows") return std::nullopt;
  std::string text = file.stem().string();
  const std::size_t of = text.find("-of-");
  if (of == std::string::npos) return std::nullopt;
  try {
    return parse_shard(text.replace(of, 4, "/"));
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// The number of shards into which the study of a folder is cut.
std::size_t shards_in(const fs::path& folder) {
  std::optional<std::size_t> count;
  if (fs::is_directory(folder / "shards")) {
    for (const auto& entry : fs::directory_iterator(folder / "shards")) {
      const std::optional<ShardName> shard = shard_named(entry.path());
      if (!shard) continue;
      if (count && *count != shard->of)
        throw std::runtime_error(folder.string() + " holds shards of " +
                                 std::to_string(std::min(*count, shard->of)) + " and of " +
                                 std::to_string(std::max(*count, shard->of)) +
                                 ": remove those of one of the two in " + (folder / "shards").string());
      count = shard->of;
    }
  }
  if (count) return *count;
  throw std::runtime_error(folder.string() + " holds no shard: run cohort --study FILE --shard 1/1 --out " +
                           folder.string());
}

// The shards that prevent a merge, and how to make them.
struct Faults {
  std::vector<std::string> numbers;
  std::string first;  // what is wrong with the first

  void add(std::size_t i, const std::string& why) {
    if (numbers.empty()) first = why;
    numbers.push_back(std::to_string(i));
  }
  void require_none(std::size_t of) const {
    if (numbers.empty()) return;
    std::string list;
    for (std::size_t k = 0; k < numbers.size() && k < kNamed; ++k) list += (k == 0 ? "" : ", ") + numbers[k];
    if (numbers.size() > kNamed) list += " and " + std::to_string(numbers.size() - kNamed) + " more";
    throw std::runtime_error((numbers.size() == 1 ? "shard " : "shards ") + list + " of " +
                             std::to_string(of) + " cannot be merged, the first because " + first +
                             ": run cohort --shard " + numbers.front() + "/" + std::to_string(of) + " again");
  }
};

struct AllShards {
  std::string csv;  // rows
  json taken = json::array();
};

AllShards read_all(const fs::path& folder, const Study& study, const Members& members, std::size_t count) {
  AllShards all;
  Faults faults;
  for (std::size_t i = 1; i <= count; ++i) {
    const fs::path file = shard_file(folder, {i, count});
    const ShardHips range = hips_of({i, count}, members.size());
    if (!fs::exists(file)) {
      faults.add(i, "it is missing");
      continue;
    }
    try {
      const ShardRows rows = read_shard(file, study, members, range);
      if (rows.rows != range.last - range.first) {
        faults.add(i, "it has " + std::to_string(rows.rows) + " of its " +
                          std::to_string(range.last - range.first) + " hips");
        continue;
      }
      all.csv += rows.csv;
      all.taken.push_back(
          {{"shard", i}, {"hips", rows.rows}, {"processor_s", rows.seconds}, {"cpu", rows.cpu}});
    } catch (const std::runtime_error& error) {
      faults.add(i, error.what());
    }
  }
  faults.require_none(count);
  return all;
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
  const std::size_t more = hips % shard.of;  // this many shards have one hip more
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

ShardRows read_shard(const fs::path& file, const Study& study, const Members& members,
                     const ShardHips& hips) {
  const auto broken = [&](const std::string& why) -> std::runtime_error {
    return std::runtime_error(file.string() + ": " + why + "; remove it and work out this shard again");
  };
  const std::string bytes = read_bytes(file);
  const std::size_t end = bytes.find('\n');
  const json head = json::parse(bytes.substr(0, end), nullptr, /*allow_exceptions=*/false);
  if (end == std::string::npos || !head.is_object()) throw broken("is no shard");
  try {
    if (head.at("study") != study.digest) throw broken("is of another study");
    if (head.at("joints") != members.digest()) throw broken("was worked out when the joints had other files");
    if (head.at("commit") != commit())
      throw broken("was worked out by another version of the program, " + head.at("commit").dump());
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
  ShardRun run{hips_of(shard, members.size()), 0, 0.0, members.warnings()};
  for (const std::string& line : members.left_out()) run.warnings.push_back("left out: " + line);
  ShardRows found;
  if (fs::exists(file)) found = read_shard(file, study, members, run.hips);
  run.kept = found.rows;
  found.cpu = this_machine().cpu;
  const double before = found.seconds;
  const double start = processor_seconds();
  Stopwatch watch;
  double since_write = 0.0;
  const auto save = [&] {
    run.seconds = processor_seconds() - start;
    found.seconds = before + run.seconds;
    write_shard(file, study, members, run.hips, found);
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

Merged merge(const fs::path& folder) {
  if (!fs::exists(folder / "study.json"))
    throw std::runtime_error(folder.string() +
                             " holds no study.json: it is no folder that cohort --out made");
  const Study study = read_study(folder / "study.json", std::nullopt);
  const std::size_t count = shards_in(folder);
  const Members members(study);
  const AllShards all = read_all(folder, study, members, count);
  Table head;
  head.columns = cohort_columns(study);
  const std::string csv = to_csv(head) + all.csv;
  json summary = summary_of(study, head.columns, all.csv);
  summary["cohort_csv_sha256"] = sha256_hex(csv);
  summary["commit"] = commit();
  if (!study.joints.empty()) {
    summary["left_out"] = members.left_out();
    summary["warnings"] = members.warnings();
  }
  FileSet files;
  files.add(folder / "cohort.csv", csv);
  files.add(folder / "cohort.json", summary.dump(1) + "\n");
  files.add(folder / "shards.json", json{{"shards", all.taken}}.dump(1) + "\n");
  files.commit();
  return {members.size(), count};
}

}  // namespace impinge::lab
