// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/needed_work.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "files/formatted.hpp"
#include "mesh/surface_vertices.hpp"
#include "sphere/infinity.hpp"
#include "sphere/radial_table.hpp"
#include "table/partial_table.hpp"

namespace impinge {
namespace {

constexpr std::size_t scan_of(Surface scanned) { return scanned == Surface::ball ? 0 : 1; }

// The largest gap that matters.
double most_that_matters(Question question, double limit) {
  if (question == Question::all_gaps) return kInfinity;
  return question == Question::touch ? std::min(limit, 0.0) : limit;
}

std::size_t look_ups_of(const SceneNeeds& needs, const NeededVertices& vertices, std::size_t scan) {
  std::size_t count = 0;
  for (std::size_t p = 0; p < needs.poses.size(); ++p) count += vertices.in(scan, p).size();
  return count;
}

// answer(vertices) for the vertices that can change the answer, or for all of them if none keeps the limit.
template <class Answer>
SceneAnswer answer_needed(const BallSocketPair& joint, const SceneNeeds& needs, const FacesMet& faces,
                          const Answer& answer) {
  if (needs.poses.empty() || !(needs.ball || needs.socket))
    throw std::invalid_argument("a scene without poses or without scans asks nothing: give one of each");
  const NeededVertices vertices = needed_vertices(joint, needs, faces);
  SceneAnswer found = answer(vertices);
  if (!limit_kept(needs, vertices, found)) return answer(all_vertices(joint, needs));
  for (const Surface of : kSurfaces) {
    if (!needs.scans(of)) continue;
    const std::size_t kept = look_ups_of(needs, vertices, scan_of(of));
    const std::size_t all = needs.poses.size() * mesh_of(joint, of).vertices.size();
    found.left_out.push_back({"vertices", "vertices that cannot change the answer are not looked at",
                              formatted("%zu of the %zu look-ups of the %s's vertices can change it", kept,
                                        all, name(of).data())});
  }
  return found;
}

}  // namespace

NeededVertices all_vertices(const BallSocketPair& joint, const SceneNeeds& needs) {
  NeededVertices all;
  for (const Surface of : kSurfaces) {
    if (needs.scans(of)) all.of[scan_of(of)] = {surface_vertices(mesh_of(joint, of))};
  }
  all.limit_mm.assign(needs.poses.size(), kInfinity);
  return all;
}

NeededVertices needed_vertices(const BallSocketPair& joint, const SceneNeeds& needs, const FacesMet& faces) {
  struct Met {
    VertexIndex vertex;
    double low;  // mm; the gap is no smaller
  };
  const bool touch = needs.question == Question::touch;
  NeededVertices needed = all_vertices(joint, needs);
  const auto limit_of = [&](std::size_t pose) -> double& { return needed.limit_mm[touch ? pose : 0]; };
  std::array<std::vector<std::vector<Met>>, 2> met;
  met.fill(std::vector<std::vector<Met>>(needs.poses.size()));
  for (std::size_t p = 0; p < needs.poses.size(); ++p) {
    double& limit = limit_of(p);
    for (const Surface of : kSurfaces) {
      if (!needs.scans(of)) continue;
      for (const VertexIndex v : needed.in(scan_of(of), p)) {
        if (touch && limit <= 0.0) break;
        const Vec3 x = to_other(of, needs.poses[p], mesh_of(joint, of).vertices[v]);
        const NearFaces::Near near = faces[scan_of(of)]->near(x);
        if (near.nothing()) continue;
        const RadiusRange gap = signed_gap(of, near.range, x.norm());
        if (!near.rim) limit = std::min(limit, gap.high);
        if (gap.low <= most_that_matters(needs.question, limit)) met[scan_of(of)][p].push_back({v, gap.low});
      }
    }
  }
  for (std::size_t scan = 0; scan < met.size(); ++scan) {
    needed.of[scan].assign(needs.poses.size(), {});
    for (std::size_t p = 0; p < needs.poses.size(); ++p) {
      for (const Met& vertex : met[scan][p]) {
        if (vertex.low <= most_that_matters(needs.question, limit_of(p)))
          needed.of[scan][p].push_back(vertex.vertex);
      }
    }
  }
  return needed;
}

EntrySet needed_entries(const BallSocketPair& joint, const SceneNeeds& needs, const NeededVertices& vertices,
                        Surface scanned, const AnyScheme& scheme) {
  EntrySet entries(scheme.size());
  for (std::size_t p = 0; p < needs.poses.size(); ++p) {
    for (const VertexIndex v : vertices.in(scan_of(scanned), p))
      insert_taps(scheme, to_other(scanned, needs.poses[p], mesh_of(joint, scanned).vertices[v]), entries);
  }
  entries.number();
  return entries;
}

SceneAnswer answer_from(const BallSocketPair& joint, const SceneNeeds& needs, const NeededVertices& vertices,
                        const GapAt& gap_at) {
  SceneAnswer answer;
  if (needs.question == Question::touch) answer.touches.assign(needs.poses.size(), false);
  if (needs.question == Question::all_gaps) answer.gaps.resize(needs.poses.size());
  const auto note = [&](const SmallestGap& found) {
    if (needs.question == Question::all_gaps) {
      answer.gaps[found.pose][scan_of(found.scanned)][found.vertex] = found.gap_mm;
    } else if (needs.question == Question::touch) {
      answer.touches[found.pose] = found.gap_mm <= 0.0;
    } else if (found.gap_mm < (answer.smallest ? answer.smallest->gap_mm : kInfinity)) {
      answer.smallest = found;
    }
  };
  for (const Surface of : kSurfaces) {
    if (!needs.scans(of)) continue;
    const std::vector<Vec3>& places = mesh_of(joint, of).vertices;
    for (std::size_t p = 0; p < needs.poses.size(); ++p) {
      if (needs.question == Question::all_gaps) answer.gaps[p][scan_of(of)].assign(places.size(), kNoSurface);
      for (const VertexIndex v : vertices.in(scan_of(of), p)) {
        if (needs.question == Question::touch && answer.touches[p]) break;
        ++answer.look_ups;
        note({gap_at(of, v, to_other(of, needs.poses[p], places[v])), of, p, v});
      }
    }
  }
  return answer;
}

bool limit_kept(const SceneNeeds& needs, const NeededVertices& vertices, const SceneAnswer& answer) {
  if (needs.question == Question::first_contact) {
    const double limit = vertices.limit_mm.front();
    return std::isinf(limit) || (answer.smallest && answer.smallest->gap_mm <= limit);
  }
  for (std::size_t p = 0; p < answer.touches.size(); ++p) {
    if (vertices.limit_mm[p] <= 0.0 && !answer.touches[p]) return false;
  }
  return true;
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
                                look_ups_of(needs, vertices, scan_of(of)) * sizeof(VertexIndex);
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
