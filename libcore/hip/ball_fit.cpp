// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "files/formatted.hpp"
#include "hip/sphere_fit.hpp"
#include "table/near_faces.hpp"

namespace impinge {
namespace {

constexpr std::size_t kMostVoters = 2000;
constexpr double kFewestVotes = 12.0;     // vertices on a trial sphere; fewer are a corner
constexpr double kLeastShare = 0.02;      // of all voters: less is no joint surface but a fold of a bone
constexpr double kSmallestSphere = 0.02;  // of the size of the mesh
constexpr double kAlongRadius = 0.8;      // cosine between normal and radius of a voter
constexpr double kParallel = 0.05;        // squared difference of normals that meet nowhere near
constexpr double kFirstTolerance = 0.10;  // of the first fit after the vote, as a share of the radius
constexpr double kFinest = 1e-4;  // smallest trim, share of the radius: what rounding leaves of a sphere
constexpr double kNormalScale = 1.4826;  // standard deviation over median of absolute normal deviates
constexpr int kMostRefinements = 60;
constexpr double kSocketEnd = 1.5;    // head radii from the centre: the socket is nearer
constexpr double kSocketStart = 0.8;  // and farther than that

// A vertex that stands for some area, with its unit normal.
struct Voter {
  Vec3 x;
  Vec3 normal;
  double area;
};

struct Trial {
  Vec3 centre;
  double radius;
};

// All vertices, or of a large mesh some at equal steps of area.
std::vector<Voter> voters_of(const TriangleMesh& mesh) {
  std::vector<Vec3> normal(mesh.vertices.size(), Vec3::Zero());
  for (const Face& face : mesh.faces) {
    const Vec3 area = area_vector(mesh, face);
    for (const VertexIndex v : face) normal[v] += area;
  }
  const std::vector<double> area = vertex_areas(mesh);
  const bool few = area.size() <= kMostVoters;
  const double step = std::accumulate(area.begin(), area.end(), 0.0) / static_cast<double>(kMostVoters);
  std::vector<Voter> voters;
  double passed = 0.0;
  for (std::size_t i = 0; i < area.size(); ++i) {
    passed += area[i];
    const bool chosen = few || passed >= step * static_cast<double>(voters.size() + 1);
    if (chosen && area[i] > 0.0)
      voters.push_back({mesh.vertices[i], normal[i].normalized(), few ? area[i] : step});
  }
  return voters;
}

// The sphere through four points, if they are not in a plane.
std::optional<Trial> through_points(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Eigen::Matrix3d arms;
  arms << (b - a).transpose(), (c - a).transpose(), (d - a).transpose();
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(arms);
  if (!lu.isInvertible()) return std::nullopt;
  const Vec3 offset =
      lu.solve(0.5 * Vec3((b - a).squaredNorm(), (c - a).squaredNorm(), (d - a).squaredNorm()));
  return Trial{a + offset, offset.norm()};
}

// The sphere that best has both vertices on it and their normals along the radius: a - r m = b - r n.
std::optional<Trial> through_normals(const Voter& a, const Voter& b) {
  const Vec3 turned = a.normal - b.normal;
  if (turned.squaredNorm() < kParallel) return std::nullopt;
  const double radius = (a.x - b.x).dot(turned) / turned.squaredNorm();
  return Trial{0.5 * (a.x - radius * a.normal + b.x - radius * b.normal), std::abs(radius)};
}

// Area of the voters on a sphere, as a multiple of its squared radius.
double support(const std::vector<Voter>& voters, const Trial& trial, double tolerance) {
  double sum = 0.0;
  std::size_t votes = 0;
  for (const Voter& voter : voters) {
    const Vec3 arm = voter.x - trial.centre;
    const double length = arm.norm();
    if (std::abs(length - trial.radius) > tolerance * trial.radius) continue;
    if (std::abs(arm.dot(voter.normal)) < kAlongRadius * length) continue;
    sum += voter.area;
    ++votes;
  }
  const double fewest = std::max(kFewestVotes, kLeastShare * static_cast<double>(voters.size()));
  return static_cast<double>(votes) < fewest ? 0.0 : sum / (trial.radius * trial.radius);
}

double size_of(const std::vector<Voter>& voters) {
  Eigen::AlignedBox3d box;
  for (const Voter& voter : voters) box.extend(voter.x);
  return box.diagonal().norm();
}

// The best trial sphere; the sphere through all vertices where no trial finds support.
SphereFit best_trial(const TriangleMesh& mesh, const BallFitOptions& options) {
  SphereFit best;
  const std::vector<Voter> voters = voters_of(mesh);
  const double least = kSmallestSphere * size_of(voters);
  std::mt19937 random(options.seed);
  const auto pick = [&]() -> const Voter& { return voters[random() % voters.size()]; };
  double most = 0.0;
  for (int k = 0; k < options.trials && !voters.empty(); ++k) {
    const Voter& a = pick();
    const Voter& b = pick();
    const Voter& c = pick();
    const Voter& d = pick();
    const auto trial = k % 2 == 0 ? through_normals(a, b) : through_points(a.x, b.x, c.x, d.x);
    if (!trial || !(trial->radius > least)) continue;
    const double found = support(voters, *trial, options.start_tolerance);
    if (found <= most) continue;
    most = found;
    best.centre = trial->centre;
    best.radius = trial->radius;
  }
  if (most == 0.0) best = fit_sphere(mesh.vertices, vertex_areas(mesh));
  return best;
}

// Area (mm^2) that each vertex has in faces whose outer side looks away from the centre. The faces may all be
// inside out: the side with more area near the sphere counts as the outer one.
std::vector<double> outer_areas(const TriangleMesh& mesh, const SphereFit& fit) {
  std::vector<double> out(mesh.vertices.size(), 0.0);
  std::vector<double> in(mesh.vertices.size(), 0.0);
  double balance = 0.0;
  for (const Face& face : mesh.faces) {
    const Vec3 area = area_vector(mesh, face) / 6.0;
    const Vec3 arm = corner(mesh, face, 0) - fit.centre;
    const bool away = area.dot(arm) > 0.0;
    const bool near = std::abs(arm.norm() - fit.radius) <= kFirstTolerance * fit.radius;
    if (near) balance += away ? area.norm() : -area.norm();
    for (const VertexIndex v : face) (away ? out : in)[v] += area.norm();
  }
  return balance >= 0.0 ? out : in;
}

struct Region {
  std::vector<std::size_t> vertices;
  std::vector<Vec3> points;
  std::vector<double> weight;  // area, mm^2
};

Region region_of(const TriangleMesh& mesh, const SphereFit& fit) {
  const std::vector<double> area = outer_areas(mesh, fit);
  Region region;
  for (std::size_t i = 0; i < area.size(); ++i) {
    const double residual = (mesh.vertices[i] - fit.centre).norm() - fit.radius;
    if (area[i] == 0.0 || std::abs(residual) > fit.trim) continue;
    region.vertices.push_back(i);
    region.points.push_back(mesh.vertices[i]);
    region.weight.push_back(area[i]);
  }
  return region;
}

// Standard deviation of the residuals, estimated from their area-weighted median.
double robust_deviation(const Region& region, const SphereFit& fit) {
  std::vector<std::pair<double, double>> residual;  // and weight
  double total = 0.0;
  for (std::size_t i = 0; i < region.points.size(); ++i) {
    residual.emplace_back(std::abs((region.points[i] - fit.centre).norm() - fit.radius), region.weight[i]);
    total += region.weight[i];
  }
  std::ranges::sort(residual);
  double sum = 0.0;
  for (const auto& [size, weight] : residual) {
    sum += weight;
    if (sum >= 0.5 * total) return kNormalScale * size;
  }
  return 0.0;
}

// Is a socket about the centre of its head inside out? The first face along a ray from there comes into bone.
bool is_inside_out(const TriangleMesh& socket) {
  constexpr double kSame = 1.0 + 1e-6;  // share of a radius
  const NearFaces faces(socket, 0.0);
  double balance = 0.0;  // mm^2 that look away
  for (const Face& face : socket.faces) {
    const Vec3 middle = (corner(socket, face, 0) + corner(socket, face, 1) + corner(socket, face, 2)) / 3.0;
    const Vec3 area = area_vector(socket, face);
    if (middle.norm() <= kSame * faces.radius(middle.stableNormalized(), Layer::nearest))
      balance += area.dot(middle) > 0.0 ? area.norm() : -area.norm();
  }
  return balance > 0.0;
}

}  // namespace

SphereFit fit_ball(const TriangleMesh& mesh, const BallFitOptions& options) {
  SphereFit fit = best_trial(mesh, options);
  fit.trim = kFirstTolerance * fit.radius;
  std::vector<std::size_t> chosen;
  for (int k = 0; k < kMostRefinements; ++k) {
    Region region = region_of(mesh, fit);
    if (region.vertices == chosen) break;
    const double trim = fit.trim;
    if (region.points.size() < 4) throw std::invalid_argument("no sphere fits enough of its surface");
    fit = fit_sphere(region.points, region.weight);
    fit.trim = std::clamp(options.scales * robust_deviation(region, fit), kFinest * fit.radius,
                          std::min(options.trim * fit.radius, trim));
    chosen = std::move(region.vertices);
  }
  return fit;
}

SphereFit fit_socket(const TriangleMesh& socket, const SphereFit& head, const BallFitOptions& options) {
  TriangleMesh inside = relative_to({socket.vertices, {}}, head.centre);
  std::ranges::copy_if(socket.faces, std::back_inserter(inside.faces), [&](const Face& face) {
    const double from = corner(inside, face, 0).norm() / head.radius;
    return from > kSocketStart && from < kSocketEnd;
  });
  const double to_centre = is_inside_out(inside) ? 1.0 : -1.0;
  std::erase_if(inside.faces, [&](const Face& face) {
    return area_vector(inside, face).dot(corner(inside, face, 0)) * to_centre <= 0.0;
  });
  inside.vertices = socket.vertices;
  if (inside.faces.empty()) throw std::invalid_argument("no face of the socket looks to its centre");
  SphereFit fit = fit_ball(inside, options);
  const double apart = (fit.centre - head.centre).norm();
  if (apart > head.radius)
    throw std::invalid_argument(
        formatted("the sphere that fits the socket has its centre %.0f mm from that of the head", apart));
  return fit;
}

std::vector<double> sphere_deviations(const TriangleMesh& mesh, const SphereFit& fit) {
  std::vector<double> deviation;
  for (const Vec3& v : mesh.vertices) deviation.push_back((v - fit.centre).norm() - fit.radius);
  return deviation;
}

std::vector<bool> spherical_region(const TriangleMesh& mesh, const SphereFit& fit) {
  std::vector<bool> inside(mesh.vertices.size(), false);
  for (const std::size_t i : region_of(mesh, fit).vertices) inside[i] = true;
  return inside;
}

}  // namespace impinge
