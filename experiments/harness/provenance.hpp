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
#include <string>

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

}  // namespace impinge::lab
