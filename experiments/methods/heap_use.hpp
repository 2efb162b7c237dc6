// SPDX-License-Identifier: GPL-3.0-or-later
// How much heap a library's tree takes, where the library does not say.
#pragma once

namespace impinge::lab {

// Bytes now allocated by the C library, its own headers included; take the difference before and after
// building. NaN if they are not counted (another allocator, such as a sanitizer's).
double heap_bytes();

}  // namespace impinge::lab
