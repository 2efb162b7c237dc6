// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene asks for, and what work may be left out without changing its answer.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "gap/pose.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge {

/// What is asked of the poses.
enum class Question {
  touch,          // of each pose: has some vertex a gap of 0 or less?
  first_contact,  // the smallest gap of any vertex in any pose
  all_gaps,       // the gap of every vertex in every pose
};

/// What is to be known, of which vertices, in which poses, how exactly.
struct SceneNeeds {
  Question question = Question::all_gaps;  // what is asked of the poses
  bool ball = true;                        // the first scan: vertices of the ball against the socket
  bool socket = true;                      // the second scan
  std::vector<Pose> poses{Pose{}};         // of the ball in the socket, in the order of the answer
  /// Largest error of a gap, mm, above 0; none: the answers of the given table, bit for bit.
  std::optional<double> accuracy_mm;
};

/// Kinds of work that can be left out, each independently of the others.
enum class Omission {
  vertices,       // that cannot come within reach of the other surface, or cannot change the answer
  entries,        // of the tables, that no vertex reads
  second_scan,    // where bounds prove that it cannot change the answer
  fine_table,     // a precision, storage or scheme finer than the accuracy needs
  distances,      // Euclidean
  error_bounds,   // of each gap
  exact_verdicts  // the exact reference
};

/// An omission as options and reports name it.
struct OmissionName {
  Omission omission;         // which it is
  std::string_view name;     // as it is typed
  std::string_view meaning;  // what is left out
};
/// All of them, in the order of the enumeration.
inline constexpr std::array kOmissions{
    OmissionName{Omission::vertices, "vertices", "vertices that cannot change the answer are not looked up"},
    OmissionName{Omission::entries, "entries", "entries that no vertex reads get no memory"},
    OmissionName{Omission::second_scan, "second_scan", "the socket's vertices are not scanned"},
    OmissionName{Omission::fine_table, "fine_table", "the table is no finer than the accuracy needs"},
    OmissionName{Omission::distances, "distances", "no Euclidean distances"},
    OmissionName{Omission::error_bounds, "error_bounds", "no bounds of single gaps"},
    OmissionName{Omission::exact_verdicts, "exact_verdicts", "no exact verdicts"}};

/// What may be left out.
class Omissions {
 public:
  static Omissions none() { return {}; }  // everything is done
  /// Everything that the enumeration names.
  static Omissions all() {
    Omissions all;
    all.set_.set();
    return all;
  }
  /// May it be left out?
  bool has(Omission omission) const { return set_[static_cast<std::size_t>(omission)]; }
  /// These and one more.
  Omissions with(Omission omission) const {
    Omissions more = *this;
    more.set_.set(static_cast<std::size_t>(omission));
    return more;
  }
  /// These but one.
  Omissions without(Omission omission) const {
    Omissions less = *this;
    less.set_.reset(static_cast<std::size_t>(omission));
    return less;
  }

 private:
  std::bitset<kOmissions.size()> set_;
};

}  // namespace impinge
