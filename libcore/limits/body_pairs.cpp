// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/body_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "contact/part_distance.hpp"
#include "files/thread_team.hpp"
#include "gap/surface.hpp"
#include "mesh/collinear.hpp"
#include "mesh/disjoint_sets.hpp"
#include "mesh/edges.hpp"
#include "mesh/meeting_faces.hpp"
#include "mesh/surface_vertices.hpp"
#include "mesh/triangle_distance.hpp"
#include "mesh/weld.hpp"
#include "sphere/plane_side.hpp"

namespace impinge {
namespace {

constexpr double kNodeRounding = 1e-9;  // share of a length
constexpr double kLidRounding = 1e-6;   // boxes of openings are grown by this share of a body's size
constexpr double kWidestHole = 0.1;  // an opening of a larger share of a body's size, or area, makes a sheet
constexpr double kFlat = 0.1;        // an opening is flat if it is no thicker than this share of its length
constexpr int kRays = 16;            // rays that are asked whether a point is inside
constexpr std::size_t kMostLeft = 256;  // pairs of nodes of two bodies that left() stops at

// Evenly over all directions, none of them along an axis or a diagonal.
std::array<Vec3, kRays> ways_out() {
  std::array<Vec3, kRays> ways;
  for (int k = 0; k < kRays; ++k) {
    const double z = 0.9973 - 2.0 * (k + 0.5) / kRays * 0.9973;
    const double azimuth = 2.39996 * k + 0.7;
    const double rho = std::sqrt(1.0 - z * z);
    ways[static_cast<std::size_t>(k)] = {rho * std::cos(azimuth), rho * std::sin(azimuth), z};
  }
  return ways;
}

TriangleMesh without_flat_faces(TriangleMesh mesh) {
  std::erase_if(mesh.faces, [&](const Face& face) {
    const auto [a, b, c] = corners_of(mesh, face);
    return collinear(a, b, c);
  });
  return mesh;
}

// Does the segment pass the opening's box?
bool passes(const Opening& opening, const Vec3& out_of, const Vec3& into) {
  const auto& [axes, box] = opening;
  const Vec3 from = axes * out_of;
  const Vec3 to = axes * into;
  double first = 0.0;
  double last = 1.0;
  for (int k = 0; k < 3; ++k) {
    const double along = to[k] - from[k];
    const double low = (box.min()[k] - from[k]) / along;
    const double high = (box.max()[k] - from[k]) / along;
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  return first <= last + kNodeRounding;
}

// Calls visit(triangle) for triangles near the segment until it returns true; returns whether it did. There
// is a face.
template <class Visit>
bool visit_near(const SweptParts& faces, const Vec3& from, const Vec3& to, const Visit& visit) {
  std::vector<std::uint32_t> pending{0};
  while (!pending.empty()) {
    const SweptParts::Node& node = faces.nodes()[pending.back()];
    pending.pop_back();
    const double reach = node.radius + kNodeRounding * (node.centre.norm() + node.radius);
    if (squared_distance_to_segment(node.centre, from, to) > reach * reach) continue;
    if (!node.leaf)
      pending.insert(pending.end(), {node.at, node.at + 1});
    else if (visit(faces.parts()[node.at].corner))
      return true;
  }
  return false;
}

Opening opening_of(const std::vector<Vec3>& border, double grown) {
  Eigen::Matrix3Xd at(3, static_cast<Eigen::Index>(border.size()));
  for (std::size_t k = 0; k < border.size(); ++k) at.col(static_cast<Eigen::Index>(k)) = border[k];
  const Eigen::Matrix3Xd off = at.colwise() - at.rowwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(off * off.transpose());
  Opening made{spread.eigenvectors().transpose(), {}};
  at = made.axes * at;
  made.box = {at.rowwise().minCoeff().array() - grown, at.rowwise().maxCoeff().array() + grown};
  return made;
}

void add_box(const Opening& opening, TriangleMesh& mesh) {
  const auto first = static_cast<VertexIndex>(mesh.vertices.size());
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back(opening.axes.transpose() *
                            opening.box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)));
  for (const VertexIndex k : {0U, 3U, 5U, 6U}) {  // no two of these corners share an edge
    for (const auto& [a, b] : {std::pair{1U, 2U}, {2U, 4U}, {4U, 1U}})
      mesh.faces.push_back({first + k, first + (k ^ a), first + (k ^ b)});
  }
}

// Where points of one body lie in the frame of the other, in the middle of the poses.
auto in_socket(const NearPoses& poses) {
  return [&poses](const Vec3& x) -> Vec3 { return poses.rotation * x + poses.offset; };
}
auto in_ball(const NearPoses& poses) {
  return [&poses](const Vec3& y) -> Vec3 { return poses.rotation.transpose() * (y - poses.offset); };
}

}  // namespace

