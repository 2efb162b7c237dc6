// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a part of a study's hips, in a file of its own, which grows whole rows at a time.
//
// DIR/study.json          the study, as it is run there
// DIR/shards/i-of-K.rows  a line of JSON: study (digest), first, last (hips from first to before last), rows
//                         that are there, sha256 of them, seconds of work behind them, cpu; then the rows as
//                         CSV without a head
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "cohort/member.hpp"
#include "cohort/study.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// Part i of K.
struct ShardName {
  std::size_t i = 1;   // from 1
  std::size_t of = 1;  // K
};

// From "i/K"; std::invalid_argument, one line, for anything else, such as 0/0.
ShardName parse_shard(const std::string& text);

// The hips of a shard: from `first` to before `last`, as even as can be.
struct ShardHips {
  std::size_t first = 0;
  std::size_t last = 0;
};
ShardHips hips_of(const ShardName& shard, std::size_t hips);  // of so many

// Where its rows are.
std::filesystem::path shard_file(const std::filesystem::path& folder, const ShardName& shard);

// The columns of every row: hip, its description, its answers.
std::vector<Column> cohort_columns(const Study& study);

// The cells of hip j.
std::vector<Cell> cohort_row(const Study& study, const Members& members, std::size_t j);

// A shard file.
struct ShardRows {
  std::size_t rows = 0;  // that are there
  std::string csv;       // their lines
  double seconds = 0.0;  // of work, processor time
  std::string cpu;       // that they were worked out on, the last one
};

// Reads one. std::runtime_error, one line, where it is no such file, of another study or other hips, or its
// bytes are not those that were written.
ShardRows read_shard(const std::filesystem::path& file, const Study& study, const ShardHips& hips);

// What a run of a shard did.
struct ShardRun {
  ShardHips hips;
  std::size_t kept = 0;  // rows that were there already
  double seconds = 0.0;  // of this run
};

// Works out the rows that are missing. Keeps those that a run before this one wrote, writes every few
// seconds, and ends with all of them. std::runtime_error, one line, for a folder of another study.
ShardRun run_shard(const Study& study, const ShardName& shard, const std::filesystem::path& folder);

// From the shards of a folder to its three results: cohort.csv, a row a hip; cohort.json, what they say
// together; shards.json, what each shard took. The first two are the same bytes for any number of shards.

// What was merged.
struct Merged {
  std::size_t hips = 0;
  std::size_t shards = 0;
};

// std::runtime_error, one line, that names the shards that are missing, unfinished or broken, and how to work
// them out.
Merged merge(const std::filesystem::path& folder);

}  // namespace impinge::lab
