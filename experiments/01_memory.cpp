// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How large is the table of each scheme at each precision? (Tables 2, 6 and 7)
// @writes    lut_memory
// @timing    no
// @seconds   2 2
// @links     experiment sphere
//
// Every table is really made. Its bytes are those of its radii, and the allocator is asked whether it handed
// out more.

#include <array>

#include <malloc.h>

#include "experiment/driver.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/scheme_list.hpp"
#include "sphere/scheme_precision.hpp"

namespace {

using namespace impinge;

constexpr std::array kPrecisions{1.0, 0.5, 0.1, 0.05};  // degrees
constexpr std::size_t kAllocatorShare = 16384;          // bytes an allocation may add: header and pages

std::size_t allocated_bytes() {
  const auto state = ::mallinfo2();
  return state.uordblks + state.hblkhd;
}

// Bytes of the radii of a table that is really there. Throws std::runtime_error when it holds more memory
// than them.
template <SamplingScheme S>
std::size_t measured_bytes(const S& scheme) {
  const std::size_t before = allocated_bytes();
  const RadialTable<S> table(scheme);
  const std::size_t handed_out = allocated_bytes() - before;
  const std::size_t bytes = table.radii().size_bytes();
  if (handed_out < bytes || handed_out > bytes + kAllocatorShare) {
    throw std::runtime_error(std::string(S::name) + ": a table of " + std::to_string(bytes) +
                             " bytes of radii took " + std::to_string(handed_out) +
                             " bytes from the allocator: count what else it holds");
  }
  return bytes;
}

template <SamplingScheme S>
Cell helix_turns(const S& scheme) {
  if constexpr (requires { scheme.helix_turns(); }) return scheme.helix_turns();
  return {};
}

struct AddRows {
  Table& table;

  template <SamplingScheme S>
  void operator()() const {
    for (const double precision : kPrecisions) {
      const auto scheme = scheme_of_precision<S>(precision);
      if (!scheme) continue;
      const std::size_t bytes = measured_bytes(*scheme);
      table.add_row({S::name, precision, scheme->size(), bytes / scheme->size(), bytes, helix_turns(*scheme),
                     scheme->equator_points()});
    }
  }
};

void body(DriverRun& run) {
  Result result;
  result.name = "lut_memory";
  result.question = "How large is the table of each scheme at each precision?";
  result.table.columns = {{"scheme", "", "name of the sampling scheme"},
                          {"precision_deg", "deg", "spacing of the entries at the equator"},
                          {"entries", "1", "sampled directions"},
                          {"bytes_per_entry", "byte", "bytes of one radius"},
                          {"bytes", "byte", "radii of one table, as allocated"},
                          {"helix_turns", "1", "turns of the helix; empty for a scheme without one"},
                          {"equator_points", "1", "entries on the equator"}};
  result.parameters = {{"precisions_deg", kPrecisions}, {"radius_type", "double"}};
  for_each_scheme(AddRows{result.table});
  run.write(result);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::run_driver(argc, argv,
                             {"01_memory", "Entries and bytes of the tables (Tables 2, 6 and 7)."}, body);
}
