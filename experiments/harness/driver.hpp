// SPDX-License-Identifier: GPL-3.0-or-later
// What all numbered drivers share: options, checks before the work, one clear line on failure.
//
//   NAME [--out DIR] [--profile quick|full] [--seed N] [--bones DIR]
//
// Exit code 0 on success, 1 when the work fails, 2 for a wrong option. An error is one line on stderr,
// "NAME: error: what is wrong: what to do".
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "harness/progress.hpp"
#include "harness/provenance.hpp"

namespace impinge::lab {

// What a driver is, for its options and messages.
struct DriverInfo {
  std::string name;          // of the program
  std::string purpose;       // one sentence for --help
  bool takes_bones = false;  // has it the option --bones?
};

// What run_driver() passes to the body of a driver.
struct DriverRun {
  RunRecord record;                            // for the sidecars of the results
  std::optional<std::filesystem::path> bones;  // folder with one folder a subject
  Progress progress;                           // reports how far the work is

  bool quick() const { return record.profile == "quick"; }  // is it the quick profile?
  // Writes the result and says where.
  void write(const Result& result);
};

// Parses, checks that the output folder can be written, runs the body. The returned value is the exit code.
int run_driver(int argc, const char* const* argv, const DriverInfo& info,
               const std::function<void(DriverRun&)>& body);

}  // namespace impinge::lab
