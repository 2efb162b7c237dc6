// SPDX-License-Identifier: GPL-3.0-or-later
// A study: which hips, and what is asked of each. A JSON file with
//   title       text
//   hips        how many
//   seed        of all draws, a whole number of 0 or more
//   faces       of a surface, about
//   start       a preset (hip/hip_presets.hpp), whose parameters are those that are not named below
//   parameters  NAME: number, or NAME: {distribution, source} with, by the distribution (cohort/spread.hpp),
//               mean and sd; median and sd_of_log; least and most, which the first three may have too
//   correlations  [{between: [NAME, NAME], r, source}], of the normal scores of two parameters
//   questions   some of limits, morphology, zones, volume
//   zone_gap_mm   gaps up to this are a zone; 2 if not given
//   volume_every  each so manieth hip is asked for its motion volume; 1 if not given
//   check_every, check_faces   each so manieth hip is made of so many faces too, and asked again
// or, in the place of hips, faces, start, parameters, correlations and check_*,
//   joints      a folder of real joints (harness/real_joints.hpp), hip j the j-th by name
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "cohort/spread.hpp"

namespace impinge::lab {

// What is asked of each hip.
struct CohortQuestions {
  bool limits = false;
  bool morphology = false;
  bool zones = false;
  bool volume = false;
  double zone_gap_mm = 2.0;      // the thesis' red is below 2 (Section 5.2)
  std::size_t volume_every = 1;  // hips
};

// A study as it was read.
struct Study {
  nlohmann::json text;              // with the number of hips that it is run with
  std::string digest;               // SHA-256 of it without that number: whose shards these are
  std::size_t hips = 0;             // how many
  std::uint64_t seed = 0;           // of all draws
  CohortQuestions questions;        // asked of each hip
  std::filesystem::path joints;     // folder of real joints; empty where hips are drawn
  HipParameters start;              // what every hip has
  std::vector<Spread> spreads;      // what spreads
  Eigen::MatrixXd mixing;           // lower triangular: normal scores = mixing x independent ones
  std::size_t faces = 3000;         // of a surface
  std::size_t check_every = 0;      // 0 for no second look
  std::size_t check_faces = 12000;  // at that many
};

// Reads a study; `hips` in the place of its own number. std::runtime_error, one line that names the file, the
// key, the reason and the cure.
Study read_study(const std::filesystem::path& file, std::optional<std::size_t> hips);

}  // namespace impinge::lab