double Opening::beside(const Triangle& x) const {
  const Vec3 half = 0.5 * box.sizes();
  Triangle at;
  for (std::size_t k = 0; k < 3; ++k) at[k] = axes * x[k] - box.center();
  double most = -HUGE_VAL;
  const auto ask = [&](const Vec3& way) {
    const double length = way.norm();
    if (length < kNodeRounding) return;  // one axis less only brings them nearer
    const auto [low, high] = std::minmax({at[0].dot(way), at[1].dot(way), at[2].dot(way)});
    most = std::max(most, (std::max(low, -high) - half.dot(way.cwiseAbs())) / length);
  };
  ask((at[1] - at[0]).cross(at[2] - at[0]));
  for (int k = 0; k < 3; ++k) {
    ask(Vec3::Unit(k));
    for (std::size_t e = 0; e < 3; ++e) ask(Vec3::Unit(k).cross(at[(e + 1) % 3] - at[e]));
  }
  return most;
}

// 1 if the normals point out of the bone: a ball's away from the centre, a socket's towards it. Else -1. Of a
// socket those faces count that the centre sees, as the other side of its bone may be in the mesh too.
static int winding(const TriangleMesh& mesh, const SweptParts& faces, bool ball) {
  constexpr std::size_t kAsked = 1000;  // faces of a socket, about
  constexpr double kBefore = 1.0 - 1e-6;
  double volume = 0.0;
  for (std::size_t f = 0; f < mesh.faces.size(); f += ball ? 1 : 1 + mesh.faces.size() / kAsked) {
    const auto [a, b, c] = corners_of(mesh, mesh.faces[f]);
    const Vec3 before = kBefore / 3.0 * (a + b + c);
    const auto hides = [&](const Triangle& face) { return meets_segment(face, Vec3::Zero(), before); };
    if (ball || !visit_near(faces, Vec3::Zero(), before, hides)) volume += a.dot(b.cross(c));
  }
  return (volume > 0.0) == ball ? 1 : -1;
}

BodyPairs::Body::Body(const TriangleMesh& of, bool turns, Is what) {
  const TriangleMesh each = without_repeats(of);
  const TriangleMesh mesh = without_flat_faces(each);
  turn = TurnBody(mesh);
  if (turns)
    moved.emplace(mesh);
  else
    fixed.emplace(mesh);
  alone = what == Is::surface;
  if (alone) return;
  find_openings(each);
  for (const Vec3& x : mesh.vertices) box.extend(x);
  hollow = what != Is::part && !turns && openings.empty() && encloses(Vec3::Zero()) == Contact::yes;
  if (what == Is::main && sheet) wound = winding(mesh, faces(), turns);
  find_pieces(mesh);
}

