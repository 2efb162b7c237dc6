// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/measurement.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "files/formatted.hpp"
#include "files/memory.hpp"
#include "files/stopwatch.hpp"
#include "files/thread_team.hpp"
#include "gap/exact_side.hpp"
#include "gap/measured_gap.hpp"
#include "gap/overlay.hpp"
#include "motion/body_pairs.hpp"
#include "motion/euclidean_distance.hpp"
#include "sphere/infinity.hpp"
#include "sphere/scheme_choice.hpp"

namespace impinge {
namespace {

// How the gaps of whole tables were found. Without times, which are in a summary's times_ms: the rest of it
// is the same in every run.
constexpr const char* kWholeTables =
    "whole tables, filled and scanned in double: fill_tables and scan in times_ms of summary.json are the "
    "most that faster kernels could save";

// std::runtime_error, one line with the bytes and the cure, where tables of both surfaces do not fit in
// memory. Bytes in floating point, since entries by the 10^18 are asked for at times.
void require_memory(std::size_t entries, double precision_deg, double bytes_an_entry, const char* more) {
  const double bytes = 2.0 * bytes_an_entry * static_cast<double>(entries);
  const auto free = static_cast<double>(available_memory());
  if (bytes <= free) return;
  throw std::runtime_error(
      formatted("tables of %zu entries at %g degrees would take %s%.0f bytes (%.1f GiB) and %.1f GiB of "
                "memory are free; choose a coarser --precision",
                entries, precision_deg, more, bytes, bytes / 0x1p30, free / 0x1p30));
}

// A table that keeps few entries still has a directory of all of them.
AnyScheme partly_kept(const PoseQuestion& asked) {
  AnyScheme scheme(asked.scheme, asked.precision_deg.value_or(kUsualPrecision));
  require_memory(scheme.size(), scheme.precision_deg(), 4.0 / 4096.0, "more than ");
  return scheme;
}

SceneAnswer planned(const SessionJoint& joint, const PoseQuestion& asked, const Pose& pose,
                    const AnyScheme& scheme) {
  return answer_scene({joint.mesh(Surface::ball), joint.mesh(Surface::socket)},
                      {asked.question, asked.scan_ball, asked.scan_socket, {pose}, asked.max_error_mm},
                      scheme);
}

Measurement by_whole_tables(Session& session, const PoseQuestion& asked) {
  double precision_deg = 0.0;
  with_scheme(asked.scheme, [&]<class S>() {
    constexpr double kEntry = sizeof(double) + sizeof(float);  // radius and slope
    const S scheme = S::with_precision(*asked.precision_deg);
    precision_deg = scheme.precision_deg();
    require_memory(scheme.size(), *asked.precision_deg, kEntry, "");
  });
  fill_tables(session, {.scheme = asked.scheme,
                        .precision_deg = *asked.precision_deg,
                        .storage = Storage::double_precision,
                        .flat_cube = false,
                        .halvings = 1'000'000});
  Measurement result;
  static_cast<PoseAnswer&>(result) = answer_pose(session, {asked.motion, Vec3::Zero(), asked.cartilage_mm});
  result.way = kWholeTables;
  result.precision_deg = precision_deg;
  result.entries = session.tables.ball->entries();
  result.bytes = 2 * result.entries * sizeof(double);
  result.fill_ms = session.tables.fill_ms;
  Stopwatch watch;
  bound_gaps(session, result);
  result.bound_ms = watch.lap_ms();
  return result;
}

Measurement by_plan(const SessionJoint& joint, const PoseQuestion& asked) {
  Stopwatch watch;
  const Pose pose = pose_of(joint, asked.motion);
  const AnyScheme scheme = partly_kept(asked);
  SceneAnswer answer = planned(joint, asked, pose, scheme);
  const double scan_ms = watch.lap_ms();
  PoseGaps& gaps = answer.gaps.front();
  Measurement result;
  static_cast<PoseAnswer&>(result) =
      answer_of_gaps(joint, pose, std::move(gaps.ball), std::move(gaps.socket), asked.cartilage_mm);
  result.scan_ms = scan_ms;
  result.precision_deg = asked.max_error_mm ? 0.0 : scheme.precision_deg();
  result.entries = asked.max_error_mm ? answer.cost.entries : scheme.size();
  result.bytes = answer.cost.bytes;
  result.way = std::move(answer.way);
  result.left_out = std::move(answer.left_out);
  return result;
}

// Gaps of the vertices of one surface, measured on the faces of the other one, and what they are off by at
// most; none of a surface that is not asked for.
struct MeasuredScan {
  std::vector<double> gap;    // mm, NaN where there is none
  std::vector<double> bound;  // mm, NaN with it
};

bool is_scanned(const PoseQuestion& asked, Surface of) {
  return of == Surface::ball ? asked.scan_ball : asked.scan_socket;
}

// The middle of the ends, or the gap as tables have it where a face is nearly edge-on, so that these are far
// apart.
double likely_gap(Surface of, const NearFaces& faces, const Vec3& x, const CertifiedGap& ends) {
  constexpr double kApart = 1e-6;  // mm
  const double middle = 0.5 * (ends.low + ends.high);
  if (ends.high - ends.low < kApart) return middle;
  const double radius = faces.radius(x.normalized(), facing_layer(other(of)));
  return std::isnan(radius) ? middle : signed_gap(of, radius, x.norm());
}

MeasuredScan measured_scan(SessionJoint& joint, const PoseQuestion& asked, const Pose& pose, Surface of) {
  MeasuredScan scan;
  if (!is_scanned(asked, of)) return scan;
  const NearFaces& faces = joint.faces(other(of));
  const std::vector<Vec3> places = places_in_other(joint, pose, of);
  scan.gap.assign(places.size(), kNoSurface);
  scan.bound = scan.gap;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!joint.part(of).used[i]) continue;
    const CertifiedGap ends = measured_gap(of, faces, places[i]);
    if (ends.cover == Cover::none) continue;
    scan.gap[i] = likely_gap(of, faces, places[i], ends);
    scan.bound[i] = std::max(ends.high - scan.gap[i], scan.gap[i] - ends.low);
  }
  return scan;
}

