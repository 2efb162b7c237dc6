// SPDX-License-Identifier: GPL-3.0-or-later
// Reads numbers of every type from the bytes of binary mesh files.
#pragma once

#include <cstddef>
#include <string_view>

namespace impinge {

/// A type of numbers in a file.
struct NumberType {
  std::size_t size = 0;    // bytes: 1, 2, 4 or 8
  bool floating = false;   // a float or double
  bool is_signed = false;  // for integers
};

/// The number in the first type.size bytes. A whole number beyond 2^53 is rounded.
double number_at(std::string_view bytes, NumberType type, bool big_endian);

}  // namespace impinge
