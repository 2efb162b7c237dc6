// SPDX-License-Identifier: GPL-3.0-or-later
#include "change/resection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "mesh/edges.hpp"
#include "mesh/split_faces.hpp"
#include "mesh/star_shape.hpp"
#include "mesh/triangle_distance.hpp"
#include "mesh/weld.hpp"
#include "rotations/bone_along_rays.hpp"
#include "sphere/infinity.hpp"
#include "table/near_faces.hpp"

namespace impinge {
namespace {

constexpr double kVolumeSlack = 1e-9;  // share of a volume or area that allows for rounding
constexpr int kMostRounds = 40;
constexpr Ends kUnknown{0.0, kInfinity};  // of a volume
constexpr double kLeastFlat = 0.5;  // cosine of a leaf's radius; the corners of a wider one are not moved out

// Signed volume of the cone over a face, mm^3.
double cone_volume(const TriangleMesh& mesh, const Face& face) {
  return corner(mesh, face, 0).dot(corner(mesh, face, 1).cross(corner(mesh, face, 2))) / 6.0;
}

// What is known of one face.
struct Leaf {
  bool cut = false;      // may some bone along its rays have to go?
  bool whole = false;    // does all bone along its rays certainly go?
  double corners = 0.0;  // mm: with its corners at this radius all of the leaf keeps the clearance
  RaySpans may_go;       // for a least cut: radii that may go
  Ends volume;           // mm^3 that go, signed as its cone
  Ends area;             // mm^2 that go
  Ends depth;            // mm that go along one ray
};

// A face as the centre sees it.
struct SeenLeaf {
  SeenLeaf(const TriangleMesh& mesh, const Face& face) : seen(face_cap(corners_of(mesh, face))) {
    cap = {seen.cap.axis, seen.small() ? seen.cap.radius : kPi};
    area = 0.5 * area_vector(mesh, face).norm();
    if (seen.side == 0) return;  // edge-on: its cone has no volume
    cone = std::abs(cone_volume(mesh, face));
    angle = std::abs(solid_angle(corner(mesh, face, 0), corner(mesh, face, 1), corner(mesh, face, 2)));
  }
  FaceCap seen;
  DirectionCap cap;
  double cone = 0.0;   // mm^3
  double angle = 0.0;  // steradians
  double area = 0.0;   // mm^2

