// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of a part of a study's hips, in a file of its own that grows by whole rows.
//
// DIR/study.json          the study, as it is run there
// DIR/shards/i-of-K.rows  a line of JSON: study (digest), joints (digest of their files), commit of the
//                         program, first, last (hips from first to before last), number of rows, their
//                         sha256, seconds of work behind them, cpu; then the rows as CSV without a head
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "cohort/member.hpp"
#include "cohort/study.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// A shard: part i of K.
struct ShardName {
  std::size_t i = 1;   // from 1
  std::size_t of = 1;  // K
};

// Reads "i/K". Throws std::invalid_argument, one line, for anything else, such as 0/0.
ShardName parse_shard(const std::string& text);

// The hips of a shard, from `first` to before `last`; shards are as equal as possible.
struct ShardHips {
  std::size_t first = 0;
  std::size_t last = 0;
};
ShardHips hips_of(const ShardName& shard, std::size_t hips);  // of so many hips in all

// The file of a shard's rows.
std::filesystem::path shard_file(const std::filesystem::path& folder, const ShardName& shard);

// The columns of a row: hip, description, answers.
std::vector<Column> cohort_columns(const Study& study);

// The cells of hip j.
std::vector<Cell> cohort_row(const Study& study, const Members& members, std::size_t j);

// The contents of a shard file.
struct ShardRows {
  std::size_t rows = 0;  // number of rows
  std::string csv;       // their lines
  double seconds = 0.0;  // of work, in processor time
  std::string cpu;       // on which the last row was worked out
};

// Reads a shard file. Throws std::runtime_error, one line, if it is no such file, belongs to another study or
// to other hips, is of joints whose files were others or of another version of the program, or was changed.
ShardRows read_shard(const std::filesystem::path& file, const Study& study, const Members& members,
                     const ShardHips& hips);

// The result of running a shard.
struct ShardRun {
  ShardHips hips;
  std::size_t kept = 0;               // rows of earlier runs
  double seconds = 0.0;               // of this run
  std::vector<std::string> warnings;  // about the joints of the study's folder, a line each
};

// Works out the missing rows. Keeps the rows of earlier runs, writes every few seconds, and ends with all
// rows. Throws std::runtime_error, one line, for a folder of another study.
ShardRun run_shard(const Study& study, const ShardName& shard, const std::filesystem::path& folder);

// The three results of a folder's shards: cohort.csv, a row per hip; cohort.json, a summary of all rows;
// shards.json, the work of each shard. The first two have the same bytes for any number of shards.

// The result of merging.
struct Merged {
  std::size_t hips = 0;
  std::size_t shards = 0;
};

// Merges the shards of a folder. Throws std::runtime_error, one line, that names missing, unfinished or
// broken shards and says how to work them out.
Merged merge(const std::filesystem::path& folder);

}  // namespace impinge::lab
