// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Which vector instructions the kernels use: the best of the processor, unless a test or an experiment asks
/// for less. The answers are the same, bit for bit, with all of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace impinge {

/// The sets that this processor has and for which the kernels were compiled, best first, by Highway's names,
/// such as AVX3, AVX2, SSE4 and, without any, SCALAR or EMU128.
std::vector<std::string> instruction_sets();

/// Makes the kernels use a set from now on, in all threads. Throws std::invalid_argument for a name that
/// instruction_sets() does not have.
void use_instruction_set(std::string_view name);
void use_best_instruction_set();  // undoes use_instruction_set()

}  // namespace impinge
