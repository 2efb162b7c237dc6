// SPDX-License-Identifier: GPL-3.0-or-later
// Many hips: a study of how parameters spread over a population, or a folder of real joints, in shards that
// any engine may run, and their results together.
//
//   cohort --study FILE [--hips N] --shard i/K --out DIR     works out one part of K, or goes on where it was
//   cohort --merge DIR                                       cohort.csv, cohort.json and shards.json
//
// Exit code 0 on success, 1 when a shard cannot be worked out or merged, 2 for a wrong option. An error is
// one line on stderr.

#include <exception>
#include <iostream>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cohort/merge.hpp"
#include "cohort/shard.hpp"
#include "files/file_bytes.hpp"
#include "files/one_line.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

struct Options {
  std::string study;
  std::optional<std::size_t> hips;
  std::string shard = "1/1";
  std::string out;
  std::string merge;
};

int fail(const std::string& what, int code) {
  std::cerr << "cohort: error: " << one_line(what) << std::endl;
  return code;
}

void declare(CLI::App& app, Options& options) {
  CLI::Option* study =
      app.add_option("--study", options.study, "JSON file; experiments/cohort.md has its keys");
  app.add_option("--hips", options.hips, "number of hips, in place of the study's")
      ->needs(study)
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000000}));
  app.add_option("--shard", options.shard, "i/K: part i of K, i from 1 to K")
      ->capture_default_str()
      ->needs(study);
  CLI::Option* out = app.add_option("--out", options.out, "folder for the shards and the merged results");
  study->needs(out);
  out->needs(study);
  app.add_option("--merge", options.merge, "folder of finished shards")->excludes(study)->excludes(out);
}

void run(const Options& options, const ShardName& shard) {
  if (!options.merge.empty()) {
    const Merged merged = merge(options.merge);
    std::cout << "wrote " << options.merge << "/{cohort.csv,cohort.json,shards.json}: " << merged.hips
              << " hips in " << merged.shards << (merged.shards == 1 ? " shard" : " shards") << std::endl;
    return;
  }
  const Study study = read_study(options.study, options.hips);
  require_writable_folder(options.out);
  const ShardRun done = run_shard(study, shard, options.out);
  std::cout << "wrote " << shard_file(options.out, shard).string() << ": hips " << done.hips.first << " to "
            << done.hips.last << " (exclusive), " << done.kept << " of them kept from an earlier run, "
            << done.seconds << " s of one core" << std::endl;
}

// The exit code.
int start(int argc, char** argv) {
  Options options;
  ShardName shard;
  CLI::App app{"Limits, shape and zones of small gaps of many hips, in shards (parts).", "cohort"};
  declare(app, options);
  try {
    app.parse(argc, argv);
    if (options.study.empty() && options.merge.empty())
      return fail("nothing to do: give --study and --out, or --merge; see cohort --help", 2);
    shard = parse_shard(options.shard);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(std::string(error.what()) + "; see cohort --help", 2);
  } catch (const std::invalid_argument& error) {
    return fail("option --shard: " + std::string(error.what()), 2);
  }
  run(options, shard);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return start(argc, argv);
  } catch (const std::exception& error) {
    return fail(error.what(), 1);
  }
}
