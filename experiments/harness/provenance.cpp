// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/provenance.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

#include <openssl/evp.h>
#include <sys/utsname.h>

#include "files/file_bytes.hpp"
#include "files/memory.hpp"
#include "harness/build_info.hpp"

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

// Did this driver write the sidecar on the disk for these bytes?
bool describes(const std::filesystem::path& path, const std::string& csv_digest) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored) || std::filesystem::is_empty(path, ignored))
    return false;
  const json old = json::parse(read_bytes(path), nullptr, /*allow_exceptions=*/false);
  return old.is_object() && old.value("csv_sha256", json()) == csv_digest &&
         old.value("driver_sha256", json()) == driver_digest();
}

// What a git command prints, or nothing when it fails.
std::optional<std::string> git(const std::filesystem::path& folder, const std::string& arguments) {
  const std::string command = "git -C " + shell_quoted(folder.string()) + " " + arguments + " 2>/dev/null";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    text.append(buffer.data(), count);
  }
  if (::pclose(pipe) != 0) return std::nullopt;
  return text;
}

// Notes in the root of the clone, or scenes written there, do not count, as they change no result.
std::optional<bool> has_changes(const std::filesystem::path& folder) {
  const auto changed = git(folder, "status --porcelain --untracked-files=no");
  const auto added =
      git(folder, "ls-files --others --exclude-standard -- libcore experiments analysis paper");
  if (!changed || !added) return std::nullopt;
  return !changed->empty() || !added->empty();
}

// Value of the first "name : value" line of /proc/cpuinfo, or unknown.
std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string first_line(const char* path) {
  std::ifstream file(path);
  std::string line;
  return std::getline(file, line) ? line : "unknown";
}

std::string system_name() {
  utsname name{};
  if (::uname(&name) != 0) return "unknown";
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
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

SourceState source_state(const std::filesystem::path& folder) {
  SourceState state;
  const char* commit = std::getenv("IMPINGE_COMMIT");
  if (commit != nullptr && *commit != '\0') {
    state.commit = commit;
    if (const char* dirty = std::getenv("IMPINGE_DIRTY")) {
      const std::string_view flag = dirty;
      state.dirty = flag == "1" || flag == "yes" || flag == "true";
    }
    return state;
  }
  if (const auto head = git(folder, "rev-parse HEAD")) {
    state.commit = head->substr(0, head->find('\n'));
    state.dirty = has_changes(folder);
  }
  return state;
}

Machine this_machine() {
  Machine machine;
  machine.cpu = cpu_model();
  machine.cores = std::thread::hardware_concurrency();
  machine.memory_mib = physical_memory() >> 20U;
  machine.governor = first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  if (::getloadavg(&machine.load, 1) != 1) machine.load = 0.0;
  machine.system = system_name();
  return machine;
}

std::string sha256_hex(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 is not available in this build of OpenSSL");
  }
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    text += kHex[digest[i] >> 4U];
    text += kHex[digest[i] & 15U];
  }
  return text;
}

std::string sha256_of_file(const std::filesystem::path& path) { return sha256_hex(read_bytes(path)); }

}  // namespace impinge::lab
