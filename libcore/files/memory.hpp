// SPDX-License-Identifier: GPL-3.0-or-later
// The memory of the machine, as the operating system reports it.
#pragma once

#include <cstdint>

namespace impinge {

std::uint64_t physical_memory();  // bytes

/// Bytes that a program may still take before the machine swaps (MemAvailable of Linux); the physical memory
/// where that is not known.
std::uint64_t available_memory();

}  // namespace impinge
