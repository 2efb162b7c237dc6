// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How large is the table of each scheme, and how much memory does filling take? (Tables 2, 6, 7)
// @writes    lut_memory fill_memory
// @timing    no
// @seconds   20 20
// @links     harness table gap thesis_forms
//
// Every table is really made and filled with a surface that has a rim. Its bytes are those of its radii and
// its rim mask; the allocator is asked whether it handed out more. While a table is filled, everything that
// C++ allocates is counted. The thesis fills its helix from a grid, so the grid is counted, too.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>

#include <malloc.h>

#include "harness/driver.hpp"
#include "harness/equator_turn.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/fill_method.hpp"
#include "sphere/scheme.hpp"
#include "sphere/scheme_list.hpp"
#include "table/exact_raster.hpp"

namespace {

// Large blocks of operator new, by the size that was asked for, so that each run counts the same bytes; and
// the largest sum of them since the last reset. None of this allocates memory of its own.
struct Block {
  void* at = nullptr;
  std::size_t bytes = 0;
};
constexpr std::size_t kLarge = 65536;  // bytes: smaller blocks are not counted
std::array<Block, 256> blocks;
std::size_t in_use = 0;
std::size_t peak = 0;

Block* block_at(const void* at) {
  const auto found =
      std::find_if(blocks.begin(), blocks.end(), [at](const Block& one) { return one.at == at; });
  return found == blocks.end() ? nullptr : &*found;
}

void* counted(void* memory, std::size_t bytes) {
  if (memory == nullptr) throw std::bad_alloc();
  if (bytes < kLarge) return memory;
  Block* const free = block_at(nullptr);
  if (free == nullptr) throw std::bad_alloc();
  *free = {memory, bytes};
  in_use += bytes;
  peak = std::max(peak, in_use);
  return memory;
}

void uncounted(void* memory) noexcept {
  if (Block* const known = memory == nullptr ? nullptr : block_at(memory)) {
    in_use -= known->bytes;
    *known = {};
  }
  std::free(memory);  // NOLINT(cppcoreguidelines-no-malloc)
}

}  // namespace

// For the whole program, with one thread.
void* operator new(std::size_t size) { return counted(std::malloc(std::max<std::size_t>(size, 1)), size); }
void* operator new(std::size_t size, std::align_val_t align) {
  const auto to = static_cast<std::size_t>(align);
  return counted(std::aligned_alloc(to, (size + to) / to * to), size);
}
void operator delete(void* block) noexcept { uncounted(block); }
void operator delete(void* block, std::size_t /*size*/) noexcept { uncounted(block); }
void operator delete(void* block, std::align_val_t /*align*/) noexcept { uncounted(block); }
void operator delete(void* block, std::size_t /*size*/, std::align_val_t /*align*/) noexcept {
  uncounted(block);
}

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::array kPrecisions{1.0, 0.5, 0.1, 0.05};  // degrees
constexpr std::size_t kTriangles = 300;                 // of the socket: any rim takes the whole mask
// Bytes that the allocator may add: headers and pages. Radii that ask for large pages begin and end at a
// page; the bytes before and behind them are never touched.
constexpr std::size_t kAllocatorShare = 16384;
constexpr std::size_t kLargePage = std::size_t{1} << 21;

std::size_t allocated_bytes() {
  const auto state = ::mallinfo2();
  return state.uordblks + state.hblkhd;
}

// Bytes of a table's radii and of its rim mask.
struct TableBytes {
  std::size_t radii;
  std::size_t mask;
};

// The bytes of a filled table. It counts a copy, since filling also makes what schemes keep for themselves.
// Throws std::runtime_error if the table holds more memory than radii and mask, or has no mask. Only a scheme
// that does not say where its cells end has none; it leaves out entries beside a rim instead.
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

// The fewest and most entries of a helix's turns at the equator, counted.
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

template <SamplingScheme S>
void add_filling(Table& table, const TriangleMesh& socket, const FillMethod<S>& method) {
  for (const double precision : kPrecisions) {
    const S scheme = S::with_precision(precision);
    const std::size_t before = in_use;
    peak = before;
    const auto filled = method.fill(socket, scheme, Layer::nearest);
    table.add_row({method.name, precision, filled.bytes(), in_use - before, peak - before});
  }
}

// fill_memory.csv: the most memory in use while one table is filled, by the thesis' ways and ours.
Result fill_memory(const TriangleMesh& socket) {
  Result result{"fill_memory",
                "How much memory does filling a table take at its peak?",
                {{{"method", "", "rsid_thesis, usid_thesis: as the thesis; rsid, usid: exact raster"},
                  {"precision_deg", "deg", "spacing of the entries at the equator"},
                  {"bytes", "byte", "radii and rim mask of the table"},
                  {"kept_bytes", "byte", "allocated by C++ when it is filled, in blocks of 64 KiB and more"},
                  {"peak_bytes", "byte", "the most at a time while it was filled"}}}};
  add_filling(result.table, socket, kRsidThesis);
  add_filling(result.table, socket, kUsidThesis);
  add_filling(result.table, socket, kRsid);
  add_filling(result.table, socket, kUsid);
  result.parameters = {{"triangles", kTriangles}, {"filled_with", "generated socket"}};
  return result;
}

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
  run.write(fill_memory(pair.socket));
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"01_memory", "Entries and bytes of the tables (Tables 2, 6 and 7)."}, body);
}