// Edges with an odd number of faces that share vertices are the border of one opening. Faces without area
// count here: they close the slit between their neighbours.
void BodyPairs::Body::find_openings(const TriangleMesh& all) {
  DisjointSets sets(all.vertices.size());
  std::vector<Edge> odd;
  for_each_edge(all, [&](std::span<const HalfEdge> half_edges) {
    if (half_edges.size() % 2 == 0) return;
    odd.push_back(ends(all, half_edges[0]));
    sets.join(odd.back()[0], odd.back()[1], false);
  });
  std::map<std::size_t, std::vector<Vec3>> borders;
  for (const Edge& edge : odd) {
    for (const VertexIndex v : edge) borders[sets.find(v).root].push_back(all.vertices[v]);
  }
  if (borders.empty() || faces().empty()) return;
  double area = 0.0;
  for (const Face& face : all.faces) area += 0.5 * area_vector(all, face).norm();
  const double radius = faces().nodes()[0].radius;
  TriangleMesh lid;
  for (const auto& [root, border] : borders) {
    openings.push_back(opening_of(border, kLidRounding * radius));
    const Vec3 size = openings.back().box.sizes();
    const bool cut = size[0] <= kFlat * size[2] && size[1] * size[2] <= kWidestHole * area;
    sheet = sheet || (!cut && size.norm() > kWidestHole * 2.0 * radius);
    add_box(openings.back(), lid);
  }
  for (const Vec3& x : lid.vertices) box.extend(x);
  if (!sheet) lids = TurnBody(lid);
}

// Of each piece the vertex farthest from the centre, which is outside of another bone's box in most poses.
void BodyPairs::Body::find_pieces(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices.size());
  for (const Face& face : mesh.faces) {
    for (const VertexIndex v : face) sets.join(face[0], v, false);
  }
  std::map<std::size_t, Vec3> farthest;
  for (const Face& face : mesh.faces) {
    for (const VertexIndex v : face) {
      const Vec3& x = mesh.vertices[v];
      Vec3& kept = farthest.try_emplace(sets.find(v).root, x).first->second;
      if (x.squaredNorm() > kept.squaredNorm()) kept = x;
    }
  }
  for (const auto& [root, x] : farthest) pieces.push_back(x);
}

// Counts the faces that the segment crosses: 1 along the face's normal, -1 against it. None where it touches
// an edge of a face.
std::optional<int> BodyPairs::Body::crossings(const Vec3& from, const Vec3& to) const {
  int sum = 0;
  const bool touches = visit_near(faces(), from, to, [&](const Triangle& face) {
    if (!meets_segment(face, from, to)) return false;
    const auto& [a, b, c] = face;
    const int start = plane_side(a, b, c, from);
    const int end = plane_side(a, b, c, to);
    const int first = plane_side(from, to, a, b);
    if (start * end >= 0 || first == 0 || plane_side(from, to, b, c) == 0 || plane_side(from, to, c, a) == 0)
      return true;
    sum += end;
    return false;
  });
  return touches ? std::nullopt : std::optional(sum);
}

Contact BodyPairs::Body::holds(const Vec3& x) const {
  if (alone) return Contact::no;
  const Contact found = encloses(x);
  if (!hollow || found == Contact::unknown) return found;
  return found == Contact::yes ? Contact::no : Contact::yes;
}

Contact BodyPairs::Body::encloses(const Vec3& x) const {
  static const std::array<Vec3, kRays> kWays = ways_out();
  if (faces().empty()) return Contact::no;
  const SweptParts::Node& all = faces().nodes()[0];
  const double away = (x - all.centre).norm();
  if (away > all.radius || !box.contains(x)) return Contact::no;
  bool inside = false;
  bool outside = false;
  for (const Vec3& way : kWays) {
    const Vec3 to = x + 2.0 * (away + all.radius) * way;
    if (std::ranges::any_of(openings, [&](const Opening& at) { return passes(at, x, to); })) continue;
    const std::optional<int> sum = crossings(x, to);
    if (!sum) continue;
    const bool odd = *sum % 2 != 0;
    if (openings.empty()) return odd ? Contact::yes : Contact::no;
    ((sheet ? (wound < 0 ? -*sum : *sum) > 0 : odd) ? inside : outside) = true;
  }
  if (inside == outside || (inside && sheet && wound == 0)) return Contact::unknown;
  return inside ? Contact::yes : Contact::no;
}

// Is one point of each piece of the other body inside? What comes through the mouth of a socket that is a
// sheet comes to its hollow, not into bone.
template <class Place>
Contact BodyPairs::Body::holds_pieces(const Body& other, const Reach& reach, const Place& place) const {
  Contact found = Contact::no;
  for (const Vec3& x : other.pieces) {
    const Vec3 at = place(x);
    const double near = reach.at(x.norm()) * (1.0 + kNodeRounding);
    Contact one = holds(at);
    if (one == Contact::no && near > 0.0 && (moved || !sheet) &&
        std::ranges::any_of(openings, [&](const Opening& opening) { return opening.distance(at) <= near; }))
      one = Contact::unknown;
    if (one == Contact::yes || found == Contact::no) found = one;
  }
  return found;
}

