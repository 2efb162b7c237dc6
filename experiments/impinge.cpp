// SPDX-License-Identifier: GPL-3.0-or-later
// The program `impinge`: the commands of libcore/command, and `impinge cohort`, which works out a study of
// many hips, drawn from a population or read from a folder of real joints, in shards on any computers:
//
//   impinge cohort --study FILE [--hips N] --shard i/K --out DIR     works out part i of K, or continues it
//   impinge cohort --merge DIR                                       cohort.csv, cohort.json, shards.json

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include "cohort/shard.hpp"
#include "command/program.hpp"
#include "files/file_bytes.hpp"

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

void run(const Options& options, const ShardName& shard, const Screen& screen) {
  if (!options.merge.empty()) {
    const Merged merged = merge(options.merge);
    screen.out << "wrote " << options.merge << "/{cohort.csv,cohort.json,shards.json}: " << merged.hips
               << " hips in " << merged.shards << (merged.shards == 1 ? " shard" : " shards") << std::endl;
    return;
  }
  const Study study = read_study(options.study, options.hips);
  require_writable_folder(options.out);
  const ShardRun done = run_shard(study, shard, options.out);
  for (const std::string& line : done.warnings) screen.log << "impinge: warning: " << line << std::endl;
  screen.out << "wrote " << shard_file(options.out, shard).string() << ": hips " << done.hips.first << " to "
             << done.hips.last << " (exclusive), " << done.kept << " of them kept from an earlier run, "
             << done.seconds << " s of one core" << std::endl;
}

void add_cohort(CLI::App& program, const Screen& screen, std::function<void()>& work) {
  const auto options = std::make_shared<Options>();
  CLI::App& app = *program.add_subcommand(
      "cohort", "Limits, shape and zones of small gaps of many hips, in shards (parts).");
  app.footer("Example: impinge cohort --study study.json --shard 1/12 --out hips");
  declare(app, *options);
  app.parse_complete_callback([options, &screen, &work] {
    work = [options, &screen] {
      if (options->study.empty() && options->merge.empty())
        throw std::invalid_argument("nothing to do: give --study and --out, or --merge");
      ShardName shard;
      try {
        shard = parse_shard(options->shard);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("--shard: " + std::string(error.what()));
      }
      run(*options, shard, screen);
    };
  });
}

// Freed when memory runs out, so that unfinished work can be undone and reported.
std::atomic<char*> reserve;

void give_back() {
  const char* const given = reserve.exchange(nullptr);
  if (given == nullptr) throw std::bad_alloc();
  delete[] given;
}

// Linux lends more memory than there is and kills, without a word, who uses it. With this limit the request
// that goes too far fails instead. A sanitizer has reserved far more by now, and gets no limit.
void ask_for_no_more_than_there_is() {
  struct sysinfo machine {};
  struct rlimit given {};
  if (::sysinfo(&machine) != 0 || ::getrlimit(RLIMIT_DATA, &given) != 0) return;
  const rlim_t sixteenth = (machine.totalram + machine.totalswap) / 16 * machine.mem_unit;
  const struct rlimit limit { std::min(given.rlim_cur, 15 * sixteenth), given.rlim_max };
  ::setrlimit(RLIMIT_DATA, &limit);
  constexpr std::size_t kPage = 4096;
  void* const page = ::mmap(nullptr, kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED)
    ::setrlimit(RLIMIT_DATA, &given);
  else
    ::munmap(page, kPage);
}

// Some destructors of libraries allocate, and abort the program if they cannot.
[[noreturn]] void end() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc&) {
    std::cerr << "impinge: error: " << kNoMemory << std::endl;
    std::_Exit(1);
  } catch (...) {
    std::abort();
  }
  std::abort();
}

// Without this, a file opened in the place of a closed stream would receive what is printed.
void open_streams() {
  for (int stream = 0; stream < 3; ++stream)
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == 0 ? O_RDONLY : O_WRONLY);
}

}  // namespace

int main(int argc, char** argv) {
  open_streams();
  reserve = new char[std::size_t{1} << 20U];
  std::set_new_handler(give_back);
  std::set_terminate(end);
  ask_for_no_more_than_there_is();
  return run_program(argc, argv, std::cout, std::cerr, std::array<AddCommand, 1>{add_cohort});
}
