// SPDX-License-Identifier: GPL-3.0-or-later
// How much heap a library's tree takes, where the library does not say.
#pragma once

namespace impinge::lab {

// Bytes that the C library has handed out and not taken back, its own headers included. NaN where it does not
// count them (another allocator, such as that of a sanitizer). Take the difference before and after building.
double heap_bytes();

}  // namespace impinge::lab
