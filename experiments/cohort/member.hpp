// SPDX-License-Identifier: GPL-3.0-or-later
// The hips of a study as meshes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cohort/study.hpp"
#include "files/csv.hpp"
#include "joint/joint_folder.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// A hip of the study.
struct Member {
  BallSocketPair meshes;               // joint frame, mm, the centre of the head as origin
  std::optional<Side> side;            // without it only flexion and extension are known
  std::vector<Cell> description;       // cells for description_columns()
  std::optional<BallSocketPair> fine;  // finer meshes, if a second look is due
  bool volume = false;                 // is its motion volume asked for?
};

// Makes each hip when it is asked for; reads a folder of joints only once.
class Members {
 public:
  // Throws std::runtime_error, one line, for a folder without joints that can be used.
  explicit Members(const Study& study);

  std::size_t size() const;                         // number of hips in the study
  std::vector<Column> description_columns() const;  // the first columns of a row
  Member member(std::size_t j) const;               // hip j, from 0

  // SHA-256 of the files of the joints; empty where hips are drawn.
  const std::string& digest() const { return digest_; }
  // What is wrong with joints of the folder, a line each.
  const std::vector<std::string>& left_out() const { return left_out_; }  // and why
  const std::vector<std::string>& warnings() const { return warnings_; }  // of those that are in

 private:
  struct Named {
    std::string name;
    BallSocketPair meshes;
    std::optional<Side> side;
  };
  Named joint_of(const JointFolder& at);
  Member drawn(std::size_t j) const;
  Member read(std::size_t j) const;

  const Study& study_;
  std::vector<Named> joints_;
  std::string digest_;
  std::vector<std::string> left_out_;
  std::vector<std::string> warnings_;
};

// Hip j depends only on the study and on j: its random numbers are not drawn in sequence but computed from
// what each is for.

// A uniform number in (0, 1), one of 2^52 equally spaced ones, from 13 hexadecimal digits of the SHA-256 of
// seed, tag, hip and attempt as text.
double uniform_draw(std::uint64_t seed, const std::string& tag, std::size_t hip, std::size_t attempt);

// A hip as it was drawn.
struct DrawnHip {
  HipParameters parameters;  // parameters that make a hip
  std::size_t redrawn = 0;   // earlier draws that make none (hip/hip_checks.hpp): a cam may touch at rest
};

// Hip j, from 0. Throws std::runtime_error, one line, if a hundred draws make no hip.
DrawnHip draw_hip(const Study& study, std::size_t j);

}  // namespace impinge::lab
