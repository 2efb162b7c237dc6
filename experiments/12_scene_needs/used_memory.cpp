// SPDX-License-Identifier: GPL-3.0-or-later
#include "12_scene_needs/used_memory.hpp"

#include <array>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

namespace impinge::lab {
namespace {

constexpr double kNotCounted = std::numeric_limits<double>::quiet_NaN();

// Writing 1 forgets which pages were touched, writing 5 the peak.
bool forget(const char* what) {
  std::ofstream file("/proc/self/clear_refs");
  file << what << std::flush;
  return file.good();
}

// A line of /proc/self/status, in bytes.
double status(const std::string& key) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(key + ":")) return 1024.0 * std::strtod(line.c_str() + key.size() + 1, nullptr);
  }
  return kNotCounted;
}

// The first line of a mapping has a range of addresses, and a path if a file is mapped.
double touched_bytes() {
  std::ifstream file("/proc/self/smaps");
  double sum = 0.0;
  bool of_file = false;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string first;
    double kib = 0.0;
    words >> first;
    if (!first.ends_with(':')) of_file = line.find('/') != std::string::npos;
    if (first == "Referenced:" && !of_file && words >> kib) sum += 1024.0 * kib;
  }
  return sum;
}

UsedMemory count(const std::function<void()>& prepare, const std::function<Kept()>& work) {
  prepare();
  work();
  prepare();
  ::malloc_trim(0);
  if (!forget("5") || !forget("1")) return {kNotCounted, kNotCounted};
  const double before = status("VmRSS");
  const double own = touched_bytes();  // memory for counting
  const Kept kept = work();
  const double touched = touched_bytes() - own;
  return {status("VmHWM") - before, touched};
}

}  // namespace

UsedMemory used_memory(const std::function<void()>& prepare, const std::function<Kept()>& work) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe to a process that counts memory");
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process that counts memory");
  UsedMemory used;
  if (child == 0) {
    // Use one heap and never give blocks back, so that freed memory is counted as well.
    ::mallopt(M_ARENA_MAX, 1);
    ::mallopt(M_MMAP_THRESHOLD, std::numeric_limits<int>::max());
    ::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    int code = 1;
    try {
      used = count(prepare, work);
      code = ::write(ends[1], &used, sizeof(used)) == ssize_t{sizeof(used)} ? 0 : 1;
    } catch (const std::exception&) {
    }
    ::_exit(code);
  }
  ::close(ends[1]);
  const bool told = ::read(ends[0], &used, sizeof(used)) == ssize_t{sizeof(used)};
  ::close(ends[0]);
  int code = 0;
  ::waitpid(child, &code, 0);
  if (!told || code != 0) throw std::runtime_error("the process that counts memory ended early");
  return used;
}

}  // namespace impinge::lab
