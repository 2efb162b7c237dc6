// SPDX-License-Identifier: GPL-3.0-or-later
#include "28_turns/turn_study.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "methods/cgal.hpp"
#include "methods/contact.hpp"

namespace impinge::lab {
namespace {

using enum TurnQuery::Kind;

using MakeTouch = std::function<Touch(const BallSocketPair&)>;

TurnCase in_steps(const std::string& name, const std::string& label, int place, double step_deg,
                  const MakeTouch& make) {
  TurnCase one{{name, label, "steps of " + Cell(step_deg).text() + " deg", place}, {face_face, mesh}};
  one.make = [make, step = step_deg * kDegree](const TurnQuery& query) -> FindTurn {
    const auto pair = std::make_shared<const BallSocketPair>(BallSocketPair{query.turning, query.resting});
    return [&query, pair, touches = make(*pair), step] { return stepped(query, touches, step); };
  };
  return one;
}

}  // namespace

std::vector<TurnCase> turn_cases(bool quick) {
  std::vector<TurnCase> all = cases_of(turns_methods(), &Method::turns);
  const BallSocketPair none;
  const std::vector<ContactCase> steps = cases_of(steps_methods(), &Method::steps, none);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const MakeTouch make = [k](const BallSocketPair& pair) {
      return cases_of(steps_methods(), &Method::steps, pair)[k].make().touches;
    };
    for (const double step : steps[k].few || quick ? std::vector{5.0} : std::vector{5.0, 0.5})
      all.push_back(in_steps(steps[k].name, steps[k].label, 30, step, make));
  }
  all.push_back(in_steps("cgal_exact", "CGAL, exact test", 32, 5.0,
                         [](const BallSocketPair& pair) { return make_cgal_tree(pair.ball, pair.socket); }));
  return all;
}

void TurnTally::add(const KnownTurn& turn, const TurnAnswer& answer) {
  ++queries;
  meet += turn.first ? 1U : 0U;
  const bool late = turn.first && (!answer.angle || *answer.angle > *turn.first + kTurnTolerance);
  if (late) {
    if (missed++ == 0) missed_first = turn.name;
  } else if (!answer.certain) {
    ++undecided;
    return;
  }
  if (!answer.angle) return;
  if (!turn.first) {
    ++false_hits;
    return;
  }
  const double off = *answer.angle - *turn.first;
  early += off < -kTurnTolerance ? 1U : 0U;
  largest_late = std::max(largest_late, off);
  largest_early = std::max(largest_early, -off);
}

std::vector<Column> tally_columns() {
  return {{"queries", "1", "that were asked"},
          {"meet", "1", "of these, in which they meet within 3 radians"},
          {"missed", "1", "of these, no answer, or one more than 1e-6 radians too late"},
          {"false_hits", "1", "an answer where they do not meet"},
          {"early", "1", "an answer more than 1e-6 radians too early"},
          {"undecided", "1", "it says that none is up to an angle, and nothing of what follows"},
          {"largest_late_rad", "rad", "by which an answer is later than the first meeting"},
          {"largest_early_rad", "rad", "by which an answer is earlier"}};
}

std::vector<Cell> tally_cells(const TurnTally& tally) {
  return {tally.queries, tally.meet,      tally.missed,       tally.false_hits,
          tally.early,   tally.undecided, tally.largest_late, tally.largest_early};
}

}  // namespace impinge::lab
