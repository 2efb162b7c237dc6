// SPDX-License-Identifier: GPL-3.0-or-later
#include "20_claims/claims_study.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <memory>
#include <stdexcept>

#include <Eigen/Geometry>
#include <benchmark/benchmark.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/face_crossings.hpp"
#include "methods/local_refill.hpp"
#include "reference/exact_radius.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge::lab {
namespace {

constexpr double kThickness = 2.0;  // mm of cartilage on the ball, along the normal of the bone

// The outer surface of a layer: each vertex moved along the mean normal of its faces.
TriangleMesh outer_layer(const TriangleMesh& bone) {
  std::vector<Vec3> normal(bone.vertices.size(), Vec3::Zero());
  for (const Face& face : bone.faces) {
    for (const VertexIndex v : face) normal[v] += area_vector(bone, face);
  }
  TriangleMesh layer = bone;
  for (std::size_t v = 0; v < normal.size(); ++v) layer.vertices[v] += kThickness * normal[v].normalized();
  return layer;
}

struct LayerSurfaces {
  const TriangleMesh& bone;
  const TriangleMesh& cartilage;
};

// Distance of the outer surface from the radius of the bone plus the thickness, along unit vectors.
void add_differences(ClaimsStudy& study, const std::string& setting, const LayerSurfaces& layers,
                     const std::vector<Vec3>& directions) {
  const char* claim = "several layers";
  const std::vector<double> inner = exact_radii(layers.bone, {directions, Layer::farthest});
  const std::vector<double> outer = exact_radii(layers.cartilage, {directions, Layer::farthest});
  double squares = 0.0;
  double largest = 0.0;
  std::size_t apart = 0;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const double off = std::abs(outer[i] - inner[i] - kThickness);
    squares += off * off;
    largest = std::max(largest, off);
    apart += off > 0.1 ? 1U : 0U;
  }
  const auto count = static_cast<double>(inner.size());
  study.rows.push_back({claim, setting, "distance added, largest error", largest, "mm"});
  study.rows.push_back({claim, setting, "distance added, rms error", std::sqrt(squares / count), "mm"});
  study.rows.push_back(
      {claim, setting, "vertices off by above 0.1 mm", 100.0 * static_cast<double>(apart) / count, "%"});
}

// Adds this for the directions of all of the ball's vertices, and for those in which the socket is met.
void add_differences(ClaimsStudy& study, const std::string& name, const Hip& hip,
                     const TriangleMesh& cartilage) {
  const std::vector<Vec3>& all = hip.ball.vertices;
  const std::vector<double> socket = exact_radii(hip.socket, {all, Layer::nearest});
  std::vector<Vec3> facing;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!std::isnan(socket[i])) facing.push_back(all[i]);
  }
  const LayerSurfaces layers{hip.ball, cartilage};
  add_differences(study, name + " hip, whole ball", layers, all);
  add_differences(study, name + " hip, under the socket", layers, facing);
}

constexpr double kDepth = 0.5;  // mm that the middle of the cap moves inwards

// Moves the vertices within the cap towards the centre, less towards its border.
TriangleMesh dented(TriangleMesh mesh, double cap_deg) {
  const Vec3 middle = mesh.vertices[mesh.vertices.size() / 3].normalized();
  for (Vec3& v : mesh.vertices) {
    const double share = angle_between(v, middle) / (cap_deg * kDegree);
    if (share < 1.0) v *= 1.0 - kDepth * std::pow(std::cos(0.5 * kPi * share), 2) / v.norm();
  }
  return mesh;
}

bool same_bits(const RadialTable<Rsid>& a, const RadialTable<Rsid>& b) {
  return std::memcmp(a.radii().data(), b.radii().data(), a.radii().size_bytes()) == 0;
}

struct Deforming {
  TriangleMesh before;
  TriangleMesh after;
  RadialTable<Rsid> table;
};

constexpr double kBone = 24.0;       // mm
constexpr double kCartilage = 26.0;  // mm
constexpr double kPressed = 3.0;     // mm, deeper than the cartilage is thick
constexpr double kCap = 25.0;        // degrees, half the width of the cap that is pressed in

// Bone, and cartilage that is pressed in on one side: one mesh whose two layers cross along a ring. The bone
// is turned so that no vertex of one lies under a vertex of the other.
TriangleMesh pressed_cartilage(std::size_t faces) {
  const Vec3 middle = Vec3(0.5, -0.3, 0.6).normalized();
  TriangleMesh mesh = radial_body(faces, [&middle](const Vec3& u) {
    const double share = angle_between(u, middle) / (kCap * kDegree);
    return kCartilage - (share < 1.0 ? kPressed * std::pow(std::cos(0.5 * kPi * share), 2) : 0.0);
  });
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  const TriangleMesh bone = radial_body(faces, [](const Vec3&) { return kBone; });
  const auto shift = static_cast<VertexIndex>(mesh.vertices.size());
  for (const Vec3& v : bone.vertices) mesh.vertices.emplace_back(turn * v);
  for (const Face& f : bone.faces) mesh.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  return mesh;
}

}  // namespace

