// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/provenance.hpp"

#include <array>
#include <ctime>
#include <system_error>

#include "files/file_bytes.hpp"
#include "harness/build_info.hpp"
#include "harness/digest.hpp"
#include "harness/machine.hpp"
#include "harness/source_state.hpp"

namespace impinge::lab {
namespace {

using nlohmann::json;

const std::string& driver_digest() {
  static const std::string kDigest = sha256_of_file("/proc/self/exe");
  return kDigest;
}

std::string utc_text(std::chrono::system_clock::time_point time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {text.data(), length};
}

json columns_of(const Table& table) {
  json columns = json::array();
  for (const Column& column : table.columns) {
    columns.push_back({{"name", column.name}, {"unit", column.unit}, {"meaning", column.meaning}});
  }
  return columns;
}

void add_build(json& record) {
  const BuildInfo& build = build_info();
  const SourceState source = source_state(build.source_folder);
  record["commit"] = source.commit;
  record["dirty"] = source.dirty ? json(*source.dirty) : json(nullptr);
  record["driver_sha256"] = driver_digest();
  record["compiler"] = build.compiler;
  record["flags"] = build.flags;
  record["build_type"] = build.build_type;
  record["libraries"] = build.libraries;
}

void add_machine(json& record) {
  const Machine machine = this_machine();
  record["cpu"] = machine.cpu;
  record["cores"] = machine.cores;
  record["memory_mib"] = machine.memory_mib;
  record["governor"] = machine.governor;
  record["load"] = machine.load;
  record["system"] = machine.system;
}

// True when the sidecar on the disk was written by this driver for these bytes.
bool describes(const std::filesystem::path& path, const std::string& csv_digest) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored) || std::filesystem::is_empty(path, ignored))
    return false;
  const json old = json::parse(read_bytes(path), nullptr, /*allow_exceptions=*/false);
  return old.is_object() && old.value("csv_sha256", json()) == csv_digest &&
         old.value("driver_sha256", json()) == driver_digest();
}

}  // namespace

json sidecar(const RunRecord& run, const Result& result, const std::string& csv) {
  json record{{"name", result.name},
              {"question", result.question},
              {"rows", result.table.rows.size()},
              {"parameters", result.parameters},
              {"seed", run.seed},
              {"profile", run.profile},
              {"driver", run.driver},
              {"command", run.command},
              {"started_utc", utc_text(run.start)},
              {"csv_sha256", sha256_hex(csv)}};
  record["columns"] = columns_of(result.table);
  if (!result.timing.is_null()) record["timing"] = result.timing;
  if (!result.labels.empty()) record["labels"] = result.labels;
  add_build(record);
  add_machine(record);
  const std::chrono::duration<double> duration = std::chrono::system_clock::now() - run.start;
  record["duration_s"] = duration.count();
  return record;
}

void write_result(const RunRecord& run, const Result& result) {
  const std::string csv = to_csv(result.table);
  const bool changed = write_if_changed(run.folder / (result.name + ".csv"), csv);
  const std::filesystem::path path = run.folder / (result.name + ".json");
  if (!changed && describes(path, sha256_hex(csv))) return;
  write_if_changed(path, sidecar(run, result, csv).dump(2) + "\n");
}

}  // namespace impinge::lab
