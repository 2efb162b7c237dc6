// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "20_claims/claims_study.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/local_refill.hpp"
#include "sphere/schemes/rsid.hpp"

namespace impinge::lab {
namespace {

constexpr double kDepth = 0.5;  // mm, that the middle of the cap moves in

// Vertices within the cap move towards the centre, less towards its border.
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

}  // namespace

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

}  // namespace impinge::lab
