// SPDX-License-Identifier: GPL-3.0-or-later
// Refuses tables that no machine could hold, before memory is asked for.
#pragma once

#include <cstddef>
#include <string_view>

namespace impinge {

/// The most entries of a table: at 8 bytes each they take 1 TiB. A finer scheme (see sphere/schemes/: each
/// states its finest precision) still gives its directions and stencils.
inline constexpr std::size_t kMostTableEntries = std::size_t{1} << (sizeof(std::size_t) > 4 ? 37U : 28U);

/// Returns `entries`. If they are too many, throws std::invalid_argument that says how many bytes they would
/// take.
std::size_t require_table_size(std::string_view scheme, std::size_t entries);

}  // namespace impinge
