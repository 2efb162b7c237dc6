// SPDX-License-Identifier: GPL-3.0-or-later
// A numbered set of entries of a scheme, for tables that keep only some of their entries.
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace impinge {

/// Memory: 4 bytes for each 4096 entries of the scheme and, if the set has one of them, 1.5 bits for each of
/// the 4096.
class EntrySet {
 public:
  /// An empty set of entries below `size`.
  explicit EntrySet(std::size_t size) : chunk_of_((size + kChunk - 1) / kChunk, kNone) {}

  /// Adds an entry. Only before number().
  void insert(std::size_t entry) {
    assert(entry / kChunk < chunk_of_.size());
    std::uint32_t& chunk = chunk_of_[entry / kChunk];
    if (chunk == kNone) {
      chunk = static_cast<std::uint32_t>(chunks_.size());
      chunks_.emplace_back();
    }
    chunks_[chunk].bits[entry % kChunk / 64] |= std::uint64_t{1} << (entry % 64);
  }

  /// Numbers the entries in ascending order: each gets a slot. To be called once, after the last insert().
  void number() {
    for (const std::uint32_t chunk : chunk_of_) {
      if (chunk == kNone) continue;
      Chunk& part = chunks_[chunk];
      for (std::size_t w = 0; w < part.bits.size(); ++w) {
        part.before[w] = static_cast<std::uint32_t>(count_);
        count_ += static_cast<std::size_t>(std::popcount(part.bits[w]));
      }
    }
    chunks_.shrink_to_fit();
  }

  /// Is this entry in the set?
  bool contains(std::size_t entry) const {
    const std::uint32_t chunk = chunk_of_[entry / kChunk];
    return chunk != kNone && (chunks_[chunk].bits[entry % kChunk / 64] >> (entry % 64) & 1U) != 0U;
  }

  /// The slot of an entry, below count(); std::nullopt if it is not in the set. Only after number().
  std::optional<std::size_t> slot(std::size_t entry) const {
    const std::uint32_t chunk = chunk_of_[entry / kChunk];
    if (chunk == kNone) return std::nullopt;
    const std::size_t word = entry % kChunk / 64;
    const std::uint64_t bits = chunks_[chunk].bits[word];
    const std::uint64_t bit = std::uint64_t{1} << (entry % 64);
    if ((bits & bit) == 0U) return std::nullopt;
    return chunks_[chunk].before[word] + static_cast<std::size_t>(std::popcount(bits & (bit - 1U)));
  }

  /// Calls visit(entry) for each entry of the set, in ascending order.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t c = 0; c < chunk_of_.size(); ++c) {
      if (chunk_of_[c] == kNone) continue;
      const Chunk& part = chunks_[chunk_of_[c]];
      for (std::size_t w = 0; w < part.bits.size(); ++w) {
        for (std::uint64_t bits = part.bits[w]; bits != 0U; bits &= bits - 1U)
          visit(c * kChunk + 64 * w + static_cast<std::size_t>(std::countr_zero(bits)));
      }
    }
  }

  std::size_t count() const { return count_; }  // how many entries; only after number()
  /// Bytes of memory.
  std::size_t bytes() const {
    return chunk_of_.size() * sizeof(std::uint32_t) + chunks_.size() * sizeof(Chunk);
  }

 private:
  static constexpr std::size_t kChunk = 4096;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  struct Chunk {
    std::array<std::uint64_t, kChunk / 64> bits{};
    std::array<std::uint32_t, kChunk / 64> before{};  // entries of the set below this word
  };

  std::vector<std::uint32_t> chunk_of_;
  std::vector<Chunk> chunks_;
  std::size_t count_ = 0;
};

}  // namespace impinge
