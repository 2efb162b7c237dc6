// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/memory.hpp"

#include <fstream>
#include <string>

#include <unistd.h>

namespace impinge {

std::uint64_t physical_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long page_bytes = ::sysconf(_SC_PAGE_SIZE);
  if (pages <= 0 || page_bytes <= 0) return 0;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_bytes);
}

std::uint64_t available_memory() {
#ifdef __EMSCRIPTEN__  // a web page has no files to read it from
  return std::uint64_t{1} << 30U;
#else
  std::ifstream file("/proc/meminfo");
  std::uint64_t kib = 0;
  for (std::string name; file >> name;) {
    if (name == "MemAvailable:" && file >> kib) return kib << 10U;
    std::getline(file, name);
  }
  return physical_memory();
#endif
}

}  // namespace impinge