  double cone_to(double radius) const { return angle * radius * radius * radius / 3.0; }  // mm^3
};

constexpr double kMore = 1.0 + kVolumeSlack;
constexpr double kLess = 1.0 - kVolumeSlack;

// What goes of the cone over a face: bounded by what goes, and by the cone's volume less what stays (theorem
// in the header, (ii)).
Leaf leaf_of(const SeenLeaf& face, const SpansOverCap& goes) {
  const auto& [low, high] = face.seen.range;
  const double most_kept = (face.cone_to(high) - face.angle * goes.certain.volume(high)) * kMore;
  const double least_kept = (face.cone_to(low) - face.angle * goes.possible.volume(low)) * kLess;
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

Leaf ball_leaf(const SeenLeaf& face, const SweptRadius& swept, double clearance) {
  const double farthest = face.seen.range.high;
  const Ends swept_over = swept.over(face.cap, farthest + clearance);
  const double keep = swept_over.low - clearance;
  if (keep >= farthest) return {};
  SpansOverCap goes;
  goes.possible.add(std::max(0.0, keep), farthest);
  goes.certain.add(std::max(0.0, swept_over.high - clearance), farthest);
  Leaf leaf = leaf_of(face, goes);
  leaf.corners = keep;
  return leaf;
}

// Are normals inwards? Volumes are those of cones over the faces, with signs.
bool is_inside_out(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const Face& face : mesh.faces) volume += cone_volume(mesh, face);
  return volume < 0.0;
}

// The bone of a socket whose mesh is closed.
struct Bone {
  explicit Bone(const TriangleMesh& socket)
      : outside(socket, Layer::farthest), inside_out(is_inside_out(socket)) {}
  RadiiOverCap outside;  // radii of its outermost layer, L
  bool inside_out;
};

std::optional<Bone> bone_of(const TriangleMesh& socket) {
  if (!is_bone_beside_centre(socket)) return std::nullopt;
  return std::optional<Bone>(std::in_place, socket);
}

// The volume, mm^3, of the cone over a face between the face and these radii, where they are beyond the face.
Ends volume_up_to(const SeenLeaf& face, const Ends& radius) {
  const auto& [low, high] = face.seen.range;
  const double least = face.cone_to(std::max(radius.low, low)) * kLess - face.cone * kMore;
  const double most = face.cone_to(std::max(radius.high, high)) * kMore - face.cone * kLess;
  return {std::max({0.0, least, face.cone_to(radius.low) * kLess - face.cone_to(high) * kMore}),
          std::min(most, face.cone_to(radius.high) * kMore - face.cone_to(low) * kLess)};
}

// Adds what goes along the rays of a leaf, up to `clear` but no farther than the outermost layer (theorem in
// the header, (iv)).
void add_bone(const SeenLeaf& face, const Ends& clear, const Bone& bone, Leaf& leaf) {
  const Ends outside{
      std::max(0.0, bone.outside.least(face.cap)),
      std::max(bone.outside.largest(face.cap), face.seen.range.high)};  // outside lacks edge-on faces
  const Ends goes{std::min(clear.low, outside.low), std::min(clear.high, outside.high)};
  const Ends volume = volume_up_to(face, goes);
  const bool comes_into_bone = (face.seen.side < 0) != bone.inside_out;
  leaf.volume = comes_into_bone ? volume : Ends{-volume.high, -volume.low};
  leaf.depth = {std::max(0.0, goes.low - face.seen.range.high), goes.high - face.seen.range.low};
  leaf.whole = clear.low >= outside.high;
}

Leaf socket_leaf(const SeenLeaf& face, const SweptRadius& swept, const std::optional<Bone>& bone,
                 double clearance) {
  const auto& [low, high] = face.seen.range;
  const Ends swept_over = swept.over(face.cap, low - clearance);
  const Ends clear{std::max(0.0, swept_over.low + clearance), swept_over.high + clearance};
  if (clear.high <= low) return {};
  Leaf leaf;
  leaf.cut = true;
  const double flat = face.seen.small() ? std::cos(face.cap.radius + kCapSlack) : 0.0;
  leaf.corners = flat > kLeastFlat ? clear.high / flat * kMore : kInfinity;
  leaf.area = {clear.low >= high ? face.area * kLess : 0.0, face.area * kMore};
  leaf.depth = {std::max(0.0, clear.low - high), clear.high - low};
  if (bone) add_bone(face, clear, *bone, leaf);
  return leaf;
}

Leaf least_leaf(const SeenLeaf& face, const SweptBone& swept) {
  SpansOverCap goes = swept.over(face.cap, face.seen.range.high);
  Leaf leaf = leaf_of(face, goes);
  leaf.may_go = std::move(goes.possible);
  return leaf;
}

double width(const Ends& ends) { return ends.high - ends.low; }

// Marks as few leaves as hold half of all doubt (Doerfler 1996, "A convergent adaptive algorithm for
// Poisson's equation").
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

// Sums over all leaves. The widths between the ends of the leaves add up.
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

// The doubt of each leaf, mm^3: the width of its volume, and of its area times the mean depth, with less
// weight because the area need not be as close. Empty if everything is close enough.
std::vector<double> doubts_of(const std::vector<Leaf>& leaves, const CutQuestion& question) {
  const Total total = total_of(leaves);
  const bool has_volume = total.volume.high > 0.0;  // else, as for an open socket, only the area counts
  const double weight = has_volume ? 0.25 : 1.0;
  const double depth = has_volume ? total.volume.high / std::max(total.area.high, 1e-9) : 1.0;
  const bool volume =
      width(total.volume) > std::max(question.least_mm3, question.closeness * total.volume.low);
  const bool area =
      weight * width(total.area) > std::max(question.least_mm3, question.closeness * total.area.low);
  if (!volume && !area) return {};
  std::vector<double> doubts;
  doubts.reserve(leaves.size());
  for (const Leaf& leaf : leaves)
    doubts.push_back(width(leaf.volume) + (area ? weight * depth * width(leaf.area) : 0.0));
  return doubts;
}

// Marks the leaves that may be deeper, by more than `closeness`, than any is certain to be.
void mark_deepest(const std::vector<Leaf>& leaves, double closeness, std::vector<bool>& marked) {
  double certain = 0.0;
  for (const Leaf& leaf : leaves) certain = std::max(certain, leaf.depth.low);
  for (std::size_t f = 0; f < leaves.size(); ++f) {
    if (leaves[f].cut && leaves[f].depth.high > certain + closeness) marked[f] = true;
  }
}

// Divides the marked leaves, and asks about the new ones.
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

// Divides a mesh into leaves until the ends are close enough.
std::vector<Leaf> leaves_of(TriangleMesh& mesh, const CutQuestion& question, const auto& ask) {
  std::vector<Leaf> leaves;
  for (const Face& face : mesh.faces) leaves.push_back(ask(mesh, face));
  const std::size_t most_faces = mesh.faces.size() + question.most_new_faces;
  for (int round = 0; round < kMostRounds && mesh.faces.size() < most_faces; ++round) {
    const std::vector<double> doubts = doubts_of(leaves, question);
    std::vector<bool> marked(leaves.size(), false);
    if (!doubts.empty()) marked = most_doubtful(doubts);
    mark_deepest(leaves, question.depth_mm, marked);
    if (std::ranges::find(marked, true) == marked.end()) break;
    split(mesh, leaves, marked, ask);
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

// The radius, mm, to which each corner moves along its ray, so that all leaves round it keep the clearance:
// inwards for a ball, outwards for a socket.
std::vector<double> radii_of_corners(const std::vector<Leaf>& leaves, const TriangleMesh& mesh, Surface cut) {
  const bool in = cut == Surface::ball;
  std::vector<double> radii;
  for (const Vec3& x : mesh.vertices) radii.push_back(x.norm());
  for (std::size_t f = 0; f < leaves.size(); ++f) {
    if (!leaves[f].cut) continue;
    for (const VertexIndex v : mesh.faces[f])
      radii[v] = in ? std::min(radii[v], leaves[f].corners) : std::max(radii[v], leaves[f].corners);
  }
  return radii;
}

void move_corners(const std::vector<Leaf>& leaves, Resection& found) {
  const double rounded = found.of == Surface::ball ? 1.0 - 1e-15 : 1.0 + 1e-15;
  const std::vector<double> radii = radii_of_corners(leaves, found.before, found.of);
  found.cut = found.before;
  found.depth.assign(radii.size(), 0.0);
  for (std::size_t v = 0; v < radii.size(); ++v) {
    const double radius = found.before.vertices[v].norm();
    if (radii[v] == radius) continue;
    if (radii[v] <= 0.0)
      throw std::runtime_error("nothing of the ball would be left along some ray; require less");
    if (radii[v] == kInfinity)
      throw std::runtime_error("a face of the socket is too wide to be cut; give a mesh of smaller faces");
    found.cut.vertices[v] *= radii[v] / radius * rounded;
    found.depth[v] = std::abs(radius - radii[v]);
  }
  found.deepest = static_cast<std::size_t>(std::ranges::max_element(found.depth) - found.depth.begin());
  for (const Face& face : found.before.faces)
    found.cut_mm3 += cone_volume(found.before, face) - cone_volume(found.cut, face);
}

// Takes out of the cut surface the leaves along whose rays all bone goes, and the edge-on faces between them.
// Were there any?
bool take_out_whole(const std::vector<Leaf>& leaves, Resection& found) {
  std::vector<bool> gone(found.before.vertices.size(), false);
  for (std::size_t f = 0; f < leaves.size(); ++f) {
    for (const VertexIndex v : found.before.faces[f]) gone[v] = gone[v] || leaves[f].whole;
  }
  found.cut.faces.clear();
  for (std::size_t f = 0; f < leaves.size(); ++f) {
    const Face& face = found.before.faces[f];
    const bool edge_on = face_cap(corners_of(found.before, face)).side == 0;
    if (!leaves[f].whole && !(edge_on && std::ranges::all_of(face, [&](VertexIndex v) { return gone[v]; })))
      found.cut.faces.push_back(face);
  }
  return found.cut.faces.size() < leaves.size();
}

void flip_faces(TriangleMesh& mesh) {
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
}

// Edges through which faces do not run as often one way as the other. Only across these may the number of
// faces change that a ray crosses outwards, less that of others.
std::vector<std::array<Vec3, 2>> open_edges(const TriangleMesh& mesh) {
  std::vector<std::array<Vec3, 2>> open;
  for_each_edge(mesh, [&](std::span<const HalfEdge> sides) {
    const Edge edge = ends(mesh, sides.front());
    const auto same = std::ranges::count_if(sides, [&](HalfEdge side) { return ends(mesh, side) == edge; });
    if (2 * same != std::ssize(sides))
      open.push_back({mesh.vertices[edge[0]].normalized(), mesh.vertices[edge[1]].normalized()});
  });
  return open;
}

// May the arc between two directions meet the cap? It is within its sagitta of the chord.
bool meets(const DirectionCap& cap, const std::array<Vec3, 2>& arc) {
  const double half = 0.5 * angle_between(arc[0], arc[1]);
  return std::sqrt(squared_distance_to_segment(cap.axis, arc[0], arc[1])) <=
         cap.radius + 0.5 * half * half + kCapSlack;
}

// Do the faces of the ball say where its bone is along all rays that are cut (theorem in the header, (ii))?
bool is_bone_known(const TriangleMesh& ball, const std::vector<Leaf>& leaves) {
  const NearFaces faces(ball, 0.0);
  const auto open = open_edges(ball);
  for (std::size_t f = 0; f < leaves.size(); ++f) {
    const Face& face = ball.faces[f];
    const SeenLeaf leaf(ball, face);
    if (!leaves[f].cut || leaf.seen.side == 0) continue;
    const Vec3 middle = corner(ball, face, 0) + corner(ball, face, 1) + corner(ball, face, 2);
    const auto bone = bone_along(faces, middle.stableNormalized(), false);
    if (bone && (bone->least < 0 || (!open.empty() && bone->at_centre != 1))) return false;
    if (std::ranges::any_of(open, [&](const auto& arc) { return meets(leaf.cap, arc); })) return false;
  }
  return true;
}

Resection cut_of_ball(const TriangleMesh& ball, const SweptRadius& swept, const CutQuestion& question) {
  Resection found;
  found.before = without_repeats(ball);
  const bool inside_out = is_inside_out(found.before);
  if (inside_out) flip_faces(found.before);
  const auto leaves = leaves_of(found.before, question, [&](const TriangleMesh& mesh, const Face& face) {
    return ball_leaf(SeenLeaf(mesh, face), swept, question.clearance_mm);
  });
  sum_up(leaves, found);
  move_corners(leaves, found);
  if (!is_bone_known(found.before, leaves)) {
    found.volume_mm3 = kUnknown;
    found.cut_mm3 = std::numeric_limits<double>::quiet_NaN();
  }
  if (inside_out)
    for (TriangleMesh* mesh : {&found.before, &found.cut}) flip_faces(*mesh);
  return found;
}

Resection cut_of_socket(const TriangleMesh& socket, const SweptRadius& swept, const CutQuestion& question) {
  Resection found;
  found.of = Surface::socket;
  found.before = without_repeats(socket);
  const std::optional<Bone> bone = bone_of(found.before);
  const auto leaves = leaves_of(found.before, question, [&](const TriangleMesh& mesh, const Face& face) {
    return socket_leaf(SeenLeaf(mesh, face), swept, bone, question.clearance_mm);
  });
  sum_up(leaves, found);
  move_corners(leaves, found);
  if (bone && bone->inside_out) found.cut_mm3 = -found.cut_mm3;
  if (!bone && !found.empty()) found.volume_mm3 = kUnknown;
  if (take_out_whole(leaves, found) || found.volume_mm3.high == kInfinity)
    found.cut_mm3 = std::numeric_limits<double>::quiet_NaN();
  return found;
}

}  // namespace

Resection least_radial_cut(const TriangleMesh& surface, const SweptRadius& swept,
                           const CutQuestion& question) {
  return swept.cut() == Surface::ball ? cut_of_ball(surface, swept, question)
                                      : cut_of_socket(surface, swept, question);
}

LeastCut least_cut(const TriangleMesh& ball, const SweptBone& swept, const CutQuestion& question) {
  TriangleMesh mesh = without_repeats(ball);
  if (is_inside_out(mesh)) flip_faces(mesh);
  const std::vector<Leaf> leaves = leaves_of(mesh, question, [&](const TriangleMesh& at, const Face& face) {
    return least_leaf(SeenLeaf(at, face), swept);
  });
  LeastCut found;
  sum_up(leaves, found);
  if (!is_bone_known(mesh, leaves)) found.volume_mm3 = kUnknown;
  for (std::size_t f = 0; f < leaves.size(); ++f) {
    if (!leaves[f].cut) continue;
    found.cells.push_back({corners_of(mesh, mesh.faces[f]), leaves[f].may_go});
  }
  return found;
}

}  // namespace impinge
