// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/heap_use.hpp"

#include <limits>

#include <malloc.h>

namespace impinge::lab {

double heap_bytes() {
  const struct mallinfo2 info = ::mallinfo2();
  const double bytes = static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
  return bytes > 0.0 ? bytes : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace impinge::lab
