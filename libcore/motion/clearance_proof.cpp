// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion/clearance_proof.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "files/formatted.hpp"

namespace impinge {
namespace {

constexpr double kTurnScale = 1 << 20;  // length of quaternions and half angles
constexpr double kSlackUnit = 1 << 30;
constexpr double kReadingOff = 4e-7;     // of the largest coordinate: sqrt(3) * 2e-7 (mesh/io.hpp), and some
constexpr double kCentreOff = 1e-8;      // mm: nine decimals of the centre, and the rounding of doubles
constexpr double kWidestCell = 16.0;     // degrees
constexpr double kNarrowestCell = 1e-3;  // degrees
constexpr int kFinestOfTurn = 12;        // level of leaves

double to_nine_decimals(double x) { return std::round(x * 1e9) / 1e9; }

Vec3 to_nine_decimals(const Vec3& x) {
  return {to_nine_decimals(x.x()), to_nine_decimals(x.y()), to_nine_decimals(x.z())};
}

UncertainMesh uncertain(const TriangleMesh& mesh, const Vec3& centre) {
  double largest = 0.0;
  for (const Vec3& x : mesh.vertices) largest = std::max(largest, (x + centre).cwiseAbs().maxCoeff());
  return {mesh, kReadingOff * largest + kCentreOff};
}

UncertainMesh moved(UncertainMesh surface, const Pose& pose) {
  for (Vec3& x : surface.mesh.vertices) x = to_socket(pose, x);
  return surface;
}

HalfAngle half_angle(double degrees) {
  if (degrees == 0.0) return {1, 0};
  const double half = 0.5 * degrees * kDegree;
  return {std::llround(kTurnScale * std::cos(half)), std::llround(kTurnScale * std::sin(half))};
}

// Twice the tangent of what is between two half angles.
double twice_tangent(const HalfAngle& from, const HalfAngle& to) {
  return 2.0 * static_cast<double>(from[0] * to[1] - from[1] * to[0]) /
         static_cast<double>(from[0] * to[0] + from[1] * to[1]);
}

// A turn with its outer and inner rotations and angles in whole numbers.
struct RoundedTurn {
  explicit RoundedTurn(const JointTurn& turn)
      : outer(integer_turn(turn.outer)), inner(integer_turn(turn.inner)), axis(turn.axis.array().round()) {}

  Eigen::Matrix3d at(const HalfAngle& half) const {
    const double angle = 2.0 * std::atan2(static_cast<double>(half[1]), static_cast<double>(half[0]));
    return rotation_of(outer) * Eigen::AngleAxisd(angle, axis).toRotationMatrix() * rotation_of(inner);
  }

