// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/certified_gap.hpp"

namespace impinge {

VerdictCount count_verdicts(std::span<const CertifiedGap> gaps) {
  VerdictCount count;
  for (const CertifiedGap& gap : gaps) count.add(gap.verdict);
  return count;
}

}  // namespace impinge
