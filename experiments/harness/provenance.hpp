// SPDX-License-Identifier: GPL-3.0-or-later
// A result is NAME.csv with the sidecar NAME.json, which says how it was made. The report refuses a CSV
// without a sidecar that has its hash. Keys of the sidecar: name, question, columns (name, unit, meaning),
// rows, parameters, seed, profile, driver, driver_sha256, command, commit, dirty (null when unknown),
// compiler, flags, build_type, libraries, cpu, cores, memory_mib, governor, load, system, started_utc (ISO
// 8601), duration_s, csv_sha256, timing for timed results, and labels of methods.
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

// A result: a table and what a reader must know about it.
struct Result {
  std::string name;                                      // of the file, without .csv
  std::string question;                                  // that the rows answer
  Table table = {};                                      // the rows
  nlohmann::json parameters = nlohmann::json::object();  // all choices
  nlohmann::json timing = {};                            // protocol and control of a timed result, else null
  std::map<std::string, std::string> labels = {};        // readable label of each method
};

// What all results of one run of a driver have in common.
struct RunRecord {
  std::string driver;            // name of the program
  std::string command;           // command line, with BONES for an absolute folder of joints
  std::string profile = "full";  // quick or full
  std::uint64_t seed = 0;        // of all random numbers
  std::filesystem::path folder;  // of the results
  std::chrono::system_clock::time_point start = std::chrono::system_clock::now();  // of the run
};

// The sidecar of a result, given the bytes of its CSV.
nlohmann::json sidecar(const RunRecord& run, const Result& result, const std::string& csv);

// Writes the CSV, then the sidecar, each atomically. Changes nothing if the CSV already has these bytes and
// its sidecar has the hashes of these bytes and of this driver. Throws std::runtime_error with path and
// reason.
void write_result(const RunRecord& run, const Result& result);

// The version of the sources that made a result.

struct SourceState {
  std::string commit = "unknown";  // full hash
  std::optional<bool> dirty;       // uncommitted changes or new source files? Empty when unknown
};

// The state from IMPINGE_COMMIT and IMPINGE_DIRTY (1, yes or true mean dirty) if IMPINGE_COMMIT is set, else
// from git in the given folder, the root of the repository, else unknown. New files count only below libcore,
// experiments, analysis and paper, unless git ignores them. A missing git or repository is no error.
SourceState source_state(const std::filesystem::path& folder);

// The machine of a measurement, as the operating system describes it. Only reads.

struct Machine {
  std::string cpu = "unknown";       // model name
  unsigned cores = 0;                // logical processors
  std::uint64_t memory_mib = 0;      // physical memory, MiB
  std::string governor = "unknown";  // frequency governor of the first core
  double load = 0.0;                 // average of runnable processes over the last minute
  std::string system = "unknown";    // name and release of the operating system, processor family
};

Machine this_machine();  // as it is now

// SHA-256 of results and programs, with OpenSSL.

// 64 lower-case hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

// The hash of a file's bytes. Throws std::runtime_error if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

// Quoting for the shell.

// The text quoted so that a POSIX shell reads it as one word.
inline std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace impinge::lab
