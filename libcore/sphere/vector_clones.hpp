// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Put before a function, this compiles it for AVX2 too, where compiler and system can; which version runs is
// chosen when the program starts. Without contraction to fused multiply-add both give the same bits.
// Sanitizers fail on functions that run before them.
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define IMPINGE_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define IMPINGE_VECTOR_CLONES
#endif
