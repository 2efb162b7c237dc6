// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How large is the table of each scheme at each precision? (Tables 2, 6 and 7)
// @writes    lut_memory
// @timing    no
// @seconds   10 10
// @links     harness table
//
// Every table is really made and filled with a surface that has a rim. Its bytes are those of its radii, and
// those of its rim mask beside them; the allocator is asked whether it handed out more.

#include <array>

#include <malloc.h>

#include "harness/driver.hpp"
#include "harness/equator_turn.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/scheme.hpp"
#include "sphere/scheme_list.hpp"
#include "table/exact_raster.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::array kPrecisions{1.0, 0.5, 0.1, 0.05};  // degrees
constexpr std::size_t kTriangles = 300;                 // of the socket: any rim takes the whole mask
// Bytes that the allocator may add: headers and pages. Radii that ask for large pages begin at one and end
// at one: what lies before and behind is never touched.
constexpr std::size_t kAllocatorShare = 16384;
constexpr std::size_t kLargePage = std::size_t{1} << 21;

std::size_t allocated_bytes() {
  const auto state = ::mallinfo2();
  return state.uordblks + state.hblkhd;
}

// Bytes of the radii of a table, and of its rim mask.
struct TableBytes {
  std::size_t radii;
  std::size_t mask;
};

// Of a filled table that is really there: of its copy, since filling also makes what schemes keep for
// themselves. Throws std::runtime_error when it holds more memory than radii and mask, or has no mask: only
// where a scheme does not say where its cells end, entries beside a rim are left out instead.
template <SamplingScheme S>
TableBytes measured_bytes(const TriangleMesh& socket, const S& scheme) {
  const RadialTable<S> filled = fill_exact(socket, scheme, Layer::nearest);
  const std::size_t before = allocated_bytes();
  const RadialTable<S> table = filled;  // NOLINT(performance-unnecessary-copy-initialization)
  const std::size_t handed_out = allocated_bytes() - before;
  const TableBytes bytes{table.radii().size_bytes(), table.rim_cells().bytes()};
  const std::size_t all = bytes.radii + bytes.mask;
  const std::size_t more = kAllocatorShare + (bytes.radii < kLargePage ? 0 : 2 * kLargePage);
  if ((bytes.mask == 0 && HasKnownBorders<S>) || handed_out < all || handed_out > all + more) {
    throw std::runtime_error(std::string(S::name) + ": a table of " + std::to_string(bytes.radii) +
                             " bytes of radii and " + std::to_string(bytes.mask) + " of rim mask took " +
                             std::to_string(handed_out) +
                             " bytes from the allocator: count what else it holds");
  }
  return bytes;
}

template <SamplingScheme S>
Cell helix_turns(const S& scheme) {
  if constexpr (requires { scheme.helix_turns(); }) return scheme.helix_turns();
  return {};
}

// Entries of the turns of a helix at the equator, counted: fewest and most.
template <SamplingScheme S>
std::array<Cell, 2> counted_at_equator(const S& scheme) {
  if constexpr (requires { scheme.helix_turns(); }) {
    const EquatorTurn turn = equator_turn(scheme);
    return {turn.least, turn.most};
  }
  return {};
}

struct AddRows {
  Table& table;
  const TriangleMesh& socket;

  template <SamplingScheme S>
  void operator()() const {
    for (const double precision : kPrecisions) {
      const auto scheme = scheme_of_precision<S>(precision);
      if (!scheme) continue;
      const auto [radii, mask] = measured_bytes(socket, *scheme);
      const auto [least, most] = counted_at_equator(*scheme);
      table.add_row({S::name, precision, scheme->size(), radii / scheme->size(), radii, helix_turns(*scheme),
                     scheme->equator_points(), radii + mask, least, most});
    }
  }
};

void body(DriverRun& run) {
  Result result{"lut_memory",
                "How large is the table of each scheme at each precision?",
                {{{"scheme", "", "name of the sampling scheme"},
                  {"precision_deg", "deg", "spacing of the entries at the equator"},
                  {"entries", "1", "sampled directions"},
                  {"bytes_per_entry", "byte", "bytes of one radius"},
                  {"bytes", "byte", "radii of one table, as allocated"},
                  {"helix_turns", "1", "turns of the helix; empty for a scheme without one"},
                  {"equator_points", "1", "entries on the equator, by the scheme's own formula"},
                  {"filled_bytes", "byte", "radii and rim mask of the table of a surface with a rim"},
                  {"equator_least", "1",
                   "counted: fewest entries of a turn of the helix that crosses the equator, which "
                   "depend on where the turn begins; empty for a scheme without turns"},
                  {"equator_most", "1", "counted: most entries of such a turn"}}}};
  result.parameters = {{"precisions_deg", kPrecisions},
                       {"radius_type", "double"},
                       {"filled_with", "generated socket"},
                       {"triangles", kTriangles}};
  const BallSocketPair pair = make_ball_socket_pair(kTriangles);
  for_each_scheme(AddRows{result.table, pair.socket});
  run.write(result);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"01_memory", "Entries and bytes of the tables (Tables 2, 6 and 7)."}, body);
}
