// SPDX-License-Identifier: GPL-3.0-or-later
// The refusal of tables that no machine could hold, before memory is asked for.
#pragma once

#include <cstddef>
#include <string_view>

namespace impinge {

/// A table of more entries is refused: at 8 bytes each they would take more than 1 TiB. Entries and cells are
/// counted in 64 bits, and directions and stencils of finer schemes can be asked for all the same (see
/// sphere/schemes/: each states its finest precision).
inline constexpr std::size_t kMostTableEntries = std::size_t{1} << (sizeof(std::size_t) > 4 ? 37U : 28U);

/// The number of entries; std::invalid_argument that says how many bytes they would take if they are too
/// many.
std::size_t require_table_size(std::string_view scheme, std::size_t entries);

}  // namespace impinge
