// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/needed_work.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "files/formatted.hpp"
#include "mesh/surface_vertices.hpp"
#include "sphere/radial_table.hpp"
#include "table/partial_table.hpp"

namespace impinge {
namespace {

constexpr std::size_t scan_of(Surface scanned) { return scanned == Surface::ball ? 0 : 1; }

// answer(vertices) for the vertices that can change the answer, or for all of them if none keeps the limit.
template <class Answer>
SceneAnswer answer_needed(const BallSocketPair& joint, const SceneNeeds& needs, const FacesMet& faces,
                          const Answer& answer) {
  if (!(needs.ball || needs.socket))
    throw std::invalid_argument("a scene without scans asks nothing: give one");
  const NeededVertices vertices = needed_vertices(joint, needs, faces);
  SceneAnswer found = answer(vertices);
  const bool kept = needs.question == Question::all_gaps || std::isinf(vertices.limit_mm) ||
                    (found.smallest && found.smallest->gap_mm <= vertices.limit_mm);
  if (!kept) return answer(all_vertices(joint, needs));
  for (const Surface of : kSurfaces) {
    if (!needs.scans(of)) continue;
    found.left_out.push_back(
        {"vertices", "vertices that cannot change the answer are not looked at",
         formatted("%zu of the %zu look-ups of the %s's vertices can change it",
                   vertices.of[scan_of(of)].size(), mesh_of(joint, of).vertices.size(), name(of).data())});
  }
  return found;
}

}  // namespace

NeededVertices all_vertices(const BallSocketPair& joint, const SceneNeeds& needs) {
  NeededVertices all;
  for (const Surface of : kSurfaces) {
    if (needs.scans(of)) all.of[scan_of(of)] = surface_vertices(mesh_of(joint, of));
  }
  return all;
}

NeededVertices needed_vertices(const BallSocketPair& joint, const SceneNeeds& needs, const FacesMet& faces) {
  struct Met {
    VertexIndex vertex;
    double low;  // mm; the gap is no smaller
  };
  NeededVertices needed = all_vertices(joint, needs);
  std::array<std::vector<Met>, 2> met;
  for (const Surface of : kSurfaces) {
    for (const VertexIndex v : needed.of[scan_of(of)]) {
      const Vec3 x = to_other(of, needs.pose, mesh_of(joint, of).vertices[v]);
      const NearFaces::Near near = faces[scan_of(of)]->near(x);
      if (near.nothing()) continue;
      const RadiusRange gap = signed_gap(of, near.range, x.norm());
      if (!near.rim) needed.limit_mm = std::min(needed.limit_mm, gap.high);
      met[scan_of(of)].push_back({v, gap.low});
    }
  }
  for (std::size_t scan = 0; scan < met.size(); ++scan) {
    needed.of[scan].clear();
    for (const Met& at : met[scan]) {
      if (needs.question == Question::all_gaps || at.low <= needed.limit_mm)
        needed.of[scan].push_back(at.vertex);
    }
  }
  return needed;
}

EntrySet needed_entries(const BallSocketPair& joint, const SceneNeeds& needs, const NeededVertices& vertices,
                        Surface scanned, const AnyScheme& scheme) {
  EntrySet entries(scheme.size());
  for (const VertexIndex v : vertices.of[scan_of(scanned)])
    insert_taps(scheme, to_other(scanned, needs.pose, mesh_of(joint, scanned).vertices[v]), entries);
  entries.number();
  return entries;
}

SceneAnswer answer_from(const BallSocketPair& joint, const SceneNeeds& needs, const NeededVertices& vertices,
                        const GapAt& gap_at) {
  SceneAnswer answer;
  for (const Surface of : kSurfaces) {
    if (!needs.scans(of)) continue;
    const std::vector<Vec3>& places = mesh_of(joint, of).vertices;
    std::vector<double>& gaps = answer.gaps[scan_of(of)];
    if (needs.question == Question::all_gaps) gaps.assign(places.size(), kNoSurface);
    for (const VertexIndex v : vertices.of[scan_of(of)]) {
      ++answer.look_ups;
      const double gap = gap_at(of, v, to_other(of, needs.pose, places[v]));
      if (needs.question == Question::all_gaps)
        gaps[v] = gap;
      else if (gap < (answer.smallest ? answer.smallest->gap_mm : kInfinity))
        answer.smallest = SmallestGap{gap, of, v};
    }
  }
  return answer;
}

SceneAnswer answer_on_faces(const BallSocketPair& joint, const SceneNeeds& needs, const FacesMet& faces,
                            const GapAt& gap) {
  return answer_needed(joint, needs, faces, [&](const NeededVertices& vertices) {
    return answer_from(joint, needs, vertices, gap);
  });
}

SceneAnswer answer_by_table(const BallSocketPair& joint, const SceneNeeds& needs, const AnyScheme& scheme) {
  std::array<std::optional<NearFaces>, 2> made;
  FacesMet faces{};
  for (const Surface of : kSurfaces) {
    if (!needs.scans(of)) continue;
    const std::size_t scan = scan_of(of);
    faces[scan] = &made[scan].emplace(mesh_of(joint, other(of)), scheme.stencil_radius());
  }
  return answer_needed(joint, needs, faces, [&](const NeededVertices& vertices) {
    std::array<std::optional<PartialTable>, 2> tables;  // a scan without look-ups makes none
    const auto gap = [&](Surface of, std::size_t /*vertex*/, const Vec3& x) {
      std::optional<PartialTable>& table = tables[scan_of(of)];
      if (!table) {
        table = fill_partial(*faces[scan_of(of)], scheme, needed_entries(joint, needs, vertices, of, scheme),
                             facing_layer(other(of)));
      }
      return signed_gap(of, table->radius_at(x), x.norm());
    };
    SceneAnswer answer = answer_from(joint, needs, vertices, gap);
    for (const Surface of : kSurfaces) {
      if (!needs.scans(of)) continue;
      const std::optional<PartialTable>& table = tables[scan_of(of)];
      const std::size_t entries = table ? table->kept().count() : 0;
      const std::size_t bytes = faces[scan_of(of)]->bytes() + (table ? table->bytes() : 0) +
                                vertices.of[scan_of(of)].size() * sizeof(VertexIndex);
      answer.entries += entries;
      answer.bytes += bytes;
      const std::string reason =
          formatted("%zu of the %s's %zu entries are read", entries, name(other(of)).data(), scheme.size());
      const double whole = static_cast<double>(scheme.size() * sizeof(double));
      answer.left_out.push_back({"entries", "entries that no vertex reads get no memory", reason,
                                 whole - static_cast<double>(bytes)});
    }
    return answer;
  });
}

}  // namespace impinge
