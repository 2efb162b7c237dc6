// SPDX-License-Identifier: GPL-3.0-or-later
// A study: which hips, and the questions about each.
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

// The questions about each hip.
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
  nlohmann::json text;              // with the number of hips of this run
  std::string digest;               // SHA-256 of the text without that number; shards must agree in it
  std::size_t hips = 0;             // how many
  std::uint64_t seed = 0;           // of all draws
  CohortQuestions questions;        // asked of each hip
  std::filesystem::path joints;     // folder of real joints; empty where hips are drawn
  HipParameters start;              // parameters that all hips share
  std::vector<Spread> spreads;      // parameters that differ
  Eigen::MatrixXd mixing;           // lower triangular: normal scores = mixing x independent ones
  std::size_t faces = 3000;         // of a surface
  std::size_t check_every = 0;      // one of so many hips gets a second look; 0 for none
  std::size_t check_faces = 12000;  // faces for the second look
};

// Reads a study; `hips` replaces its own number. Throws std::runtime_error, one line that names the file, the
// key, the reason and the cure.
//
// A study is a JSON file with
//   title       text
//   hips        number of hips
//   seed        of all random numbers, a whole number of 0 or more
//   faces       of a surface, about
//   start       a preset (hip/hip_presets.hpp); it gives the parameters that are not named below
//   parameters  NAME: number, or NAME: {distribution, source} with the numbers of the distribution
//               (cohort/spread.hpp): mean and sd; median and sd_of_log; least and most, which the first three
//               distributions may also have
//   correlations  [{between: [NAME, NAME], r, source}], of the normal scores of two parameters
//   questions   some of limits, morphology, zones, volume
//   zone_gap_mm   gaps up to this make a zone; 2 if not given
//   volume_every  one of so many hips is asked for its motion volume; 1 if not given
//   check_every, check_faces   one of so many hips is also made with so many faces, and asked again
// In place of hips, faces, start, parameters, correlations and check_* it may have
//   joints      a folder of real joints (harness/real_joints.hpp); hip j is the j-th by name
Study read_study(const std::filesystem::path& file, std::optional<std::size_t> hips);

}  // namespace impinge::lab
