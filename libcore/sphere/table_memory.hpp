// SPDX-License-Identifier: GPL-3.0-or-later
// A std::vector for large tables, whose memory has large pages if the system has them.
#pragma once

#include <cstddef>
#include <vector>

namespace impinge {

/// Allocates memory, from 2 MiB on in pages of 2 MiB if Linux gives them: the fault for each page of 4 KiB
/// takes as long as filling it.
void* allocate_table(std::size_t bytes);
void free_table(void* memory, std::size_t bytes) noexcept;  // gives it back; `bytes` as it was asked for

/// The allocator of such a vector, as the standard library asks for one.
template <class T>
struct LargePages {
  using value_type = T;  // of the elements

  LargePages() = default;
  /// All allocators are alike.
  template <class U>
  explicit LargePages(const LargePages<U>& /*other*/) {}

  /// Memory of so many elements.
  T* allocate(std::size_t count) { return static_cast<T*>(allocate_table(count * sizeof(T))); }
  /// Gives it back.
  void deallocate(T* memory, std::size_t count) noexcept { free_table(memory, count * sizeof(T)); }

  friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

/// A vector in such memory.
template <class T>
using TableMemory = std::vector<T, LargePages<T>>;

}  // namespace impinge
