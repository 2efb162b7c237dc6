// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/table_size.hpp"

#include <cstdio>
#include <stdexcept>
#include <string>

namespace impinge {

std::size_t require_table_size(std::string_view scheme, std::size_t entries) {
  if (entries <= kMostTableEntries) return entries;
  const double bytes = 8.0 * static_cast<double>(entries);
  char text[240];
  std::snprintf(
      text, sizeof text,
      "a table of %zu entries would take %.3g bytes (%.3g TiB), and a table has at most %zu entries: "
      "choose a coarser precision for ",
      entries, bytes, bytes / 0x1p40, kMostTableEntries);
  throw std::invalid_argument(text + std::string(scheme));
}

}  // namespace impinge