// Is any point of the other body inside? place(x) is where a point x of it lies in this one's frame; with a
// reach, poses are asked about in which it is elsewhere. The surfaces must not meet. Of a sheet only one
// point of each piece is asked about. What passes an opening's box may be inside with what is behind the box.
template <class Place>
Contact BodyPairs::Body::holds_of(const Body& other, const Reach& reach, const Place& place) const {
  const Contact found = holds_pieces(other, reach, place);
  if (found == Contact::yes || sheet || openings.empty()) return found;
  const bool enters = other.faces().any_node([&](const SweptParts::Node& node) {
    const Vec3 centre = place(node.centre);
    const double way = reach.at(node.farthest) + kNodeRounding * (centre.norm() + node.radius);
    return std::ranges::any_of(openings, [&](const Opening& at) {
      if (at.distance(centre) > node.radius + way) return false;
      if (!node.leaf) return true;
      const auto& [a, b, c] = other.faces().parts()[node.at].corner;
      return at.beside({place(a), place(b), place(c)}) <= way;
    });
  });
  if (!enters) return found;
  if (reach.at(1.0) > 0.0) return Contact::unknown;
  for (std::size_t f = 0; f < other.turn.first_corner.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (other.turn.first_corner[f][k] && holds(place(other.faces().parts()[f].corner[k])) == Contact::yes)
        return Contact::yes;
    }
  }
  return Contact::unknown;
}

BodyPairs::BodyPairs(const BallSocketPair& main, const BoneParts& beside)
    : ball_is_whole_(beside.whole_ball.has_value()), main_only_(!ball_is_whole_ && !beside.whole_socket) {
  on_threads(kSurfaces.size(), [&](std::size_t k) {
    const bool ball = kSurfaces[k] == Surface::ball;
    const std::optional<TriangleMesh>& whole = ball ? beside.whole_ball : beside.whole_socket;
    auto& bodies = ball ? ball_ : socket_;
    bodies.push_back(std::make_unique<Body>(whole ? *whole : mesh_of(main, kSurfaces[k]), ball,
                                            whole ? Body::Is::whole : Body::Is::main));
    for (const TriangleMesh& part : ball ? beside.ball : beside.socket)
      bodies.push_back(std::make_unique<Body>(part, ball, Body::Is::part));
  });
  if (socket_[0]->sheet) radial_ = std::make_unique<const Radial>(main);
  if (main_only_) edge_on_ = {edge_on_of(main.ball, true), edge_on_of(main.socket, false)};
  for (std::size_t b = 0; b < ball_.size(); ++b) {
    for (std::size_t s = 0; s < socket_.size(); ++s) pairs_.push_back({b, s});
  }
}

// Faces of the main surface are recognised by their corners.
void BodyPairs::Body::find_main(const TriangleMesh& main) {
  using Corners = std::array<std::array<double, 3>, 3>;
  const auto key = [](const Triangle& face) {
    Corners at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = {face[k].x(), face[k].y(), face[k].z()};
    std::sort(at.begin(), at.end());
    return at;
  };
  std::set<Corners> all;
  for (const Face& face : main.faces) {
    const Triangle at = corners_of(main, face);
    if (orientation(at[0], at[1], at[2]) != 0) all.insert(key(at));
  }
  of_main.resize(faces().nodes().size());
  for (std::size_t k = of_main.size(); k-- > 0;) {  // children come after their node
    const SweptParts::Node& node = faces().nodes()[k];
    of_main[k] = node.leaf ? all.count(key(faces().parts()[node.at].corner)) > 0
                           : of_main[node.at] && of_main[node.at + 1];
  }
}

