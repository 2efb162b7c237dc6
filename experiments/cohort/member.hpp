// SPDX-License-Identifier: GPL-3.0-or-later
// The hips of a study as meshes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cohort/study.hpp"
#include "files/csv.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// One hip, to be asked.
struct Member {
  BallSocketPair meshes;               // joint frame, mm, the centre of the head as origin
  std::optional<Side> side;            // without one flexion and extension alone are known
  std::vector<Cell> description;       // by description_columns()
  std::optional<BallSocketPair> fine;  // the same of more faces, where a second look is due
  bool volume = false;                 // is its motion volume asked for?
};

// Makes each hip when it is asked for; reads a folder of joints once.
class Members {
 public:
  // std::runtime_error, one line, for a folder that holds no joints.
  explicit Members(const Study& study);

  std::size_t size() const;                         // hips of the study
  std::vector<Column> description_columns() const;  // what a row begins with
  Member member(std::size_t j) const;               // hip j, from 0

 private:
  struct Named {
    std::string name;
    BallSocketPair meshes;
    std::optional<Side> side;
  };
  Member drawn(std::size_t j) const;
  Member read(std::size_t j) const;

  const Study& study_;
  std::vector<Named> joints_;
};

// Hip j of a study follows from the study and j alone: draws are not taken one after another but looked up,
// by what they are for.

// A number in (0, 1), uniform, one of 2^52 equally spaced ones: 13 hexadecimal digits of the SHA-256 of seed,
// tag, hip and attempt, as text.
double uniform_draw(std::uint64_t seed, const std::string& tag, std::size_t hip, std::size_t attempt);

// A hip as it was drawn.
struct DrawnHip {
  HipParameters parameters;  // that make a hip
  std::size_t redrawn = 0;  // draws before that make none (hip/hip_checks.hpp), as a cam that touches at rest
};

// Hip j, from 0. std::runtime_error, one line, if a hundred draws make none.
DrawnHip draw_hip(const Study& study, std::size_t j);

}  // namespace impinge::lab
