// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "20_claims/claims_study.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "reference/exact_radius.hpp"

namespace impinge::lab {
namespace {

constexpr double kThickness = 2.0;  // mm of cartilage on the ball, square to the bone

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

// How far the outer surface is from where a distance added to the radius of the bone puts it, in directions
// of unit vectors.
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

// Directions of the ball's vertices: all of them, and those in which the socket is met.
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

}  // namespace

void add_layers(ClaimsStudy& study, const ClaimsOptions& options) {
  for (const char* name : {"normal", "cam"}) {
    HipParameters parameters = hip_preset(name);
    parameters.shaft_length = 0.0;
    const Hip hip = make_hip(parameters, options.faces);
    add_differences(study, name, hip, outer_layer(hip.ball));
  }
}

}  // namespace impinge::lab