BodyPairs BodyPairs::of_surfaces(const BallSocketPair& surfaces) {
  BodyPairs pairs;
  pairs.inside_ = false;
  pairs.ball_.push_back(std::make_unique<Body>(surfaces.ball, true, Body::Is::surface));
  pairs.socket_.push_back(std::make_unique<Body>(surfaces.socket, false, Body::Is::surface));
  pairs.pairs_.push_back({});
  return pairs;
}

// What radii leave open of a surface: its edge-on faces may meet the other one, and pieces of nothing else
// may be inside it. Other pieces have a face that radii tell about.
std::unique_ptr<BodyPairs::Body> BodyPairs::edge_on_of(const TriangleMesh& main, bool turns) {
  TriangleMesh mesh = without_flat_faces(main);
  DisjointSets sets(mesh.vertices.size());
  for (const Face& face : mesh.faces) {
    for (const VertexIndex v : face) sets.join(face[0], v, false);
  }
  std::set<std::size_t> seen;
  std::erase_if(mesh.faces, [&](const Face& face) {
    if (is_edge_on(mesh, face)) return false;
    seen.insert(sets.find(face[0]).root);
    return true;
  });
  if (mesh.faces.empty()) return nullptr;
  auto body = std::make_unique<Body>(mesh, turns, Body::Is::surface);
  for (const Face& face : mesh.faces) {
    if (seen.insert(sets.find(face[0]).root).second) body->pieces.push_back(mesh.vertices[face[0]]);
  }
  return body;
}

const CulledJoint& BodyPairs::Radial::joint() const {
  const std::lock_guard lock(making_);
  if (!joint_) joint_.emplace(meshes_);
  return *joint_;
}

bool BodyPairs::Radial::impinged(const Pose& pose) const {
  constexpr int kFew = 4;  // poses, each of which takes a tenth of what the joint does
  return poses_++ < kFew ? overlay_.impinged(pose) : overlay_.impinged(pose, joint());
}

// Calls ask(ball, socket) for the edge-on faces of either surface and the whole other one, until it is true.
template <class Ask>
bool BodyPairs::any_edge_on(const Ask& ask) const {
  return (edge_on_[0] && ask(*edge_on_[0], *socket_[0])) || (edge_on_[1] && ask(*ball_[0], *edge_on_[1]));
}

// The verdict about main bones without what radii tell. In a socket that is a sheet nothing is looked for.
BodyPairs::Verdict BodyPairs::beside_radii(const Pair& pair, const Pose& pose) const {
  Verdict found{Contact::no, ContactRule::surfaces, pair};
  any_edge_on([&](const Body& ball, const Body& socket) {
    const Verdict one = verdict(ball, socket, pair, pose);
    if (one.contact != Contact::no) found = one;
    return one.contact == Contact::yes;
  });
  if (found.contact == Contact::yes || ball_[0]->sheet) return found;
  const Contact in_ball =
      ball_[0]->holds_of(*socket_[0], {}, [&](const Vec3& y) -> Vec3 { return to_ball(pose, y); });
  return in_ball == Contact::no ? found
                                : Verdict{in_ball, ContactRule::inside, pair, ball_[0]->openings.empty()};
}

BodyPairs::Verdict BodyPairs::verdict(const Body& ball, const Body& socket, const Pair& pair,
                                      const Pose& pose) {
  if (surfaces_meet(*ball.moved, *socket.fixed, pose)) return {Contact::yes, ContactRule::surfaces, pair};
  const Contact in_socket =
      socket.holds_of(ball, {}, [&](const Vec3& x) -> Vec3 { return to_socket(pose, x); });
  if (in_socket == Contact::yes) return {Contact::yes, ContactRule::inside, pair, socket.openings.empty()};
  const Contact in_ball = ball.holds_of(socket, {}, [&](const Vec3& y) -> Vec3 { return to_ball(pose, y); });
  return {in_ball == Contact::no ? in_socket : in_ball, ContactRule::inside, pair, ball.openings.empty()};
}

bool BodyPairs::closed() const {
  const auto all_closed = [](const auto& bodies) {
    return std::ranges::all_of(bodies, [](const auto& body) { return body->openings.empty(); });
  };
  return all_closed(ball_) && all_closed(socket_);
}

