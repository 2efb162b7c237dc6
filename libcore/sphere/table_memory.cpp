// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/table_memory.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace impinge {
namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21;

}  // namespace

void* allocate_table(std::size_t bytes) {
  if (bytes < kLargePage) return ::operator new(bytes);
  void* const memory = ::operator new (bytes, std::align_val_t{kLargePage});
#ifdef __linux__
  static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));  // advice: nothing is lost where it is not taken
#endif
  return memory;
}

void free_table(void* memory, std::size_t bytes) noexcept {
  if (bytes < kLargePage) {
    ::operator delete(memory);
  } else {
    ::operator delete (memory, std::align_val_t{kLargePage});
  }
}

}  // namespace impinge
