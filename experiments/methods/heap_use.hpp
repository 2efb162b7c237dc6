// SPDX-License-Identifier: GPL-3.0-or-later
// How much heap a library's tree takes, if the library does not say.
#pragma once

namespace impinge::lab {

// Bytes that the C library has allocated, with its own headers; take the difference before and after
// building. NaN if they are not counted, because another allocator is used (such as a sanitizer's).
double heap_bytes();

}  // namespace impinge::lab