std::optional<BodyPairs::Pair> BodyPairs::without_inside() const {
  const auto found = std::ranges::find_if(pairs_, [&](const Pair& pair) {
    return !(main_only_ && is_main(pair)) && !ball_[pair.ball]->has_inside() &&
           !socket_[pair.socket]->has_inside();
  });
  return found == pairs_.end() ? std::nullopt : std::optional(*found);
}

// ask(pair) gives a verdict. Returns the first yes, else the first unknown, else no.
template <class Ask>
BodyPairs::Verdict BodyPairs::first_of(const Ask& ask) const {
  Verdict first;
  for (const Pair& pair : pairs_) {
    const Verdict found = ask(pair);
    if (found.contact == Contact::yes) return found;
    if (first.contact == Contact::no) first = found;
  }
  return first;
}

BodyPairs::Verdict BodyPairs::verdict(const Pose& pose, bool radii) const {
  const bool overlap = radii && radial_ && radial_->impinged(pose);
  return first_of([&](const Pair& pair) {
    if (!radial_ || !is_main(pair)) return verdict(pair, pose);
    if (!overlap && main_only_) return beside_radii(pair, pose);
    Verdict found = verdict(pair, pose);
    return found.contact == Contact::yes || !overlap ? found
                                                     : Verdict{Contact::yes, ContactRule::radii, pair};
  });
}

bool BodyPairs::meet(const Pose& pose) const {
  return first_of([&](const Pair& pair) { return verdict(pair, pose); }).contact == Contact::yes;
}

std::optional<BodyPairs::Nearest> BodyPairs::nearest_part(const Pose& pose) const {
  std::optional<Nearest> found;
  for (const Pair& pair : pairs_) {
    if (is_main(pair)) continue;
    const Contact contact = verdict(pair, pose).contact;
    if (contact == Contact::yes) return Nearest{pair, 0.0, contact};
    double least = found ? found->distance_mm : HUGE_VAL;
    const SweptParts& ball = ball_[pair.ball]->faces();
    const SweptParts& socket = socket_[pair.socket]->faces();
    const auto apart = [&](std::uint32_t p, std::uint32_t q) {
      const SweptParts::Node& a = ball.nodes()[p];
      const SweptParts::Node& b = socket.nodes()[q];
      const double spheres = (to_socket(pose, a.centre) - b.centre).norm() - a.radius - b.radius;
      return spheres > least + kNodeRounding * (a.farthest + b.farthest);
    };
    const auto measure = [&](std::uint32_t p, std::uint32_t q) {
      const auto& [c0, c1, c2] = ball.parts()[p].corner;
      const TurnFace moved = turn_face(to_socket(pose, c0), to_socket(pose, c1), to_socket(pose, c2));
      least = std::min(least, least_distance(moved, socket.parts()[q]));
      return false;
    };
    any_pair(ball, socket, apart, measure);
    if (std::isfinite(least) && (!found || least < found->distance_mm)) found = Nearest{pair, least, contact};
  }
  return found;
}

// If the surfaces meet in none of these poses: may a point of one be inside the other in one of them?
bool BodyPairs::may_hold(const Body& ball, const Body& socket, const NearPoses& poses) {
  return socket.holds_of(ball, Reach(poses), in_socket(poses)) != Contact::no ||
         ball.holds_of(socket, Reach(poses), in_ball(poses)) != Contact::no;
}

// Where radii of the main bones are clear: may one have come into the other through an opening? None comes
// into a socket that is a sheet, of which only one point of each piece is asked about: every cell with a hole
// of the ball near it would stay open else.
bool BodyPairs::may_have_come_in(const NearPoses& poses) const {
  const Body& ball = *ball_[0];
  const Body& socket = *socket_[0];
  if (!radial_) return (!ball.openings.empty() || !socket.openings.empty()) && may_hold(ball, socket, poses);
  return is_open_bone(ball) && ball.holds_pieces(socket, Reach(poses), in_ball(poses)) != Contact::no;
}

BodyPairs::Reach::Reach(const NearPoses& poses)
    : turn(2.0 * std::sin(0.5 * std::min(poses.turn, kPi)) * (1.0 + kNodeRounding)),
      shift(poses.shift_mm + turn * poses.offset.norm()) {}

