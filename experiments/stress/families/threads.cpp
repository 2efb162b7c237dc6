// SPDX-License-Identifier: GPL-3.0-or-later
// Several threads at once. The library starts none of its own; tables that are not written to may be read
// from any number of them, and each thread may fill its own.
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <thread>
#include <vector>

#include "mesh/bodies.hpp"
#include "sphere/uniform_directions.hpp"
#include "stress/family.hpp"
#include "stress/methods.hpp"

namespace impinge::lab {
namespace {

constexpr std::array<std::size_t, 5> kThreads{1, 2, 3, 4, 8};

// Each thread reads its stripe of the directions from one table.
std::vector<double> answers_of_one_table(const PointQuery& table, std::span<const Vec3> directions,
                                         std::size_t threads) {
  std::vector<double> answers(directions.size());
  std::vector<std::jthread> running;
  const std::size_t stripe = (directions.size() + threads - 1) / threads;
  for (std::size_t begin = 0; begin < directions.size(); begin += stripe) {
    const std::size_t count = std::min(stripe, directions.size() - begin);
    running.emplace_back([&table, from = directions.subspan(begin, count),
                          to = std::span(answers).subspan(begin, count)] { table.answer(from, to); });
  }
  running.clear();  // joins them
  return answers;
}

// Each thread builds the method for itself, all at the same time.
std::vector<std::vector<double>> answers_of_own_tables(const PointCase& maker,
                                                       std::span<const Vec3> directions,
                                                       std::size_t threads) {
  std::vector<std::vector<double>> answers(threads, std::vector<double>(directions.size()));
  std::vector<std::jthread> running;
  for (std::size_t k = 0; k < threads; ++k) {
    running.emplace_back([&maker, directions, &own = answers[k]] { maker.make().answer(directions, own); });
  }
  running.clear();
  return answers;
}

std::size_t different(const std::vector<double>& expected, const std::vector<double>& answers) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (std::bit_cast<std::uint64_t>(expected[i]) != std::bit_cast<std::uint64_t>(answers[i])) ++count;
  }
  return count;
}

StabilityCase threaded(const StabilityMethod& method, const std::vector<Vec3>& directions,
                       std::size_t threads) {
  StabilityCase row;
  row.magnitude = static_cast<double>(threads);
  row.method = method.maker.name;
  row.kind = method.maker.kind;
  row.scalar = method.scalar;
  row.threshold = 0.0;
  row.refused = method.refused;
  if (!row.refused.empty()) return row;
  const PointQuery alone = method.maker.make();
  std::vector<double> expected(directions.size());
  alone.answer(directions, expected);
  for (const std::vector<double>& own : answers_of_own_tables(method.maker, directions, threads)) {
    row.questions += own.size();
    row.wrong += different(expected, own);
  }
  if (!method.maker.scheme.empty()) {  // of a table answer() reads alone
    row.questions += expected.size();
    row.wrong += different(expected, answers_of_one_table(alone, directions, threads));
  }
  row.condition = 1.0;
  row.relative_error = 0.0;
  row.error_over_condition_u = static_cast<double>(row.wrong);
  return row;
}

std::vector<StabilityCase> run_threads(const StabilityRun& options) {
  StabilityScene scene;
  scene.mesh = sphere(22.0, 80, Vec3(3.0, 2.0, -1.0));
  scene.directions = uniform_directions(options.quick ? 1000 : 20000, 41);
  std::vector<StabilityCase> rows;
  for (const StabilityMethod& method : stability_methods(scene, {})) {
    for (const std::size_t threads : kThreads) rows.push_back(threaded(method, scene.directions, threads));
  }
  return rows;
}

}  // namespace

StabilityFamily threads_family() {
  StabilityFamily family;
  family.name = "threads";
  family.parameter = "threads that fill tables of their own and read a common one";
  family.unit = "1";
  family.expected =
      "the library is serial: it starts no thread and keeps no state that threads share, so that tables "
      "filled at the "
      "same time and tables read at the same time give the same bits as one thread does";
  family.threshold = 0.0;
  family.derivation = "no rounding depends on a thread";
  family.run = run_threads;
  return family;
}

}  // namespace impinge::lab