void add_layers(ClaimsStudy& study, const ClaimsOptions& options) {
  for (const char* name : {"normal", "cam"}) {
    HipParameters parameters = hip_preset(name);
    parameters.shaft_length = 0.0;
    const Hip hip = make_hip(parameters, options.faces);
    add_differences(study, name, hip, outer_layer(hip.ball));
  }
}

std::vector<Column> claims_keys() {
  return {{"claim", "", "of the thesis, Chapter 6"},
          {"setting", "", "of the experiment"},
          {"quantity", "", "what was measured"}};
}

ClaimsTables claims_tables(const ClaimsStudy& study, Progress& progress) {
  ClaimsTables tables;
  tables.timing = run_interleaved(study.cases, {}, progress);
  tables.table.columns = claims_keys();
  tables.table.columns.push_back({"value", "", "in the unit beside it; identical: 1"});
  tables.table.columns.push_back({"unit", "", "of the value"});
  for (const Claim& row : study.rows)
    tables.table.add_row({row.claim, row.setting, row.quantity, row.value, row.unit});
  for (const Timing& timing : tables.timing.timings) {
    std::vector<Cell> row = timing.key;
    row.emplace_back(1e3 * timing.summary.median);
    row.emplace_back("us");
    tables.table.add_row(std::move(row));
  }
  return tables;
}

void add_deforming(ClaimsStudy& study, const ClaimsOptions& options) {
  const char* claim = "deforming surface updated in place";
  const Rsid scheme = Rsid::with_precision(options.precision_deg);
  const TriangleMesh ball = make_ball_socket_pair(options.faces).ball;
  for (const double cap : options.caps) {
    const std::string setting = "cap of " + Cell(cap).text() + " degrees";
    auto work = std::make_shared<Deforming>(
        Deforming{ball, dented(ball, cap), fill_exact(ball, scheme, Layer::farthest)});
    const std::size_t entries = refill(work->before, work->after, Layer::farthest, work->table);
    if (!same_bits(work->table, fill_exact(work->after, scheme, Layer::farthest)))
      throw std::runtime_error(setting + ": the table brought up to date is not the one filled anew");
    refill(work->after, work->before, Layer::farthest, work->table);
    const auto moved = static_cast<double>(changed_faces(work->before, work->after).size());
    study.rows.push_back({claim, setting, "faces changed", moved, "1"});
    study.rows.push_back({claim, setting, "entries worked out", static_cast<double>(entries), "1"});
    study.rows.push_back({claim, setting, "identical", 1.0, "1"});
    TimedCase in_place;
    in_place.key = {claim, setting, "time in place"};
    in_place.units = 2.0;  // there and back
    in_place.rounds = options.rounds;
    in_place.run = [work] {
      refill(work->before, work->after, Layer::farthest, work->table);
      refill(work->after, work->before, Layer::farthest, work->table);
    };
    study.cases.push_back(in_place);
    TimedCase anew;
    anew.key = {claim, setting, "time anew"};
    anew.rounds = options.rounds;
    anew.run = [work, scheme] { benchmark::DoNotOptimize(fill_exact(work->after, scheme, Layer::farthest)); };
    study.cases.push_back(anew);
  }
}

void add_self_collision(ClaimsStudy& study, const ClaimsOptions& options) {
  const char* claim = "self-collision found while sampling";
  const TriangleMesh mesh = pressed_cartilage(options.faces);
  const std::vector<FacePair> crossing = face_crossings(mesh);
  study.rows.push_back({claim, "exact", "pairs crossing", static_cast<double>(crossing.size()), "1"});
  for (const double precision : options.collision_precisions) {
    const Rsid scheme = Rsid::with_precision(precision);
    for (const double tolerance : {0.001, 0.01, 0.1}) {
      const std::string setting =
          Cell(precision).text() + " degrees, within " + Cell(tolerance).text() + " mm";
      const std::vector<FacePair> found = self_collisions(mesh, scheme, tolerance);
      std::vector<FacePair> right;
      std::ranges::set_intersection(found, crossing, std::back_inserter(right));
      const auto share = static_cast<double>(right.size()) / static_cast<double>(crossing.size());
      study.rows.push_back({claim, setting, "crossing pairs found", 100.0 * share, "%"});
      const auto wrong = static_cast<double>(found.size() - right.size());
      study.rows.push_back({claim, setting, "pairs found that do not cross", wrong, "1"});
    }
  }
}

}  // namespace impinge::lab
