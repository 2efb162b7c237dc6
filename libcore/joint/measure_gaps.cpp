// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "contact/euclidean_distance.hpp"
#include "files/formatted.hpp"
#include "files/memory.hpp"
#include "files/thread_team.hpp"
#include "gap/measured_gap.hpp"
#include "gap/overlay.hpp"
#include "joint/pose_answer.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {
namespace {

// What an answer says about how its gaps were found.
constexpr const char* kWholeTables = "whole tables, filled and scanned in double";
constexpr const char* kPartialTables =
    "tables of what the vertices read, filled from the faces near each entry";
constexpr const char* kFaces =
    "each vertex is measured on the faces near it: for one pose this saves the tables";

// Throws std::runtime_error, one line with the bytes and the cure, where tables of both surfaces do not fit
// in memory. Counts bytes in floating point, since someone may ask for 10^18 entries.
void require_memory(std::size_t entries, double precision_deg, double bytes_an_entry, const char* more) {
  const double bytes = 2.0 * bytes_an_entry * static_cast<double>(entries);
  const auto free = static_cast<double>(available_memory());
  if (bytes <= free) return;
  throw std::runtime_error(
      formatted("tables of %zu entries at %g degrees would take %s%.0f bytes (%.1f GiB) and %.1f GiB of "
                "memory are free; choose a coarser --precision",
                entries, precision_deg, more, bytes, bytes / 0x1p30, free / 0x1p30));
}

// Even a table that keeps few entries has a directory for all of them.
AnyScheme partly_kept(const GapsRequest& asked) {
  AnyScheme scheme(asked.scheme_name(), asked.precision());
  require_memory(scheme.size(), scheme.precision_deg(), 4.0 / 4096.0, "more than ");
  return scheme;
}

BallSocketPair meshes_of(const SessionJoint& joint) {
  return {joint.mesh(Surface::ball), joint.mesh(Surface::socket)};
}

SceneNeeds needs_of(const GapsRequest& asked, const Pose& pose) {
  return {Question::all_gaps, asked.scans(Surface::ball), asked.scans(Surface::socket), pose};
}

GapsAnswer by_whole_tables(Session& session, const GapsRequest& asked) {
  constexpr double kEntry = sizeof(double) + sizeof(float);  // radius and slope
  const AnyScheme scheme(asked.scheme_name(), asked.precision());
  require_memory(scheme.size(), asked.precision(), kEntry, "");
  fill_tables(session, {.scheme = asked.scheme_name(),
                        .precision_deg = asked.precision(),
                        .storage = Storage::double_precision,
                        .flat_cube = false,
                        .halvings = 1'000'000});
  GapsAnswer result = answer_pose(session, {asked.pose, Vec3::Zero(), asked.cartilage_mm});
  result.way = kWholeTables;
  result.precision_deg = scheme.precision_deg();
  result.entries_per_table = session.tables.ball->entries();
  result.table_bytes = 2 * result.entries_per_table * sizeof(double);
  bound_gaps(session, result);
  return result;
}

// The answer with the gaps of a scene and all that follows from them.
GapsAnswer answer_of_scene(const SessionJoint& joint, const GapsRequest& asked, const Pose& pose,
                           SceneAnswer scene) {
  auto& [ball, socket] = scene.gaps;
  GapsAnswer result = answer_of_gaps(joint, pose, std::move(ball), std::move(socket), asked.cartilage_mm);
  result.left_out = std::move(scene.left_out);
  return result;
}

GapsAnswer by_partial_tables(const SessionJoint& joint, const GapsRequest& asked) {
  const Pose pose = pose_of(joint, asked.pose);
  const AnyScheme scheme = partly_kept(asked);
  SceneAnswer scene = answer_by_table(meshes_of(joint), needs_of(asked, pose), scheme);
  const std::size_t bytes = scene.bytes;
  GapsAnswer result = answer_of_scene(joint, asked, pose, std::move(scene));
  result.table_bytes = bytes;
  result.way = kPartialTables;
  result.precision_deg = scheme.precision_deg();
  result.entries_per_table = scheme.size();
  return result;
}

// The middle of the ends. Where these are far apart, at a face nearly edge-on, the gap is found as for
// tables.
double likely_gap(Surface of, const NearFaces& faces, const Vec3& x, const CertifiedGap& ends) {
  constexpr double kApart = 1e-6;  // mm
  const double middle = 0.5 * (ends.low + ends.high);
  if (ends.high - ends.low < kApart) return middle;
  const double radius = faces.radius(x.normalized(), facing_layer(other(of)));
  return std::isnan(radius) ? middle : signed_gap(of, radius, x.norm());
}

// Largest error of the gaps of ball and socket, mm, by vertex; NaN where there is no gap.
using VertexBounds = std::array<std::vector<double>, 2>;

// Measures gaps and their bounds on the faces. Throws std::runtime_error for a bound above max_error_mm.
SceneAnswer answer_of_faces(SessionJoint& joint, const GapsRequest& asked, const Pose& pose,
                            VertexBounds& bounds) {
  const SceneNeeds needs = needs_of(asked, pose);
  FacesMet faces{};
  for (std::size_t k = 0; k < kSurfaces.size(); ++k) {
    if (!needs.scans(kSurfaces[k])) continue;
    faces[k] = &joint.faces(other(kSurfaces[k]));
    bounds[k].assign(joint.mesh(kSurfaces[k]).vertices.size(), kNoSurface);
  }
  return answer_on_faces(meshes_of(joint), needs, faces, [&](Surface of, std::size_t vertex, const Vec3& x) {
    const std::size_t k = of == Surface::ball ? 0 : 1;
    const CertifiedGap ends = measured_gap(of, *faces[k], x);
    if (ends.cover == Cover::none) return kNoSurface;
    const double gap = likely_gap(of, *faces[k], x, ends);
    const double bound = std::max(ends.high - gap, gap - ends.low);
    if (asked.max_error_mm && bound > *asked.max_error_mm) {
      throw std::runtime_error(
          formatted("max_error: %g mm is less than rounding leaves of the gap of %s vertex %zu, %.2g mm; ask "
                    "for a larger error",
                    *asked.max_error_mm, name(of).data(), vertex, bound));
    }
    bounds[k][vertex] = bound;
    return gap;
  });
}

GapsAnswer by_faces(SessionJoint& joint, const GapsRequest& asked) {
  const Pose pose = pose_of(joint, asked.pose);
  VertexBounds bounds;
  SceneAnswer scene = answer_of_faces(joint, asked, pose, bounds);
  GapsAnswer result = answer_of_scene(joint, asked, pose, std::move(scene));
  result.way = kFaces;
  if (!asked.asks_bounds()) return result;
  result.ball.bound = std::move(bounds[0]);
  result.socket.bound = std::move(bounds[1]);
  return result;
}

// Distances between the meshes themselves, whatever the table.
void measure_distances(const SessionJoint& joint, GapsAnswer& result) {
  on_threads(kSurfaces.size(), [&](std::size_t k) {
    const Surface of = kSurfaces[k];
    std::vector<DistanceBracket>& distance = result.of(of).distance;
    distance = EuclideanDistance(joint.mesh(other(of))).at(places_in_other(joint, result.pose, of));
    std::vector<bool> of_face(distance.size(), false);  // edge-on ones too
    for (const Face& face : joint.mesh(of).faces)
      for (const VertexIndex v : face) of_face[v] = true;
    for (std::size_t v = 0; v < of_face.size(); ++v)
      if (!of_face[v]) distance[v] = {kNoSurface, kNoSurface};
  });
}

// Gaps between the main surfaces.
GapsAnswer measure_main(Session& session, const GapsRequest& asked) {
  SessionJoint& joint = *session.joint;
  const bool bounds = asked.asks_bounds();
  GapsAnswer result = !asked.by_tables() ? by_faces(joint, asked)
                      : bounds           ? by_whole_tables(session, asked)
                                         : by_partial_tables(joint, asked);
  if (bounds) result.error_bound = verdicts_of(joint, result);
  if (asked.asks(Output::verdicts)) {
    result.radial_overlap =
        certify({joint.mesh(Surface::ball), joint.mesh(Surface::socket)}, result.pose,
                {result.ball.gap, result.ball.bound}, {result.socket.gap, result.socket.bound});
  }
  return result;
}

// Gaps of a joint with parts; the vertices of parts come after those of the main surface.
GapsAnswer measure_with_parts(Session& session, const GapsRequest& asked) {
  SessionJoint& joint = *session.joint;
  Session alone(without_parts(joint.joint), joint.side, joint.joint.axes);
  alone.tables.settings = session.tables.settings;
  GapsAnswer result = measure_main(alone, asked);
  for (const Surface of : kSurfaces) {
    SurfaceAnswer& answer = result.of(of);
    for (std::vector<double>* values : {&answer.gap, &answer.bound, &answer.against_cartilage}) {
      if (!values->empty()) values->resize(joint.mesh(of).vertices.size(), kNoSurface);
    }
  }
  if (asked.asks(Output::distances) || asked.asks(Output::verdicts))
    result.nearest_part = nearest_part(joint, result.pose);
  return result;
}

void say_what_is_left_out(const Joint& joint, const GapsRequest& asked, std::vector<LeftOut>& left_out) {
  const auto add = [&](const char* what, const char* meaning, const char* reason) {
    left_out.push_back({what, meaning, reason});
  };
  constexpr const char* kNotAsked = "not asked for";
  if (!asked.asks_bounds()) add("error_bounds", "no bounds of single gaps", kNotAsked);
  if (!asked.asks(Output::distances)) add("distances", "no Euclidean distances", kNotAsked);
  if (!asked.asks(Output::verdicts)) add("exact_verdicts", "no exact verdicts", kNotAsked);
  if (joint.ball.star_shape.edge_on + joint.socket.star_shape.edge_on > 0)
    add("edge_on_faces", "faces whose plane holds the centre: they cover no direction", "");
}

}  // namespace

GapsAnswer answer(Session& session, const GapsRequest& request) {
  request.check();
  shift_ball(session, Vec3::Zero());
  SessionJoint& joint = *session.joint;
  GapsAnswer result =
      joint.joint.has_parts() ? measure_with_parts(session, request) : measure_main(session, request);
  if (request.asks(Output::verdicts))
    result.contact = contact_of(joint.joint, joint.bodies().verdict(result.pose));
  if (request.asks(Output::distances)) measure_distances(joint, result);
  if (auto& smallest = result.smallest_gap) {
    const SurfaceAnswer& of = result.of(smallest->surface);
    if (!of.bound.empty()) smallest->error_bound_mm = of.bound[smallest->vertex];
    if (!of.distance.empty()) {
      const DistanceBracket& distance = of.distance[smallest->vertex];
      smallest->euclidean_distance_mm = {distance.lower_mm, distance.upper_mm};
    }
  }
  say_what_is_left_out(joint.joint, request, result.left_out);
  return result;
}

}  // namespace impinge
