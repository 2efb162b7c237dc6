// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "17_motion/limit_study.hpp"

namespace impinge::lab {
namespace {

const char* name(CentreStrategy centre) { return centre == CentreStrategy::head ? "head" : "socket"; }

Cell number(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

Cell upper(const CentreInterval& interval) { return interval.limited ? Cell(interval.high_deg) : Cell(); }

const Column kJoint{"joint", "", "preset of a generated hip, or folder of a real joint"};
const Column kMotion{"motion", "", "fadir: rotation in 90 of flexion, 15 of adduction; faber: 45, 30"};
const Column kLow{"limit_low_deg", "deg", "proven: no contact before; 0 where blocked at the start"};
const Column kHigh{"limit_high_deg", "deg", "certain: touches here; the largest angle where free or unknown"};
const Column kClock{"clock", "", "of the contact on the socket, 12 superior, 3 anterior; empty where none"};
const Column kSmallest{"smallest_gap_mm", "mm", "of a vertex, at the lower end"};
const Column kState{"state", "", "limited; free; blocked at the start; unknown beyond the lower end"};

// Columns of both tables on a limit's other centres.
void add_doubts(std::vector<Column>& columns) {
  columns.insert(
      columns.end(),
      {{"centre_low_deg", "deg",
        "of contact, proven: none before for any common centre within 0.5 mm; 0 says nothing"},
       {"centre_high_deg", "deg", "proven: every such centre touches here; empty where no angle is known"},
       {"half_mm_gap_deg", "deg", "of contact: where a vertex first has a gap of 0.5 mm; empty if none has"},
       {"hangs_on_less", "",
        "yes: that gap comes more than 5 degrees before the limit, or there is none; or some centre within "
        "0.5 mm may have another by more than that"},
       {"leaves_mesh_deg", "deg", "where the ball's mesh ends under the socket; empty where it does not"}});
}

std::vector<Cell> doubts(const ToldLimit& told) {
  return {told.common.low_deg, upper(told.common), number(told.half_mm_gap_deg), told.hangs_on_less(),
          number(told.limit.leaves_mesh_deg)};
}

}  // namespace

Table limit_table(const std::vector<LimitCase>& cases) {
  Table table;
  table.columns = {kJoint, kMotion, kLow, kHigh, kClock, kSmallest, kState};
  add_doubts(table.columns);
  for (const LimitCase& found : cases) {
    if (found.told.threshold_mm > 0.0 || found.centre != CentreStrategy::head) continue;
    const TurnLimit& limit = found.told.limit;
    std::vector<Cell> row{found.joint, found.motion->name,         limit.low_deg,    limit.high_deg,
                          found.clock, number(found.smallest_gap), name(limit.state)};
    const std::vector<Cell> more = doubts(found.told);
    row.insert(row.end(), more.begin(), more.end());
    table.add_row(row);
  }
  return table;
}

Table limit_detail_table(const std::vector<LimitCase>& cases) {
  Table table;
  table.columns = {kJoint,
                   kMotion,
                   {"centre", "", "turned about: of the head as scanned, or of the socket (equidistant)"},
                   {"shift_mm", "mm", "of the head from the pose of the scan"},
                   {"gap_mm", "mm", "threshold of the vertices' gaps; empty: contact of the surfaces"},
                   kState,
                   kLow,
                   kHigh,
                   kClock,
                   {"contact", "", "what meets what"},
                   kSmallest,
                   {"surface_deg", "deg", "first order: 0.5 mm of a surface, or play, across the contact"},
                   {"centre_deg", "deg", "first order: 0.5 mm of the common centre"},
                   {"play_low_deg", "deg", "proven: none before for any play up to 0.5 mm; 0 says nothing"},
                   {"play_high_deg", "deg", "proven: touches here for every such play; empty: none known"}};
  add_doubts(table.columns);
  for (const LimitCase& found : cases) {
    const TurnLimit& limit = found.told.limit;
    const auto moved = [&](double each) {
      return limit.contact && std::isfinite(each) ? Cell(kErrorOfInput * each) : Cell();
    };
    const double gap = found.told.threshold_mm;
    std::vector<Cell> row{found.joint,
                          found.motion->name,
                          name(found.centre),
                          found.shift_mm,
                          gap > 0.0 ? Cell(gap) : Cell(),
                          name(limit.state),
                          limit.low_deg,
                          limit.high_deg,
                          found.clock,
                          limit.contact ? Cell(name(limit.contact->kind)) : Cell(),
                          number(found.smallest_gap),
                          moved(limit.deg_per_mm),
                          moved(limit.centre_deg_per_mm),
                          found.told.play.low_deg,
                          upper(found.told.play)};
    const std::vector<Cell> more = doubts(found.told);
    row.insert(row.end(), more.begin(), more.end());
    table.add_row(row);
  }
  return table;
}

Table phantom_table(const std::vector<PhantomRow>& rows) {
  Table table;
  table.columns = {
      {"phantom", "", "phantoms/phantom.hpp has the formulas"},
      {"quantity", "", "limit in degrees, or gap in mm"},
      {"closed_form", "", "of the smooth surfaces"},
      {"measured", "", "on meshes; of a limit the middle of its bracket"},
      {"error", "", "measured less closed form"},
      {"target", "", "of limits: chosen, degrees"},
      {"bound", "", "of gaps: proven, the sagittas of the meshes and the error of the table, mm"}};
  for (const PhantomRow& row : rows)
    table.add_row({row.phantom, row.quantity, row.closed_form, row.measured, row.error,
                   row.proven ? Cell() : Cell(row.allowed), row.proven ? Cell(row.allowed) : Cell()});
  return table;
}

}  // namespace impinge::lab
