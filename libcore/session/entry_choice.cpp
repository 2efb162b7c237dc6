// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>

#include "files/formatted.hpp"
#include "session/plan_draft.hpp"
#include "session/table_choice.hpp"

namespace impinge {
namespace {

constexpr std::size_t kSampled = 8;  // one in so many look-ups is weighed when a table is chosen

std::size_t bytes_of(Storage storage) {
  switch (storage) {
    case Storage::sixteen_bits:
      return 2;
    case Storage::single_precision:
      return 4;
    case Storage::double_precision:
      break;
  }
  return 8;
}

std::string in_words(const TableChoice& table) {
  if (table.rays_only)
    return "no table at all: the faces near each vertex are fewer than the entries that it would read";
  return formatted("%s at %g degrees, %zu bytes an entry, and faces where that is not proven",
                   std::string(table.scheme.name()).c_str(), table.scheme.precision_deg(),
                   bytes_of(table.storage));
}

// The table for the accuracy.
void choose_table_of(PlanDraft& draft) {
  ScenePlan& plan = draft.plan;
  std::vector<LookUpNeed> needs;
  RadiusRange range;
  for (ScanPlan& scan : plan.scans) {
    if (!scan.wanted) continue;
    index_faces(draft.joint, draft.given.stencil_radius(), scan);
    std::size_t k = 0;
    for_each_look_up(draft, scan, [&](const Vec3& x) {
      if (k++ % kSampled != 0) return;
      const NearFaces::Near near = scan.faces->near(x);
      if (near.nothing()) return;
      needs.push_back({near.range.high, near.slope});
      range.include(near.range.low);
      range.include(near.range.high);
    });
  }
  const double accuracy = *draft.needs.accuracy_mm;
  plan.table = choose_table(needs, kSampled, range, accuracy, draft.given);
  for (ScanPlan& scan : plan.scans) {
    if (scan.wanted && !plan.table.rays_only)
      index_faces(draft.joint, plan.table.scheme.stencil_radius(), scan);
  }
  plan.left_out.push_back(
      {Omission::fine_table, formatted("%g mm need ", accuracy) + in_words(plan.table), 0.0});
}

// Of the plan's table, those that the scan's look-ups read, or all.
EntrySet entries_read(const PlanDraft& draft, const ScanPlan& scan) {
  const TableChoice& table = draft.plan.table;
  EntrySet entries(table.rays_only ? 0 : table.scheme.size());
  if (!table.rays_only && !draft.omissions.has(Omission::entries)) {
    for (std::size_t i = 0; i < table.scheme.size(); ++i) entries.insert(i);
  } else if (!table.rays_only) {
    for_each_look_up(draft, scan, [&](const Vec3& x) {
      if (table.accuracy_mm && !keeps_accuracy(table, 0.0, scan.faces->near(x))) return;
      insert_taps(table.scheme, x, entries);
    });
  }
  entries.number();
  return entries;
}

void keep_entries(PlanDraft& draft, ScanPlan& scan) {
  index_faces(draft.joint, draft.plan.table.scheme.stencil_radius(), scan);
  EntrySet entries = entries_read(draft, scan);
  if (draft.omissions.has(Omission::entries)) {
    const double full = static_cast<double>(draft.given.size()) * sizeof(double);
    const double kept = static_cast<double>(entries.count()) * sizeof(double);
    draft.plan.left_out.push_back({Omission::entries,
                                   formatted("%zu of the %s's %zu entries are read", entries.count(),
                                             name(other(scan.scanned)).data(), draft.given.size()),
                                   full - kept - static_cast<double>(entries.bytes() + scan.faces->bytes())});
  }
  scan.entries = std::move(entries);
}

}  // namespace

void choose_entries(PlanDraft& draft) {
  const bool by_accuracy = draft.needs.accuracy_mm && draft.omissions.has(Omission::fine_table);
  if (by_accuracy) choose_table_of(draft);
  if (!by_accuracy && !draft.omissions.has(Omission::entries)) return;
  for (ScanPlan& scan : draft.plan.scans) {
    if (scan.wanted) keep_entries(draft, scan);
  }
}

}  // namespace impinge
