// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/machine.hpp"

#include <cstdlib>
#include <fstream>
#include <thread>

#include <sys/utsname.h>

#include "files/memory.hpp"

namespace impinge::lab {
namespace {

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

}  // namespace impinge::lab