// Two bodies that are asked about. `left` has the pair's place; edge-on faces that radii leave open have
// none.
struct BodyPairs::Asking {
  const Body& ball;
  const Body& socket;
  const NearBodies& near;
  NearBodies::Asked faces;
  std::optional<std::size_t> place;
};

// Calls meet(asking) for each pair until it is true.
template <class Meet>
std::optional<BodyPairs::Pair> BodyPairs::first_that(const NearPoses& poses, bool by_radii, const Left& left,
                                                     const Meet& meet) const {
  const NodePairs all{{0, 0}};
  const NearBodies::Told none;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const Pair& pair = pairs_[k];
    const NearBodies near(poses, is_main(pair) ? 0.0 : poses.gap_mm);
    const Body& ball = *ball_[pair.ball];
    const Body& socket = *socket_[pair.socket];
    const bool radii = by_radii && is_main(pair);
    if (radii && main_only_) {
      const auto ask = [&](const Body& one, const Body& other) {
        return meet(Asking{one, other, near, {one.faces(), other.faces(), none, all}, std::nullopt});
      };
      if (any_edge_on(ask)) return pair;
      continue;
    }
    NearBodies::Told told;
    if (radii && !ball.of_main.empty())
      told = [&](std::uint32_t a, std::uint32_t b) { return ball.of_main[a] && socket.of_main[b]; };
    const NodePairs& from = left.empty() ? all : left[k];
    if (meet(Asking{ball, socket, near, {ball.faces(), socket.faces(), told, from}, k})) return pair;
  }
  return std::nullopt;
}

BodyPairs::Left BodyPairs::left(const NearPoses& poses, bool by_radii) const {
  Left found(pairs_.size());
  first_that(poses, by_radii, {}, [&](const Asking& asking) {
    if (asking.place) found[*asking.place] = asking.near.left(asking.faces, kMostLeft);
    return false;
  });
  return found;
}

std::optional<BodyPairs::Pair> BodyPairs::may_meet(const NearPoses& poses, bool by_radii,
                                                   const Left& left) const {
  if (by_radii && main_only_ && may_have_come_in(poses)) return Pair{};
  return first_that(poses, by_radii, left, [&](const Asking& asking) {
    return asking.near.may_meet(asking.faces) || may_hold(asking.ball, asking.socket, poses);
  });
}

bool BodyPairs::each_close(const NearPoses& poses, bool by_radii, const TakeClose& take,
                           const Left& left) const {
  if (by_radii && main_only_ && may_have_come_in(poses)) return false;
  return !first_that(poses, by_radii, left, [&](const Asking& asking) {
    return !asking.near.each_close(asking.faces, take) || may_hold(asking.ball, asking.socket, poses);
  });
}

void BodyPairs::find_inner_balls(const BallSocketPair& main, bool by_radii) {
  on_threads(kSurfaces.size(), [&](std::size_t k) {
    const auto& bodies = kSurfaces[k] == Surface::ball ? ball_ : socket_;
    const auto& others = kSurfaces[k] == Surface::ball ? socket_ : ball_;
    bodies[0]->find_main(mesh_of(main, kSurfaces[k]));
    for (const auto& body : bodies) {
      if (by_radii && main_only_ && body == bodies[0] && others.size() == 1) continue;  // not needed
      const auto to_opening = [&](const Vec3& x) {
        double least = HUGE_VAL;
        for (const Opening& at : body->openings) least = std::min(least, at.distance(x));
        return least;
      };
      const auto holds = [&](const Vec3& x) { return body->holds(x) == Contact::yes; };
      body->inner =
          InnerBalls(body->faces(), {body->has_inside() ? BodyInside::Holds(holds) : nullptr, to_opening});
    }
  });
}

