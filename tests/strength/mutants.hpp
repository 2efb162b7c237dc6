// SPDX-License-Identifier: GPL-3.0-or-later
// Included before every source of the copy that make_mutants.py writes. IMPINGE_MUTANT in the environment is
// the number of the mutant that acts, none without it; IMPINGE_REACHED is a file to which the numbers of all
// mutants are appended whose place was run. Containers and matrices check their indices: the gate runs these
// tests under sanitizers, which would notice a mutant that reads beyond an end.
#pragma once

#define _GLIBCXX_ASSERTIONS
#define eigen_assert(true_here) ((true_here) ? void() : std::abort())

#include <bitset>
#include <cstdio>
#include <cstdlib>
#include <type_traits>

namespace mutants {

inline constexpr int kMost = 20000;

struct Reached {
  std::bitset<kMost> places;
  ~Reached() {
    const char* path = std::getenv("IMPINGE_REACHED");
    std::FILE* file = path ? std::fopen(path, "a") : nullptr;
    if (!file) return;
    for (int place = 0; place < kMost; ++place) {
      if (places[place]) std::fprintf(file, "%d\n", place);
    }
    std::fclose(file);
  }
};
inline Reached reached;
inline const int active = std::getenv("IMPINGE_MUTANT") ? std::atoi(std::getenv("IMPINGE_MUTANT")) : -1;

/// Does mutant `number` act?
constexpr bool on(int number) {
  if (std::is_constant_evaluated()) return false;
  reached.places[number] = true;
  return active == number;
}

}  // namespace mutants
