// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Updates a table after a part of its mesh has moved (the thesis' deformable case). Only entries that a
/// changed face covers, before or after, are worked out again.
#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "sphere/entry_set.hpp"
#include "sphere/walker.hpp"
#include "table/exact_raster.hpp"
#include "table/face_cap.hpp"
#include "table/rim.hpp"

namespace impinge {

/// Faces with a moved corner. Throws std::invalid_argument unless the meshes differ only in the places of
/// their vertices.
std::vector<std::size_t> changed_faces(const TriangleMesh& before, const TriangleMesh& after);

/// A cap that holds all directions of these faces in both meshes; if no narrower cap is found, it is the
/// whole sphere.
DirectionCap cap_of_faces(const TriangleMesh& before, const TriangleMesh& after,
                          const std::vector<std::size_t>& faces);

/// Are all directions of the face outside the cap? False if that is not certain.
bool surely_outside(const TriangleMesh& mesh, const Face& face, const DirectionCap& cap);

/// Makes the table of `after` from `table`, which was filled exactly from `before` for this layer; the result
/// is the same bit for bit. Returns how many entries were worked out: all for a scheme without known cell
/// borders (HasKnownBorders). The rim is always traced anew as a whole. Throws as changed_faces().
template <SamplingScheme S>
std::size_t refill(const TriangleMesh& before, const TriangleMesh& after, Layer layer,
                   RadialTable<S>& table) {
  const std::vector<std::size_t> changed = changed_faces(before, after);
  if (changed.empty()) return 0;
  if constexpr (!HasKnownBorders<S>) {  // entries beside the former rim have no radius
    table = fill_exact(after, table.scheme(), layer);
    return table.scheme().size();
  }
  const auto& walker = walker_of(table.scheme());
  EntrySet touched(table.scheme().size());
  for (const std::size_t f : changed) {
    for (const TriangleMesh* mesh : {&before, &after}) {
      const TriangleCone cone = cone_of(*mesh, mesh->faces[f]);
      if (cone.edge_on()) continue;
      for_each_entry_inside(walker, cone, [&](std::size_t entry, const Vec3&) { touched.insert(entry); });
    }
  }
  touched.number();
  const auto radii = table.radii();
  touched.for_each([&](std::size_t entry) { radii[entry] = kNoSurface; });
  const DirectionCap cap = cap_of_faces(before, after, changed);
  for (const Face& face : after.faces) {
    if (surely_outside(after, face, cap)) continue;
    const TriangleCone cone = cone_of(after, face);
    if (cone.edge_on()) continue;
    for_each_entry_inside(walker, cone, [&](std::size_t entry, const Vec3& u) {
      if (touched.contains(entry)) keep(radii[entry], cone.radius(u), layer);
    });
  }
  table.forget_rim();
  mask_rim(after, layer, table);
  return touched.count();
}

}  // namespace impinge
