// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/driver.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string_view>

#include <CLI/CLI.hpp>

#include "files/file_bytes.hpp"

namespace impinge::lab {
namespace {

struct Options {
  std::string out = "results/data";
  std::string profile = "full";
  std::string bones;
  std::uint64_t seed = 1;
};

void declare(CLI::App& app, Options& options, const DriverInfo& info) {
  app.add_option("--out", options.out, "folder for the results")->capture_default_str();
  app.add_option("--profile", options.profile, "quick extrapolates what takes minutes, full measures it")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "seed of every random number")
      ->check(CLI::NonNegativeNumber)  // CLI11 lets -1 wrap round otherwise
      ->capture_default_str();
  if (info.takes_bones) {
    app.add_option("--bones", options.bones, "folder with real meshes, one folder a subject")
        ->check(CLI::ExistingDirectory);
  }
}

// The command line without the program's folder. An absolute folder of joints is private: it becomes BONES.
std::string command_text(int argc, const char* const* argv, const std::string& name) {
  std::string text = name;
  std::string_view before;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const bool place = before == "--bones" && std::filesystem::path(word).is_absolute();
    text.append(" ").append(place ? "BONES" : word);
    before = word;
  }
  return text;
}

int report(const std::string& name, const std::string& message, int code) {
  std::cerr << name << ": error: " << message << std::endl;
  return code;
}

constexpr std::chrono::seconds kPause{5};  // between two lines

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void DriverRun::write(const Result& result) {
  write_result(record, result);
  progress.say("wrote " + (record.folder / (result.name + ".csv")).string());
}

int run_driver(int argc, const char* const* argv, const DriverInfo& info,
               const std::function<void(DriverRun&)>& body) {
  CLI::App app{info.purpose, info.name};
  Options options;
  declare(app, options, info);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return report(info.name, std::string(error.what()) + ": see " + info.name + " --help", 2);
  }
  try {
    require_writable_folder(options.out);
  } catch (const std::exception& error) {
    return report(info.name, std::string(error.what()) + ": choose another folder with --out", 2);
  }
  try {
    DriverRun run{
        {info.name, command_text(argc, argv, info.name), options.profile, options.seed, options.out},
        std::nullopt,
        Progress(info.name, &std::cerr)};
    if (!options.bones.empty()) run.bones = options.bones;
    body(run);
  } catch (const std::exception& error) {
    return report(info.name, error.what(), 1);
  }
  return 0;
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(std::max(0.0, seconds)));
  if (whole < 60) return std::to_string(whole) + " s";
  const std::string rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + " min " + (rest.size() < 2 ? "0" : "") + rest + " s";
}

void Progress::say(std::string_view text) {
  if (out_ != nullptr) *out_ << name_ << ": " << text << std::endl;
}

void Progress::begin(double expected_s) {
  expected_ = expected_s;
  done_ = 0.0;
  start_ = Clock::now();
}

void Progress::advance(double expected_s, std::string_view what) {
  done_ = std::min(done_ + expected_s, expected_);
  if (Clock::now() - printed_ < kPause) return;
  printed_ = Clock::now();
  const double share = expected_ > 0.0 ? 100.0 * done_ / expected_ : 100.0;
  say(std::to_string(std::lround(share)) + " %, about " + duration_text(seconds_left()) + " left (" +
      std::string(what) + ")");
}

double Progress::seconds_left() const {
  const double left = expected_ - done_;
  return done_ > 0.0 ? left * seconds_since(start_) / done_ : left;
}

}  // namespace impinge::lab
