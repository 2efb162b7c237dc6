// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/instruction_set.hpp"

#include <cstdint>
#include <stdexcept>

#include <hwy/highway.h>

namespace impinge {
namespace {

// One bit per instruction set, the lowest for the best. The set that needs nothing is always there.
constexpr std::int64_t kCompiled = HWY_TARGETS;
std::int64_t usable() { return (hwy::SupportedTargets() & kCompiled) | HWY_STATIC_TARGET; }

}  // namespace

std::vector<std::string> instruction_sets() {
  std::vector<std::string> names;
  for (std::int64_t rest = usable(); rest != 0; rest &= rest - 1)
    names.emplace_back(hwy::TargetName(rest & -rest));
  return names;
}

void use_instruction_set(std::string_view name) {
  for (std::int64_t rest = usable(); rest != 0; rest &= rest - 1) {
    if (hwy::TargetName(rest & -rest) != name) continue;
    hwy::GetChosenTarget().Update(rest & -rest);
    return;
  }
  std::string known;
  for (const std::string& set : instruction_sets()) known += " " + set;
  throw std::invalid_argument("instruction set \"" + std::string(name) + "\" is not here: use one of" +
                              known);
}

void use_best_instruction_set() { hwy::GetChosenTarget().Update(usable()); }

}  // namespace impinge
