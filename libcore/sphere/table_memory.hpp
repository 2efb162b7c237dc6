// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of a large table: a std::vector whose new elements are left as they are instead of set to zero, so
// that the first to touch a page is the thread that fills it, and whose pages are large where the system has
// such. Reading an element before it is written is undefined.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace impinge {

/// From 2 MiB on in pages of 2 MiB, if Linux will: a fault for each page of 4 KiB takes as long as filling
/// it.
void* allocate_table(std::size_t bytes);
void free_table(void* memory, std::size_t bytes) noexcept;  // gives it back; `bytes` as it was asked for

/// The allocator of such a vector, as the standard library asks for one.
template <class T>
struct LeftUnset {
  using value_type = T;  // of the elements

  LeftUnset() = default;
  /// All are alike.
  template <class U>
  explicit LeftUnset(const LeftUnset<U>& /*other*/) {}

  /// Memory of so many elements.
  T* allocate(std::size_t count) { return static_cast<T*>(allocate_table(count * sizeof(T))); }
  /// Gives it back.
  void deallocate(T* memory, std::size_t count) noexcept { free_table(memory, count * sizeof(T)); }

  /// Begins an element without a value.
  template <class U>
  void construct(U* place) noexcept {
    static_assert(std::is_trivially_default_constructible_v<U>);
    ::new (static_cast<void*>(place)) U;
  }
  /// Begins an element with a value.
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const LeftUnset&, const LeftUnset&) { return true; }
};

/// A vector in such memory.
template <class T>
using TableMemory = std::vector<T, LeftUnset<T>>;

}  // namespace impinge
