// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/merge.hpp"

#include <charconv>
#include <optional>
#include <stdexcept>
#include <string>

#include "cohort/member.hpp"
#include "cohort/shard.hpp"
#include "cohort/summary.hpp"
#include "files/file_bytes.hpp"
#include "files/file_set.hpp"
#include "harness/digest.hpp"

namespace impinge::lab {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t kNamed = 10;  // shards in one line

// From "i-of-K.rows"; none for other files.
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

// Into how many shards the study of this folder was cut.
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

// The shards that stop a merge, and how to make them.
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

AllShards read_all(const fs::path& folder, const Study& study, std::size_t hips, std::size_t count) {
  AllShards all;
  Faults faults;
  for (std::size_t i = 1; i <= count; ++i) {
    const fs::path file = shard_file(folder, {i, count});
    const ShardHips range = hips_of({i, count}, hips);
    if (!fs::exists(file)) {
      faults.add(i, "it is missing");
      continue;
    }
    try {
      const ShardRows rows = read_shard(file, study, range);
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

Merged merge(const fs::path& folder) {
  if (!fs::exists(folder / "study.json"))
    throw std::runtime_error(folder.string() +
                             " holds no study.json: it is no folder that cohort --out made");
  const Study study = read_study(folder / "study.json", std::nullopt);
  const std::size_t count = shards_in(folder);
  const std::size_t hips = Members(study).size();
  const AllShards all = read_all(folder, study, hips, count);
  Table head;
  head.columns = cohort_columns(study);
  const std::string csv = to_csv(head) + all.csv;
  json summary = summary_of(study, head.columns, all.csv);
  summary["cohort_csv_sha256"] = sha256_hex(csv);
  FileSet files;
  files.add(folder / "cohort.csv", csv);
  files.add(folder / "cohort.json", summary.dump(1) + "\n");
  files.add(folder / "shards.json", json{{"shards", all.taken}}.dump(1) + "\n");
  files.commit();
  return {hips, count};
}

}  // namespace impinge::lab
