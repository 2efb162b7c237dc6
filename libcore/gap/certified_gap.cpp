// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap/certified_gap.hpp"

namespace impinge {

VerdictCount count_verdicts(std::span<const CertifiedGap> gaps) {
  VerdictCount count;
  for (const CertifiedGap& gap : gaps) {
    count.clear += gap.verdict == Verdict::clear ? 1U : 0U;
    count.impinged += gap.verdict == Verdict::impinged ? 1U : 0U;
    count.undecided += gap.verdict == Verdict::undecided ? 1U : 0U;
  }
  return count;
}

}  // namespace impinge
