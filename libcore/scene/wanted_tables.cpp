// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/wanted_tables.hpp"

#include <stdexcept>
#include <string>

#include "files/machine.hpp"
#include "gap/formatted.hpp"

namespace impinge {

void require_memory(const WantedTables& wanted) {
  const auto free = static_cast<double>(available_memory());
  if (wanted.bytes <= free) return;
  throw std::runtime_error(
      formatted("tables of %zu entries at %g degrees would take %s%.0f bytes (%.1f GiB) and %.1f GiB of "
                "memory are free; "
                "choose %s",
                wanted.entries, wanted.precision_deg, std::string(wanted.more).c_str(), wanted.bytes,
                wanted.bytes / 0x1p30, free / 0x1p30, std::string(wanted.cure).c_str()));
}

}  // namespace impinge
