// SPDX-License-Identifier: GPL-3.0-or-later
// The memory of the machine, as the operating system reports it.
#pragma once

#include <cstdint>

namespace impinge {

std::uint64_t physical_memory();  // bytes

/// How many bytes a program may still take before the machine swaps (MemAvailable of Linux). Where that is
/// not known, the physical memory.
std::uint64_t available_memory();

}  // namespace impinge
