// SPDX-License-Identifier: GPL-3.0-or-later
#include "table/partial_table.hpp"

#include <algorithm>
#include <utility>

#include "table/rim.hpp"

namespace impinge {

PartialTable::PartialTable(AnyScheme scheme, EntrySet entries)
    : scheme_(std::move(scheme)), kept_(std::move(entries)), radii_(kept_.count(), kNoSurface) {}

double PartialTable::radius_of(std::size_t entry) const {
  const auto slot = kept_.slot(entry);
  return slot ? radii_[*slot] : kNoSurface;
}

bool PartialTable::keeps(const Stencil& stencil) const {
  return std::all_of(stencil.entry.begin(), stencil.entry.begin() + stencil.taps,
                     [this](std::size_t i) { return kept_.contains(i); });
}

double PartialTable::radius_at(const Vec3& x) const {
  struct Radii {
    const PartialTable& table;
    double operator[](std::size_t entry) const { return table.radius_of(entry); }
  };
  const Stencil stencil = scheme_.stencil(x);
  return is_rim_cell(stencil.cell) ? kNoSurface : interpolate(stencil, Radii{*this});
}

std::size_t PartialTable::bytes() const {
  return kept_.bytes() + radii_.size() * sizeof(double) + rim_.size() * 2 * sizeof(std::size_t) +
         rim_.bucket_count() * sizeof(void*);
}

void insert_taps(const AnyScheme& scheme, const Vec3& x, EntrySet& entries) {
  const Stencil stencil = scheme.stencil(x);
  for (std::size_t k = 0; k < stencil.taps; ++k) entries.insert(stencil.entry[k]);
}

PartialTable fill_partial(const NearFaces& faces, const AnyScheme& scheme, EntrySet entries, Layer layer) {
  PartialTable table(scheme, std::move(entries));
  std::vector<Vec3> directions;
  directions.reserve(table.kept().count());
  table.kept().for_each([&](std::size_t entry) { directions.push_back(scheme.direction(entry)); });
  for (std::size_t slot = 0; slot < directions.size(); ++slot)
    table.set(slot, faces.radius(directions[slot], layer));
  mask_rim_along(faces.jumps_near(directions, kRimReach * scheme.stencil_radius()), faces.mesh(), layer,
                 table);
  return table;
}

}  // namespace impinge
