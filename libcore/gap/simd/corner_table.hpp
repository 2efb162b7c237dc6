// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A cube map whose cells have their four corners side by side: one load of 64 bits reads them, and whether
/// there is an answer, where the rows of table/packed_table.hpp take two loads and one of the mask. For
/// that every number is kept twice, in 15 bits.
///
/// Entry (i, j) of `cube_gnomonic` has one word, in the order of the entries: its code in bits 0 to 14, the
/// code of the entry in the next row of the face in bits 16 to 30, and in bit 15 whether the cell that begins
/// at it has no answer. A cell is then the word that it begins at and the one after that. Entry codes stand
/// for smallest + step * code, off by at most
///   step / 2 + u smallest                                              u = 2^-24
/// from the number that was stored, half of the 32767th part of what the answering cells take.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "gap/simd/gap_kernels.hpp"

namespace impinge {

/// Plain data; make it with corner_table().
struct CornerTable {
  using Real = float;                                 // that a kernel works in
  static constexpr std::uint32_t kMostCode = 0x7FFF;  // the largest code, and its bits in a word
  static constexpr std::uint32_t kNone = 0x8000;      // in a word: no answer in the cell that begins there

  std::size_t divisions = 0;         // cells along a side of the cube
  TableMemory<std::uint32_t> words;  // of the entries
  float smallest = 0.0F;             // 1 / mm
  float step = 0.0F;                 // 1 / mm

  std::size_t bytes() const { return words.size() * sizeof(std::uint32_t); }  // of the words
};

/// The same entries and the same cells without an answer. One pass over the table.
CornerTable corner_table(const PackedTable<CubeGnomonic, float>& table);

/// A scan as in gap/simd/gap_kernels.hpp. At the moved vertex x the gap is off from that of the table in
/// exact arithmetic by at most
///   u (20 (r + |x|) + 5 Q r + 13 m D) + 2^-15 D,   D = r (C - 1)
/// in the letters used there: the share of a cell along its column is rounded to 14 bits, with which the sum
/// of two codes is exact; along a whole cell r changes by D at most.
void scan_gaps(const CornerTable& table, const PackedVertices<float>& vertices, const Pose& pose,
               Surface scanned, std::span<float> gap);

}  // namespace impinge
