// SPDX-License-Identifier: GPL-3.0-or-later
// From the shards of a folder to its three results: cohort.csv, a row a hip; cohort.json, what they say
// together; shards.json, what each shard took. The first two are the same bytes for any number of shards.
#pragma once

#include <cstddef>
#include <filesystem>

namespace impinge::lab {

// What was merged.
struct Merged {
  std::size_t hips = 0;
  std::size_t shards = 0;
};

// std::runtime_error, one line, that names the shards that are missing, unfinished or broken, and how to work
// them out.
Merged merge(const std::filesystem::path& folder);

}  // namespace impinge::lab
