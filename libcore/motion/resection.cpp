// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/resection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "mesh/split_faces.hpp"
#include "mesh/star_shape.hpp"
#include "sphere/infinity.hpp"

namespace impinge {
namespace {

constexpr double kVolumeSlack = 1e-9;  // of volumes and areas
constexpr int kMostRounds = 40;

// Signed volume of the cone over a face, mm^3.
double cone_volume(const TriangleMesh& mesh, const Face& face) {
  return corner(mesh, face, 0).dot(corner(mesh, face, 1).cross(corner(mesh, face, 2))) / 6.0;
}

// What is known of one face.
struct Leaf {
  bool cut = false;   // may some of it have to go?
  double keep = 0.0;  // mm, a radius that may stay everywhere
  RaySpans may_go;    // of a least cut
  Ends volume;        // mm^3, signed
  Ends area;          // mm^2
  Ends depth;         // mm, along one ray
};

// A face as the centre sees it.
struct SeenLeaf {
  SeenLeaf(const TriangleMesh& mesh, const Face& face) : seen(face_cap(corners_of(mesh, face))) {
    if (seen.side == 0) return;  // edge-on: it covers no direction
    cap = {seen.cap.axis, seen.small() ? seen.cap.radius : kPi};
    cone = std::abs(cone_volume(mesh, face));
    angle = std::abs(solid_angle(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)));
    area = 0.5 * area_vector(mesh, face).norm();
  }
  FaceCap seen;
  DirectionCap cap;
  double cone = 0.0;   // mm^3
  double angle = 0.0;  // steradians
  double area = 0.0;   // mm^2
};

// What goes of the cone over a face, up to its largest radius. What stays below the face is known too, and
// what its cone holds exactly.
Leaf leaf_of(const SeenLeaf& face, const SpansOverCap& goes) {
  constexpr double kMore = 1.0 + kVolumeSlack;
  constexpr double kLess = 1.0 - kVolumeSlack;
  const auto& [low, high] = face.seen.range;
  const auto cone_to = [&](double radius) { return face.angle * radius * radius * radius / 3.0; };
  const double most_kept = (cone_to(high) - face.angle * goes.certain.volume(high)) * kMore;
  const double least_kept = (cone_to(low) - face.angle * goes.possible.volume(low)) * kLess;
  Leaf leaf;
  leaf.cut = goes.possible.meets(0.0, high);
  const Ends volume{
      std::max(face.angle * goes.certain.volume(low) * kLess, face.cone * kLess - most_kept),
      std::min(face.angle * goes.possible.volume(high) * kMore, face.cone * kMore - least_kept)};
  leaf.volume = face.seen.side > 0 ? volume : Ends{-volume.high, -volume.low};
  leaf.area = {goes.certain.holds(low, high) ? face.area * kLess : 0.0,
               goes.possible.meets(low, high) ? face.area * kMore : 0.0};
  leaf.depth = {goes.certain.length(0.0, low), goes.possible.length(0.0, high)};
  return leaf;
}

Leaf radial_leaf(const SeenLeaf& face, const SweptRadius& swept, double clearance) {
  if (face.seen.side == 0) return {};
  const double farthest = face.seen.range.high;
  const Ends swept_over = swept.over(face.cap, farthest + clearance);
  Leaf leaf;
  leaf.keep = swept_over.low - clearance;
  if (leaf.keep >= farthest) return leaf;
  SpansOverCap goes;
  goes.possible.add(std::max(0.0, leaf.keep), farthest);
  goes.certain.add(std::max(0.0, swept_over.high - clearance), farthest);
  const double keep = leaf.keep;
  leaf = leaf_of(face, goes);
  leaf.keep = keep;
  return leaf;
}

Leaf least_leaf(const SeenLeaf& face, const SweptBone& swept) {
  if (face.seen.side == 0) return {};
  SpansOverCap goes = swept.over(face.cap, face.seen.range.high);
  Leaf leaf = leaf_of(face, goes);
  leaf.may_go = std::move(goes.possible);
  return leaf;
}

double width(const Ends& ends) { return ends.high - ends.low; }

// The leaves with the largest doubts that hold half of all together (Doerfler 1996, "A convergent adaptive
// algorithm for Poisson's equation").
std::vector<bool> most_doubtful(const std::vector<double>& doubts) {
  const double all = std::accumulate(doubts.begin(), doubts.end(), 0.0);
  std::vector<std::size_t> order(doubts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return doubts[a] > doubts[b]; });
  std::vector<bool> marked(doubts.size(), false);
  double held = 0.0;
  for (std::size_t k = 0; k < order.size() && held < 0.5 * all; ++k) {
    marked[order[k]] = true;
    held += doubts[order[k]];
  }
  return marked;
}

// Of all leaves; what is between the ends of each does not cancel.
struct Total {
  Ends volume;
  Ends area;
};
Total total_of(const std::vector<Leaf>& leaves) {
  Total total;
  for (const Leaf& leaf : leaves) {
    total.volume.low += leaf.volume.low;
    total.volume.high += leaf.volume.high;
    total.area.low += leaf.area.low;
    total.area.high += leaf.area.high;
  }
  return total;
}

