// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Before a function: where compiler and system can, it is compiled for AVX2 too and the processor decides
// when the program starts. Without contraction to fused multiply-add the bits of its results are the same.
// Sanitizers do not stand functions that run before them.
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define IMPINGE_VECTOR_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define IMPINGE_VECTOR_CLONES
#endif