  IntegerTurn outer;
  IntegerTurn inner;
  Vec3 axis;
};

double angle_between_deg(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::Quaterniond(a).angularDistance(Eigen::Quaterniond(b)) / kDegree;
}

ProofCell cell_between(double from_deg, double to_deg) {
  ProofCell cell;
  cell.from = half_angle(from_deg);
  cell.to = half_angle(to_deg);
  cell.at = half_angle(0.5 * (from_deg + to_deg));
  const double slack = std::max(twice_tangent(cell.from, cell.at), twice_tangent(cell.at, cell.to));
  cell.slack = static_cast<std::int64_t>(std::ceil(slack * kSlackUnit)) + 1;
  return cell;
}

// What is known of a turn before anything is proven.
ClearanceProof without_cells(const ProofJoint& joint, const JointTurn& turn, const RoundedTurn& rounded) {
  ClearanceProof proof;
  proof.centre = to_nine_decimals(joint.centre);
  proof.outer = rounded.outer;
  proof.inner = rounded.inner;
  for (std::size_t k = 0; k < 3; ++k)
    proof.axis[k] = static_cast<int>(rounded.axis[static_cast<Eigen::Index>(k)]);
  proof.rounded_deg = angle_between_deg(turn.outer, rotation_of(rounded.outer)) +
                      angle_between_deg(turn.inner, rotation_of(rounded.inner));
  return proof;
}

std::string numbers(const Vec3& x) { return formatted("%.9f %.9f %.9f", x.x(), x.y(), x.z()); }

template <class Range>
std::string whole_numbers(const Range& values) {
  std::string text;
  for (const auto value : values) text += " " + std::to_string(value);
  return text;
}

std::string bodies_text(const ClearanceProof& proof) {
  const auto [ball, socket] = proof.bodies;
  return ball + socket == 2 ? "" : formatted("bodies %zu %zu\n", ball, socket);
}

std::string cell_text(const ProofCell& cell) {
  std::string text = "cell " + std::string(name(cell.about)) + whole_numbers(cell.from) +
                     whole_numbers(cell.to) + whole_numbers(cell.at) + " " + std::to_string(cell.slack) +
                     (cell.slack == 0 ? "" : "/1073741824") + " " + std::to_string(cell.leaves.size()) + "\n";
  for (const ClearLeaf& leaf : cell.leaves) {
    text += std::to_string(leaf.face) + " " + std::to_string(leaf.level) +
            whole_numbers(std::array{leaf.i, leaf.j, leaf.radius}) + "\n";
  }
  return text;
}

}  // namespace

IntegerTurn integer_turn(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(rotation).normalized();
  if (rotation.isIdentity(0.0)) return {1, 0, 0, 0};
  return {std::llround(kTurnScale * q.w()), std::llround(kTurnScale * q.x()),
          std::llround(kTurnScale * q.y()), std::llround(kTurnScale * q.z())};
}

Eigen::Matrix3d rotation_of(const IntegerTurn& turn) {
  return Eigen::Quaterniond(static_cast<double>(turn[0]), static_cast<double>(turn[1]),
                            static_cast<double>(turn[2]), static_cast<double>(turn[3]))
      .normalized()
      .toRotationMatrix();
}

std::size_t ClearanceProof::leaves() const {
  std::size_t sum = 0;
  for (const ProofCell& cell : cells) sum += cell.leaves.size();
  return sum;
}

double ClearanceProof::end_deg() const {
  if (cells.empty()) return 0.0;
  const HalfAngle& end = cells.back().to;
  return 2.0 * std::atan2(static_cast<double>(end[1]), static_cast<double>(end[0])) / kDegree;
}

ClearanceProof prove_pose(const ProofJoint& joint, const Pose& pose) {
  ClearanceProof proof;
  proof.centre = to_nine_decimals(joint.centre);
  proof.shift = to_nine_decimals(pose.translation);
  proof.outer = integer_turn(pose.rotation);
  const Pose rounded{rotation_of(proof.outer), proof.shift};
  proof.rounded_deg = angle_between_deg(pose.rotation, rounded.rotation);
  const UncertainMesh ball = uncertain(joint.meshes.ball, joint.centre);
  const UncertainMesh socket = uncertain(joint.meshes.socket, joint.centre);
  for (const Surface about : {Surface::socket, Surface::ball}) {
    const bool own = about == Surface::ball;
    if (own && proof.shift.isZero(0.0)) break;
    const Vec3 origin = own ? proof.shift : Vec3::Zero();
    const UncertainMesh here = moved(ball, {rounded.rotation, rounded.translation - origin});
    const UncertainMesh there = moved(socket, {Eigen::Matrix3d::Identity(), -origin});
    LeafAnswer found = clear_leaves({here, there});
    if (!found.clear()) {
      proof.cells.clear();
      proof.ray = found.ray;
      proof.ray_from = about;
      proof.open = found.ray ? std::nullopt : found.open;
      return proof;
    }
    proof.cells.push_back({.about = about, .leaves = std::move(found.leaves)});
  }
  return proof;
}

ClearanceProof prove_turn(const ProofJoint& joint, const JointTurn& turn, double last_deg) {
  const RoundedTurn rounded(turn);
  ClearanceProof proof = without_cells(joint, turn, rounded);
  const UncertainMesh ball = uncertain(joint.meshes.ball, joint.centre);
  const UncertainMesh socket = uncertain(joint.meshes.socket, joint.centre);
  double at_deg = 0.0;
  double step_deg = kWidestCell;
  while (at_deg < last_deg) {
    const double to_deg = std::min(at_deg + step_deg, last_deg);
    ProofCell cell = cell_between(at_deg, to_deg);
    const UncertainMesh posed = moved(ball, {rounded.at(cell.at), Vec3::Zero()});
    LeafAnswer found =
        clear_leaves({posed, socket, static_cast<double>(cell.slack) / kSlackUnit, kFinestOfTurn});
    if (found.clear()) {
      cell.leaves = std::move(found.leaves);
      proof.cells.push_back(std::move(cell));
      at_deg = to_deg;
      step_deg = std::min(1.5 * step_deg, kWidestCell);
    } else if (step_deg < kNarrowestCell) {
      proof.open = found.open;
      return proof;
    } else {
      step_deg = 0.5 * (to_deg - at_deg);
    }
  }
  return proof;
}

std::string proof_text(const ClearanceProof& proof) {
  std::string text = std::string("impinge certificate 1 ") + (proof.ray ? "blocked" : "clear") + "\n" +
                     bodies_text(proof) + "centre " + numbers(proof.centre) + "\nshift " +
                     numbers(proof.shift) + "\nouter" + whole_numbers(proof.outer) + "\naxis" +
                     whole_numbers(proof.axis) + "\ninner" + whole_numbers(proof.inner) + "\nunit " +
                     std::to_string(kLeafUnit) + "\n";
  for (const ProofCell& cell : proof.cells) text += cell_text(cell);
  if (proof.ray)
    text += "ray " + std::string(name(proof.ray_from)) + " 1 0" + whole_numbers(*proof.ray) + "\n";
  return text + "end\n";
}

}  // namespace impinge