template <class Visit>
bool BodyPairs::any_near(const NearPoses& poses, bool by_radii, const Visit& visit) const {
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
    if (by_radii && main_only_ && is_main(pair)) return false;
    const Body& ball = *ball_[pair.ball];
    const Body& socket = *socket_[pair.socket];
    return visit(NearBodies(poses, is_main(pair) ? 0.0 : poses.gap_mm),
                 BodyTrees{ball.faces(), ball.inner.of(poses.turn)},
                 BodyTrees{socket.faces(), socket.inner.of(poses.turn)});
  });
}

bool BodyPairs::overlap(const NearPoses& poses, bool by_radii) const {
  return any_near(poses, by_radii,
                  [](const NearBodies& near, const BodyTrees& ball, const BodyTrees& socket) {
                    return near.stay_in_contact(ball, socket);
                  });
}

std::vector<WithinReach> BodyPairs::deepest(const NearPoses& poses, bool by_radii, std::size_t most) const {
  std::vector<WithinReach> all;
  any_near(poses, by_radii, [&](const NearBodies& near, const BodyTrees& ball, const BodyTrees& socket) {
    const std::vector<WithinReach> found = near.deepest(ball, socket, most);
    all.insert(all.end(), found.begin(), found.end());
    return false;
  });
  return all;
}

std::vector<BodyPairs::Vertex> BodyPairs::near(const Pair& pair, const Pose& pose, const Vec3& place,
                                               double within) const {
  std::vector<Vertex> found;
  for (const bool of_ball : {true, false}) {
    const TurnBody& body = of_ball ? ball_[pair.ball]->turn : socket_[pair.socket]->turn;
    const Vec3 at = of_ball ? to_ball(pose, place) : place;
    body.faces.visit_near(at, within, [&](std::uint32_t f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& x = body.faces.parts()[f].corner[k];
        if (body.first_corner[f][k] && (x - at).norm() <= within) found.push_back({pair, of_ball, x});
      }
    });
  }
  return found;
}

bool BodyPairs::is_inside_by(const Vertex& vertex, const Pose& pose, double depth_mm) const {
  const Body& other = vertex.of_ball ? *socket_[vertex.pair.socket] : *ball_[vertex.pair.ball];
  const Vec3 x = vertex.of_ball ? to_socket(pose, vertex.x) : to_ball(pose, vertex.x);
  const double far = x.norm();  // the same in all of the turn, whatever its axis
  const auto near = [&](const Opening& at) {
    const double farthest = at.box.min().cwiseAbs().cwiseMax(at.box.max().cwiseAbs()).norm();
    return at.distance(Vec3::Zero()) <= far + depth_mm && far - depth_mm <= farthest;
  };
  return !other.sheet && std::ranges::none_of(other.openings, near) &&
         other.faces().farther_than(depth_mm, x) && other.holds(x) == Contact::yes;
}

// Calls visit(ball, socket, pair) for the surfaces of two bodies, and for each surface with the boxes of the
// other one's openings.
template <class Visit>
void BodyPairs::for_each_turned(const Visit& visit) const {
  for (const Pair& pair : pairs_) {
    const Body& ball = *ball_[pair.ball];
    const Body& socket = *socket_[pair.socket];
    visit(ball.turn, socket.turn, pair);
    if (!ball.lids.faces.empty()) visit(ball.lids, socket.turn, pair);
    if (!socket.lids.faces.empty()) visit(ball.turn, socket.lids, pair);
  }
}

std::optional<TurnContact> BodyPairs::first_contact(const JointTurn& turn, AngleSpan angles) const {
  std::optional<TurnContact> first;
  for_each_turned([&](const TurnBody& ball, const TurnBody& socket, const Pair& pair) {
    const auto found = impinge::first_contact({ball, socket, turn}, angles);
    if (!found || (first && found->angle >= first->angle)) return;
    first = found;
    first->body = {pair.ball, pair.socket};
    angles.to = found->angle;
  });
  return first;
}

double BodyPairs::first_within(const Eigen::Matrix3d& ball, const Eigen::Matrix3d& socket,
                               const WithinSpan& within, double largest) const {
  for_each_turned([&](const TurnBody& turning, const TurnBody& resting, const Pair&) {
    largest = impinge::first_within({turning.faces, ball, resting.faces, socket}, within, largest);
  });
  return largest;
}

}  // namespace impinge
