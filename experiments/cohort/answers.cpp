// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/answers.hpp"

#include <iterator>

#include "cohort/limit_answers.hpp"
#include "cohort/shape_answers.hpp"
#include "rotations/volume.hpp"

namespace impinge::lab {
namespace {

std::vector<Column> volume_columns() {
  return {{"volume_free_low", "1", "share of all rotations that is free of contact, no less"},
          {"volume_free_high", "1", "no more"},
          {"volume_reach_low", "1", "share that can be reached from the neutral pose, no less"},
          {"volume_reach_high", "1", "no more"}};
}

std::vector<Cell> volume_cells(const Member& member) {
  if (!member.volume) return std::vector<Cell>(volume_columns().size());
  VolumeSettings settings;
  settings.threads = 1;  // shards run beside each other
  const VolumeShares shares = MotionVolume(CellTest(member.meshes), settings).shares();
  return {shares.low(), shares.high(), shares.reached(), shares.within_reach()};
}

template <class T>
void append(std::vector<T>& list, std::vector<T> more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<Column> answer_columns(const Study& study) {
  const CohortQuestions& asked = study.questions;
  std::vector<Column> columns;
  std::vector<Column> fine;
  if (asked.limits) {
    append(columns, limit_columns(asked));
    append(fine, plain_limit_columns());
  }
  if (asked.morphology) {
    append(columns, shape_columns());
    append(fine, shape_columns());
  }
  if (asked.volume) append(columns, volume_columns());
  if (study.check_every == 0) return columns;
  for (Column& column : fine) column.name = kFine + column.name;
  append(columns, std::move(fine));
  return columns;
}

std::vector<Cell> answers(const Study& study, const Member& member) {
  const CohortQuestions& asked = study.questions;
  std::vector<Cell> cells;
  if (asked.limits) append(cells, limit_cells(asked, member.meshes, member.side));
  if (asked.morphology) append(cells, shape_cells(member.meshes, member.side));
  if (asked.volume) append(cells, volume_cells(member));
  if (member.fine) {
    if (asked.limits) append(cells, plain_limit_cells(*member.fine, member.side));
    if (asked.morphology) append(cells, shape_cells(*member.fine, member.side));
  }
  cells.resize(answer_columns(study).size());
  return cells;
}

}  // namespace impinge::lab
