// SPDX-License-Identifier: GPL-3.0-or-later
// Do the tables that a scene asks for fit in memory?
#pragma once

#include <cstddef>
#include <string_view>

namespace impinge {

/// Tables of both surfaces. Bytes in floating point, since entries by the 10^18 are asked for at times.
struct WantedTables {
  std::size_t entries = 0;     // of each table
  double precision_deg = 0.0;  // of both
  double bytes = 0.0;          // of both
  std::string_view more = "";  // "more than " where they take that at least
  std::string_view cure;       // what to choose instead
};

/// std::runtime_error, one line with the bytes and the cure, if there is less memory.
void require_memory(const WantedTables& wanted);

}  // namespace impinge
