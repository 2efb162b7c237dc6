// SPDX-License-Identifier: GPL-3.0-or-later
// A result is NAME.csv and the sidecar NAME.json that says how it came to be. The report refuses a CSV
// without a sidecar that carries its hash.
//
// Keys of the sidecar: name, question, columns (name, unit, meaning), rows, parameters, seed, profile,
// driver, driver_sha256, command, commit, dirty (null when unknown), compiler, flags, build_type, libraries,
// cpu, cores, memory_mib, governor, load, system, started_utc (ISO 8601), duration_s, csv_sha256, timing
// for timed results, and labels of methods.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "files/csv.hpp"

namespace impinge::lab {

// What is written: one file and what a reader must know about it.
struct Result {
  std::string name;                                      // of the file, without .csv
  std::string question;                                  // which the rows answer
  Table table = {};                                      // the rows
  nlohmann::json parameters = nlohmann::json::object();  // everything that was chosen
  nlohmann::json timing = {};                            // protocol and control of a timed result, else null
  std::map<std::string, std::string> labels = {};        // from names of methods to their readable labels
};

// What all results of one run of a driver share.
struct RunRecord {
  std::string driver;            // name of the program
  std::string command;           // command line, an absolute folder of joints replaced by BONES
  std::string profile = "full";  // quick or full
  std::uint64_t seed = 0;        // of all random numbers
  std::filesystem::path folder;  // of the results
  std::chrono::system_clock::time_point start = std::chrono::system_clock::now();  // of the run
};

// The sidecar of a result whose file has these bytes.
nlohmann::json sidecar(const RunRecord& run, const Result& result, const std::string& csv);

// Writes the CSV, then the sidecar, each atomically. Changes nothing if the CSV has these bytes already and
// its sidecar names the hashes of these bytes and of this driver. Throws std::runtime_error with path and
// reason.
void write_result(const RunRecord& run, const Result& result);

// Which version of the sources a result came from.

struct SourceState {
  std::string commit = "unknown";  // full hash
  std::optional<bool> dirty;  // uncommitted changes, or new files among the sources; nothing when unknown
};

// From the environment (IMPINGE_COMMIT, IMPINGE_DIRTY: 1, yes or true mean dirty) when IMPINGE_COMMIT is set,
// else from git in the given folder, the root of the repository, else unknown. New files count only below
// libcore, experiments, analysis and paper, unless git ignores them. Never throws because of a missing git or
// repository.
SourceState source_state(const std::filesystem::path& folder);

// The machine that a result was measured on, as the operating system reports it. Only reads.

struct Machine {
  std::string cpu = "unknown";       // model name
  unsigned cores = 0;                // logical processors
  std::uint64_t memory_mib = 0;      // physical memory, MiB
  std::string governor = "unknown";  // frequency governor of the first core
  double load = 0.0;                 // average of runnable processes over the last minute
  std::string system = "unknown";    // name and release of the operating system, processor family
};

Machine this_machine();  // as it is now

// SHA-256 of results and programs, by OpenSSL.

// 64 lower-case hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

// The same for the bytes of a file. Throws std::runtime_error when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

// Quoting for the shell.

// The text quoted so that a POSIX shell reads it as one word.
inline std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace impinge::lab
