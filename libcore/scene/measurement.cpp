// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/measurement.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "detection/formatted.hpp"
#include "detection/gap_scan.hpp"
#include "experiment/machine.hpp"
#include "joint/motion.hpp"
#include "mesh/surface_vertices.hpp"
#include "sampling/direction_bounds.hpp"
#include "sampling/exact_raster.hpp"
#include "sphere/scheme_choice.hpp"

namespace impinge {
namespace {

constexpr std::array kPrecisions{1.0, 0.5, 0.25, 0.1, 0.05, 0.025};  // degrees, for --max-error

class Stopwatch {
 public:
  double lap_ms() {
    const auto now = std::chrono::steady_clock::now();
    const double elapsed = std::chrono::duration<double, std::milli>(now - start_).count();
    start_ = now;
    return elapsed;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Radii and slopes of both surfaces; in floating point, since entries by the 10^18 are asked for at times.
template <SamplingScheme S>
void require_memory(const S& scheme) {
  const double needed = 2.0 * static_cast<double>(scheme.size()) * (sizeof(double) + sizeof(float));
  const auto free = static_cast<double>(available_memory());
  if (needed <= free) return;
  throw std::runtime_error(formatted(
      "tables of %zu entries at %g degrees would take %.0f bytes (%.1f GiB) and %.1f GiB of memory are "
      "free; choose a coarser --precision or a larger --max-error",
      scheme.size(), scheme.precision_deg(), needed, needed / 0x1p30, free / 0x1p30));
}

// A vertex of no face belongs to no surface: it has no gap.
void forget_stray_vertices(const TriangleMesh& mesh, std::vector<double>& gap) {
  const std::vector<bool> used = on_surface(mesh);
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!used[i]) gap[i] = kNoSurface;
  }
}

template <SamplingScheme S>
struct Scans {
  const S& scheme;
  const Joint& joint;
  const Pose& pose;

  // Bound of the error at each vertex, whose direction in the frame of the table is given by `place`. mesh
  // filled the table.
  template <class Place>
  static std::vector<double> bounds(const TriangleMesh& mesh, const RadialTable<S>& table, Layer layer,
                                    const std::vector<Vec3>& vertices, Place&& place) {
    const DirectionBounds direction(mesh, table, layer);
    std::vector<double> bound(vertices.size());
    std::ranges::transform(vertices, bound.begin(), [&](const Vec3& v) { return direction.at(place(v)); });
    return bound;
  }