// Is some vertex of the surface impinged? Exact.
bool some_impinged(SessionJoint& joint, const Pose& pose, Surface of) {
  const NearFaces& faces = joint.faces(other(of));
  const std::vector<Vec3> places = places_in_other(joint, pose, of);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (joint.part(of).used[i] && exactly_impinged(of, faces, places[i])) return true;
  }
  return false;
}

std::string way_of_faces(const SessionJoint& joint) {
  const std::size_t vertices =
      joint.mesh(Surface::ball).vertices.size() + joint.mesh(Surface::socket).vertices.size();
  const AnyScheme spared(PoseQuestion{}.scheme, kUsualPrecision);
  return formatted(
      "each of the %zu vertices is measured on the faces near it, for one pose: this saves tables of "
      "%zu entries and the search for their bounds",
      vertices, 2 * spared.size());
}

Measurement by_faces(SessionJoint& joint, const PoseQuestion& asked) {
  Stopwatch watch;
  const Pose pose = pose_of(joint, asked.motion);
  MeasuredScan ball = measured_scan(joint, asked, pose, Surface::ball);
  MeasuredScan socket = measured_scan(joint, asked, pose, Surface::socket);
  const double scan_ms = watch.lap_ms();
  Measurement result;
  static_cast<PoseAnswer&>(result) =
      answer_of_gaps(joint, pose, std::move(ball.gap), std::move(socket.gap), asked.cartilage_mm);
  result.scan_ms = scan_ms;
  result.way = way_of_faces(joint);
  if (!asked.outputs.bounds && !asked.outputs.verdicts) return result;
  result.ball.bound = std::move(ball.bound);
  result.socket.bound = std::move(socket.bound);
  return result;
}

// Touch by exact signs: of both surfaces edges and all, of one of its vertices. The smallest gap by the
// faces.
SceneAnswer question_by_faces(SessionJoint& joint, const PoseQuestion& asked, const Pose& pose) {
  SceneAnswer answer;
  answer.way = way_of_faces(joint);
  const bool touch = asked.question == Question::touch;
  if (touch) answer.touches.assign(1, false);
  if (touch && asked.scan_ball && asked.scan_socket) {
    answer.way = "both surfaces are compared, edges and all, by exact signs";
    const BallSocketPair main{joint.main(Surface::ball), joint.main(Surface::socket)};
    answer.touches[0] = SurfaceOverlay(main.ball, main.socket).impinged(pose) ||
                        BodyPairs(main, joint.beside()).impinged(pose);
    return answer;
  }
  for (const Surface of : kSurfaces) {
    if (!is_scanned(asked, of)) continue;
    answer.cost.look_ups += joint.mesh(of).vertices.size();
    if (touch) {
      answer.touches[0] = answer.touches[0] || some_impinged(joint, pose, of);
      continue;
    }
    const std::vector<double> gap = measured_scan(joint, asked, pose, of).gap;
    for (std::size_t i = 0; i < gap.size(); ++i) {
      if (gap[i] < (answer.smallest ? answer.smallest->gap_mm : kInfinity))
        answer.smallest = SmallestGap{gap[i], of, 0, i};
    }
  }
  return answer;
}

