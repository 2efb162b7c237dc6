// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "12_scene_needs/needs_study.hpp"
#include "motion/cell_test.hpp"

namespace impinge::lab {
namespace {

constexpr std::uint32_t kLevel = 4;
constexpr std::uint64_t kCells = std::uint64_t{4} << (3 * kLevel);  // of that level

struct DecidedCells {
  std::vector<CellState> state = std::vector<CellState>(kCells);  // of each cell of the level
  std::size_t asked = 0;
};

DecidedCells every_cell(const CellTest& test) {
  DecidedCells found;
  CellSearch search(test);
  for (std::uint64_t k = 0; k < kCells; ++k) found.state[k] = search.decide(RotationCell{kLevel, k}).state;
  found.asked = kCells;
  return found;
}

// Splits open cells alone, and looks first where their parents may be stopped.
void decide_below(CellSearch& search, const RotationCell& cell, const CellHint& hint, DecidedCells& found) {
  const CellVerdict verdict = search.decide(cell, hint);
  ++found.asked;
  if (verdict.state == CellState::open && cell.level < kLevel) {
    for (std::uint64_t k = 0; k < 8; ++k) decide_below(search, child(cell, k), verdict.hint, found);
    return;
  }
  const std::uint64_t inside = std::uint64_t{1} << (3 * (kLevel - cell.level));
  for (std::uint64_t k = 0; k < inside; ++k) found.state[cell.number * inside + k] = verdict.state;
}

DecidedCells open_cells_alone(const CellTest& test) {
  DecidedCells found;
  CellSearch search(test);
  for (std::uint64_t cube = 0; cube < 4; ++cube) decide_below(search, {0, cube}, {}, found);
  return found;
}

// Is no cell free in one of them and blocked in the other?
bool agree(const DecidedCells& a, const DecidedCells& b) {
  for (std::uint64_t k = 0; k < kCells; ++k) {
    const bool both = a.state[k] != CellState::open && b.state[k] != CellState::open;
    if (both && a.state[k] != b.state[k]) return false;
  }
  return true;
}

}  // namespace

std::vector<NeedsCase> motion_volume_of(const std::string& name, const BallSocketPair& joint) {
  const auto test = std::make_shared<const CellTest>(joint);
  const auto made = [&](const char* left_out, DecidedCells (*decide)(const CellTest&)) {
    NeedsCase one;
    one.scene = name + " motion volume";
    one.left_out = left_out;
    one.run = [=] { benchmark::DoNotOptimize(decide(*test).asked); };
    const DecidedCells found = decide(*test);
    one.bytes = static_cast<double>(found.asked * sizeof(CellVerdict));
    return std::pair(one, found);
  };
  auto [everything, all] = made("nothing", every_cell);
  auto [plan, some] = made("all", open_cells_alone);
  plan.identical = agree(all, some);
  return {everything, plan};
}

}  // namespace impinge::lab
