// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "studies/limit_study.hpp"

namespace impinge {
namespace {

const char* name(CentreStrategy centre) { return centre == CentreStrategy::head ? "head" : "socket"; }

Cell number(const std::optional<double>& value) { return value ? Cell(*value) : Cell(); }

const Column kJoint{"joint", "", "preset of a generated hip, or folder of a real joint"};
const Column kMotion{"motion", "", "fadir: rotation in 90 of flexion, 15 of adduction; faber: 45, 30"};
const Column kLow{"limit_low_deg", "deg", "proven: no contact before; 0 where blocked at the start"};
const Column kHigh{"limit_high_deg", "deg", "certain: reached here; the largest angle looked at where free"};
const Column kClock{"clock", "", "of the contact on the socket, 12 superior, 3 anterior; empty where none"};
const Column kSmallest{"smallest_gap_mm", "mm", "of a vertex, at the lower end"};

}  // namespace

Table limit_table(const std::vector<LimitCase>& cases) {
  Table table;
  table.columns = {kJoint, kMotion, kLow, kHigh, kClock, kSmallest};
  for (const LimitCase& found : cases) {
    if (found.gap_mm || found.centre != CentreStrategy::head) continue;
    table.add_row({found.joint, found.motion->name, found.limit.low_deg, found.limit.high_deg, found.clock,
                   number(found.smallest_gap)});
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
                   {"state", "", "reached; free up to the largest angle; blocked at the start"},
                   kLow,
                   kHigh,
                   kClock,
                   {"contact", "", "what meets what"},
                   kSmallest,
                   {"deg_per_mm", "deg", "change of the limit for 1 mm across the contact"},
                   {"uncertainty_deg", "deg", "the same for an error of the centre or surface of 0.5 mm"}};
  for (const LimitCase& found : cases) {
    const TurnLimit& limit = found.limit;
    const bool known = limit.contact && std::isfinite(limit.deg_per_mm);
    table.add_row({found.joint, found.motion->name, name(found.centre), found.shift_mm, number(found.gap_mm),
                   name(limit.state), limit.low_deg, limit.high_deg, found.clock,
                   limit.contact ? Cell(name(limit.contact->kind)) : Cell(), number(found.smallest_gap),
                   known ? Cell(limit.deg_per_mm) : Cell(),
                   known ? Cell(kInputError * limit.deg_per_mm) : Cell()});
  }
  return table;
}

Table phantom_table(const std::vector<PhantomRow>& rows) {
  Table table;
  table.columns = {
      {"phantom", "", "limits/phantom.hpp has the formulas"},
      {"quantity", "", "limit in degrees, or gap in mm"},
      {"closed_form", "", "of the smooth surfaces"},
      {"measured", "", "on meshes; of a limit the middle of its bracket"},
      {"error", "", "measured less closed form"},
      {"bound", "", "0.01 degrees; of gaps the sagittas of the meshes and the error of the table"}};
  for (const PhantomRow& row : rows)
    table.add_row({row.phantom, row.quantity, row.closed_form, row.measured, row.error, row.bound});
  return table;
}

}  // namespace impinge