// How much each leaf adds to what is not known, in mm^3: a doubtful area counts with the mean depth, and
// less, since area is asked for less closely. Empty where all is known well enough.
std::vector<double> doubts_of(const std::vector<Leaf>& leaves, const CutQuestion& question) {
  constexpr double kAreaWeight = 0.25;
  const Total total = total_of(leaves);
  const double depth = total.volume.high / std::max(total.area.high, 1e-9);
  const bool volume =
      width(total.volume) > std::max(question.least_mm3, question.closeness * total.volume.low);
  const bool area =
      kAreaWeight * width(total.area) > std::max(question.least_mm3, question.closeness * total.area.low);
  if (!volume && !area) return {};
  std::vector<double> doubts;
  doubts.reserve(leaves.size());
  for (const Leaf& leaf : leaves)
    doubts.push_back(width(leaf.volume) + (area ? kAreaWeight * depth * width(leaf.area) : 0.0));
  return doubts;
}

// Cuts the leaves and asks again for those that are new.
void split(TriangleMesh& mesh, std::vector<Leaf>& leaves, const std::vector<bool>& marked, const auto& ask) {
  SplitFaces split = split_faces(mesh, marked);
  std::vector<Leaf> finer;
  finer.reserve(split.mesh.faces.size());
  for (std::size_t f = 0; f < split.mesh.faces.size(); ++f) {
    const std::size_t parent = split.parent[f];
    const bool same = split.mesh.faces[f] == mesh.faces[parent];
    finer.push_back(same ? leaves[parent] : ask(split.mesh, split.mesh.faces[f]));
  }
  mesh = std::move(split.mesh);
  leaves = std::move(finer);
}

// Cuts a mesh in leaves until enough is known of them.
std::vector<Leaf> leaves_of(TriangleMesh& mesh, const CutQuestion& question, const auto& ask) {
  std::vector<Leaf> leaves;
  for (const Face& face : mesh.faces) leaves.push_back(ask(mesh, face));
  const std::size_t most_faces = mesh.faces.size() + question.most_new_faces;
  for (int round = 0; round < kMostRounds && mesh.faces.size() < most_faces; ++round) {
    const std::vector<double> doubts = doubts_of(leaves, question);
    if (doubts.empty()) break;
    split(mesh, leaves, most_doubtful(doubts), ask);
  }
  return leaves;
}

void sum_up(const std::vector<Leaf>& leaves, CutSize& found) {
  const Total total = total_of(leaves);
  found.volume_mm3 = {std::max(0.0, total.volume.low), total.volume.high};
  found.area_mm2 = total.area;
  for (const Leaf& leaf : leaves) {
    if (!leaf.cut) continue;
    found.depth_mm.low = std::max(found.depth_mm.low, leaf.depth.low);
    found.depth_mm.high = std::max(found.depth_mm.high, leaf.depth.high);
  }
}

// Draws each corner in to what all leaves round it may keep.
void draw_in(const std::vector<Leaf>& leaves, Resection& found) {
  std::vector<double> keep(found.before.vertices.size(), kInfinity);
  for (std::size_t f = 0; f < leaves.size(); ++f) {
    if (!leaves[f].cut) continue;
    for (const VertexIndex v : found.before.faces[f]) keep[v] = std::min(keep[v], leaves[f].keep);
  }
  found.cut = found.before;
  found.depth.assign(keep.size(), 0.0);
  for (std::size_t v = 0; v < keep.size(); ++v) {
    const double radius = found.before.vertices[v].norm();
    if (!(keep[v] < radius)) continue;
    if (keep[v] <= 0.0)
      throw std::runtime_error("nothing of the ball would be left along some ray; require less");
    found.cut.vertices[v] *= keep[v] / radius * (1.0 - 1e-15);
    found.depth[v] = radius - keep[v];
  }
  found.deepest = static_cast<std::size_t>(std::ranges::max_element(found.depth) - found.depth.begin());
  for (const Face& face : found.before.faces)
    found.cut_mm3 += cone_volume(found.before, face) - cone_volume(found.cut, face);
}

}  // namespace

Resection least_radial_cut(const TriangleMesh& ball, const SweptRadius& swept, const CutQuestion& question) {
  Resection found;
  found.before = ball;
  const auto leaves = leaves_of(found.before, question, [&](const TriangleMesh& mesh, const Face& face) {
    return radial_leaf(SeenLeaf(mesh, face), swept, question.clearance_mm);
  });
  sum_up(leaves, found);
  draw_in(leaves, found);
  return found;
}

LeastCut least_cut(const TriangleMesh& ball, const SweptBone& swept, const CutQuestion& question) {
  TriangleMesh mesh = ball;
  const std::vector<Leaf> leaves = leaves_of(mesh, question, [&](const TriangleMesh& at, const Face& face) {
    return least_leaf(SeenLeaf(at, face), swept);
  });
  LeastCut found;
  sum_up(leaves, found);
  for (std::size_t f = 0; f < leaves.size(); ++f) {
    if (!leaves[f].cut) continue;
    found.cells.push_back({corners_of(mesh, mesh.faces[f]), leaves[f].may_go});
  }
  return found;
}

}  // namespace impinge