// The bound of each gap is how far it can be from that of the faces. std::runtime_error where that is above
// what was promised.
void bound_on_faces(SessionJoint& joint, double promised, Measurement& result) {
  Stopwatch watch;
  for (const Surface of : kSurfaces) {
    const NearFaces& faces = joint.faces(other(of));
    const std::vector<Vec3> places = places_in_other(joint, result.pose, of);
    SurfaceAnswer& scan = result.of(of);
    for (std::size_t i = 0; i < scan.gap.size(); ++i) {
      const CertifiedGap exact = measured_gap(of, faces, places[i]);
      scan.bound.push_back(std::max(scan.gap[i] - exact.low, exact.high - scan.gap[i]));
      if (!(scan.bound.back() > promised)) continue;
      throw std::runtime_error(formatted(
          "option --max-error: %g mm is less than rounding leaves of the gap of %s vertex %zu, %.2g mm; ask "
          "for a larger error",
          promised, name(of).data(), i, scan.bound.back()));
    }
  }
  result.bound_ms = watch.lap_ms();
}

// They are those of the meshes, whatever the table.
void measure_distances(const SessionJoint& joint, Measurement& result) {
  Stopwatch watch;
  on_threads(kSurfaces.size(), [&](std::size_t k) {
    const Surface of = kSurfaces[k];
    const EuclideanDistance distance(joint.mesh(other(of)));
    for (const Vec3& x : places_in_other(joint, result.pose, of))
      result.of(of).distance.push_back(distance.at(x));
  });
  result.distance_ms = watch.lap_ms();
}

// What was not asked for, in words.
void say_left_out(const PoseOutputs& outputs, Measurement& result) {
  if (!outputs.bounds && !outputs.verdicts)
    result.left_out.push_back({Omission::error_bounds, "not asked for", 0.0});
  if (!outputs.distances) result.left_out.push_back({Omission::distances, "not asked for", 0.0});
  if (!outputs.verdicts) result.left_out.push_back({Omission::exact_verdicts, "not asked for", 0.0});
}

// About the centre that it is seen from.
Session without_parts(const SessionJoint& joint) {
  Session alone(impinge::without_parts(joint.joint), joint.side, joint.joint.axes);
  alone.joint->shift_to(joint.shift);
  return alone;
}

// Of the main surfaces.
Measurement measure_main(Session& session, const PoseQuestion& asked) {
  SessionJoint& joint = *session.joint;
  const PoseOutputs& outputs = asked.outputs;
  const bool bounds = outputs.bounds || outputs.verdicts;
  const bool whole = bounds && !asked.max_error_mm;
  Measurement result = !asked.by_tables() ? by_faces(joint, asked)
                       : whole            ? by_whole_tables(session, asked)
                                          : by_plan(joint, asked);
  if (bounds && asked.max_error_mm) bound_on_faces(joint, *asked.max_error_mm, result);
  if (bounds) result.proven = verdicts_of(joint, result);
  if (outputs.verdicts) {
    result.certificate =
        certify({joint.mesh(Surface::ball), joint.mesh(Surface::socket)}, result.pose,
                {result.ball.gap, result.ball.bound}, {result.socket.gap, result.socket.bound});
  }
  return result;
}

NearestPart nearest_part(const SessionJoint& joint, const Pose& pose) {
  const BodyPairs bodies({joint.main(Surface::ball), joint.main(Surface::socket)}, joint.beside());
  const BodyPairs::Nearest found = bodies.nearest(pose).value();
  return {found.distance_mm, found.touch, body_name(joint.joint.ball.parts, found.pair.ball),
          body_name(joint.joint.socket.parts, found.pair.socket)};
}

// Vertices of parts lie behind those of the main surface.
Measurement measure_with_parts(Session& session, const PoseQuestion& asked) {
  const SessionJoint& joint = *session.joint;
  Session alone = without_parts(joint);
  alone.tables.settings = session.tables.settings;
  Measurement result = measure_main(alone, asked);
  for (const Surface of : kSurfaces) {
    SurfaceAnswer& answer = result.of(of);
    for (std::vector<double>* values : {&answer.gap, &answer.bound, &answer.against_cartilage}) {
      if (!values->empty()) values->resize(joint.mesh(of).vertices.size(), kNoSurface);
    }
  }
  result.part = nearest_part(joint, result.pose);
  return result;
}

}  // namespace

Measurement measure(Session& session, const PoseQuestion& asked) {
  Measurement result =
      session.joint->joint.has_parts() ? measure_with_parts(session, asked) : measure_main(session, asked);
  if (asked.outputs.distances) measure_distances(*session.joint, result);
  say_left_out(asked.outputs, result);
  return result;
}

QuestionAnswer answer_question(SessionJoint& joint, const PoseQuestion& asked) {
  if (joint.joint.has_parts() && asked.question != Question::touch)
    return answer_question(*without_parts(joint).joint, asked);
  if (asked.by_tables() || !asked.scan_ball || !asked.scan_socket)
    require_no_parts(joint.joint, "touch of vertices");
  QuestionAnswer found;
  found.pose = pose_of(joint, asked.motion);
  Stopwatch watch;
  found.answer = asked.by_tables() ? planned(joint, asked, found.pose, partly_kept(asked))
                                   : question_by_faces(joint, asked, found.pose);
  found.milliseconds = watch.lap_ms();
  return found;
}

}  // namespace impinge