  Measurement run() const {
    Measurement result;
    result.pose = pose;
    result.precision_deg = scheme.precision_deg();
    result.entries = scheme.size();
    result.bytes = 2 * RadialTable<S>::bytes(scheme);
    const TriangleMesh& ball = joint.ball.mesh;
    const TriangleMesh& socket = joint.socket.mesh;
    result.ball.gap.resize(ball.vertices.size());
    result.socket.gap.resize(socket.vertices.size());
    Stopwatch watch;
    const RadialTable<S> ball_table = fill_exact(ball, scheme, Layer::farthest);
    const RadialTable<S> socket_table = fill_exact(socket, scheme, Layer::nearest);
    result.fill_ms = watch.lap_ms();
    scan_ball(socket_table, ball.vertices, pose, result.ball.gap);
    scan_socket(ball_table, socket.vertices, pose, result.socket.gap);
    result.scan_ms = watch.lap_ms();
    forget_stray_vertices(ball, result.ball.gap);
    forget_stray_vertices(socket, result.socket.gap);
    result.ball.bound = bounds(socket, socket_table, Layer::nearest, ball.vertices,
                               [&](const Vec3& v) { return to_socket(pose, v); });
    result.socket.bound = bounds(ball, ball_table, Layer::farthest, socket.vertices,
                                 [&](const Vec3& v) { return to_ball(pose, v); });
    result.bound_ms = watch.lap_ms();
    return result;
  }
};

template <SamplingScheme S>
Measurement measure_at(double precision_deg, const Joint& joint, const Pose& pose) {
  const S scheme = S::with_precision(precision_deg);
  require_memory(scheme);
  return Scans<S>{scheme, joint, pose}.run();
}

double largest_bound(const Measurement& result) {
  return std::max(largest_bound(result.ball), largest_bound(result.socket));
}

// The coarsest precision that keeps the bound.
template <SamplingScheme S>
Measurement measure_within(double max_error_mm, const Joint& joint, const Pose& pose) {
  double bound = 0.0;
  for (const double precision : kPrecisions) {
    Measurement result = measure_at<S>(precision, joint, pose);
    bound = largest_bound(result);
    if (bound <= max_error_mm) return result;
  }
  throw std::runtime_error(formatted(
      "option --max-error: %g mm cannot be promised at every vertex, the proven bound at %g degrees "
      "is %g mm; ask for a larger error, or choose --precision instead",
      max_error_mm, kPrecisions.back(), bound));
}

// They are those of the meshes, whatever the table.
void bracket_distances(const Joint& joint, Measurement& result) {
  Stopwatch watch;
  const EuclideanBracket ball(joint.ball.mesh);
  const EuclideanBracket socket(joint.socket.mesh);
  for (const Vec3& v : joint.ball.mesh.vertices)
    result.ball.distance.push_back(socket.at(to_socket(result.pose, v)));
  for (const Vec3& v : joint.socket.mesh.vertices)
    result.socket.distance.push_back(ball.at(to_ball(result.pose, v)));
  result.distance_ms = watch.lap_ms();
}

Pose pose_of(const SceneOptions& options) {
  const Eigen::Matrix3d axes = input_to_joint(options.axes);
  return {axes.transpose() * joint_rotation(options.motion, options.side) * axes, Vec3::Zero()};
}

SceneNeeds needs_of(const SceneOptions& options, const Pose& pose) {
  return {options.question, options.scan_ball, options.scan_socket, {pose}, options.max_error_mm};
}

// Never called: all omissions are on, so that no whole table is wanted.
std::unique_ptr<RadiusSource> no_full_table(const TriangleMesh& /*mesh*/, Layer /*layer*/) {
  throw std::logic_error("a plan that leaves out entries asks for a whole table");
}

// A table that keeps few entries still has a directory of all of them.
AnyScheme partly_kept(const SceneOptions& options) {
  constexpr double kDirectory = 2.0 * 4.0 / 4096.0;  // bytes an entry, both tables
  AnyScheme scheme(options.scheme, options.precision_deg);
  const double needed = kDirectory * static_cast<double>(scheme.size());
  const auto free = static_cast<double>(available_memory());
  if (needed <= free) return scheme;
  throw std::runtime_error(formatted(
      "tables of %zu entries at %g degrees would take more than %.0f bytes (%.1f GiB) and %.1f GiB of "
      "memory are free; choose a coarser --precision",
      scheme.size(), scheme.precision_deg(), needed, needed / 0x1p30, free / 0x1p30));
}

// The gaps alone.
Measurement measure_gaps(const Joint& joint, const SceneOptions& options, const Pose& pose) {
  Measurement result;
  result.pose = pose;
  Stopwatch watch;
  const AnyScheme scheme = partly_kept(options);
  SceneAnswer answer = answer_scene({joint.ball.mesh, joint.socket.mesh}, needs_of(options, pose), scheme,
                                    Omissions::all(), no_full_table, &result.left_out);
  result.precision_deg = scheme.precision_deg();
  result.entries = scheme.size();
  result.bytes = answer.cost.bytes;
  result.way = std::move(answer.path.reason);
  result.ball.gap = std::move(answer.gaps.front().ball);
  result.socket.gap = std::move(answer.gaps.front().socket);
  result.scan_ms = watch.lap_ms();
  return result;
}

// Whole tables. Without times, which are in a summary's times_ms: the rest of it is the same in every run.
constexpr const char* kWholeTables =
    "whole tables, filled and scanned in double: fill_tables and scan in times_ms of summary.json are the "
    "most that faster kernels could save";

// What was not asked for, in words.
void say_left_out(const SceneOutputs& outputs, Measurement& result) {
  if (!outputs.bounds && !outputs.verdicts)
    result.left_out.push_back({Omission::error_bounds, "not asked for", 0.0});
  if (!outputs.distances) result.left_out.push_back({Omission::distances, "not asked for", 0.0});
  if (!outputs.verdicts) result.left_out.push_back({Omission::exact_verdicts, "not asked for", 0.0});
}

}  // namespace

double largest_bound(const SurfaceGaps& gaps) {
  double largest = 0.0;
  for (std::size_t i = 0; i < gaps.gap.size(); ++i) {
    if (!std::isnan(gaps.gap[i])) largest = std::max(largest, gaps.bound[i]);
  }
  return largest;
}

Measurement measure(const Joint& joint, const SceneOptions& options) {
  const Pose pose = pose_of(options);
  const SceneOutputs& outputs = options.outputs;
  Measurement result;
  if (!outputs.bounds && !outputs.verdicts) {
    result = measure_gaps(joint, options, pose);
  } else {
    with_scheme(options.scheme, [&]<class S>() {
      result = options.max_error_mm ? measure_within<S>(*options.max_error_mm, joint, pose)
                                    : measure_at<S>(options.precision_deg, joint, pose);
    });
  }
  if (outputs.distances) bracket_distances(joint, result);
  if (outputs.verdicts) {
    result.certificate =
        certify({joint.ball.mesh, joint.socket.mesh}, pose, {result.ball.gap, result.ball.bound},
                {result.socket.gap, result.socket.bound});
  }
  if (result.way.empty()) result.way = kWholeTables;
  say_left_out(outputs, result);
  return result;
}

QuestionAnswer answer_question(const Joint& joint, const SceneOptions& options) {
  QuestionAnswer found;
  found.pose = pose_of(options);
  Stopwatch watch;
  found.answer = answer_scene({joint.ball.mesh, joint.socket.mesh}, needs_of(options, found.pose),
                              partly_kept(options), Omissions::all(), no_full_table, &found.left_out);
  found.milliseconds = watch.lap_ms();
  return found;
}

}  // namespace impinge
