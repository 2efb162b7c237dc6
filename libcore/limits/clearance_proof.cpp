// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/clearance_proof.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "files/formatted.hpp"

namespace impinge {
namespace {

constexpr double kTurnLength = 1 << 30;  // length of quaternions
constexpr double kReadingOff = 4e-7;  // share of the largest coordinate, above sqrt(3) * 2e-7 (mesh/io.hpp)
constexpr double kCentreOff = 1e-8;   // mm, above the rounding of the centre to nine decimals and of doubles

double to_nine_decimals(double x) { return std::round(x * 1e9) / 1e9; }

Vec3 to_nine_decimals(const Vec3& x) {
  return {to_nine_decimals(x.x()), to_nine_decimals(x.y()), to_nine_decimals(x.z())};
}

UncertainMesh uncertain(const TriangleMesh& mesh, const Vec3& centre) {
  double largest = 0.0;
  for (const Vec3& x : mesh.vertices) largest = std::max(largest, (x + centre).cwiseAbs().maxCoeff());
  return {mesh, kReadingOff * largest + kCentreOff};
}

double angle_between_deg(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::Quaterniond(a).angularDistance(Eigen::Quaterniond(b)) / kDegree;
}

CutMotion motion_of(const ClearanceProof& proof) {
  const Vec3 axis(proof.axis[0], proof.axis[1], proof.axis[2]);
  return {rotation_of(proof.outer), axis, rotation_of(proof.inner), proof.shift, proof.last};
}

// No surfaces meet: is nothing inside at the start of the motion? Radii that overlap at a sheet do not count
// here, and hide no other bodies.
ClearanceProof::Says with_insides(const BodyPairs& bodies, const CutMotion& motion) {
  const BodyPairs::Verdict found = bodies.verdict({motion.outer * motion.inner, motion.shift}, false);
  if (found.contact == Contact::no) return ClearanceProof::Says::clear;
  const bool proven = found.contact == Contact::yes && found.closed;
  return proven ? ClearanceProof::Says::inside : ClearanceProof::Says::unknown;
}

void prove(const ProofJoint& joint, ClearanceProof& proof) {
  proof.centre = to_nine_decimals(joint.centre);
  const UncertainMesh ball = uncertain(joint.meshes.ball, joint.centre);
  const UncertainMesh socket = uncertain(joint.meshes.socket, joint.centre);
  proof.closed = joint.bodies.closed();
  const CutMotion motion = motion_of(proof);
  CutAnswer found = clear_cuts(ball, socket, motion);
  if (found.crossing) {
    proof.says = ClearanceProof::Says::crossing;
    proof.faces = *found.crossing;
  } else if (found.open) {
    proof.place = found.open->place;
    proof.open_deg = found.open->degrees;
  } else {
    proof.says = with_insides(joint.bodies, motion);
    if (proof.says == ClearanceProof::Says::clear) proof.cuts = std::move(found.cuts);
  }
}

std::string numbers(const Vec3& x) { return formatted("%.9f %.9f %.9f", x.x(), x.y(), x.z()); }

template <class Range>
std::string whole_numbers(const Range& values) {
  std::string text;
  for (const auto value : values) text += " " + std::to_string(value);
  return text + "\n";
}

std::string cut_text(const ClearCut& cut) {
  const auto [x, y, z] = cut.along;
  switch (cut.kind) {
    case ClearCut::Kind::none:
      break;
    case ClearCut::Kind::plane:
      return "plane" + whole_numbers(std::array{x, y, z, cut.at});
    case ClearCut::Kind::sphere:
      return "sphere" + whole_numbers(std::array{cut.at});
    case ClearCut::Kind::turn:
      return "turn" + whole_numbers(std::array{x, y});
  }
  return "-\n";
}

std::string evidence_text(const ClearanceProof& proof) {
  if (proof.says == ClearanceProof::Says::crossing) return "cross" + whole_numbers(proof.faces);
  if (proof.says == ClearanceProof::Says::inside) return "inside\n";
  std::string text;
  for (const ClearCut& cut : proof.cuts) text += cut_text(cut);
  return text;
}

}  // namespace

IntegerTurn integer_turn(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(rotation).normalized();
  if (rotation.isIdentity(0.0)) return {1, 0, 0, 0};
  return {std::llround(kTurnLength * q.w()), std::llround(kTurnLength * q.x()),
          std::llround(kTurnLength * q.y()), std::llround(kTurnLength * q.z())};
}

Eigen::Matrix3d rotation_of(const IntegerTurn& turn) {
  return Eigen::Quaterniond(static_cast<double>(turn[0]), static_cast<double>(turn[1]),
                            static_cast<double>(turn[2]), static_cast<double>(turn[3]))
      .normalized()
      .toRotationMatrix();
}

ClearanceProof prove_pose(const ProofJoint& joint, const Pose& pose) {
  ClearanceProof proof;
  proof.shift = to_nine_decimals(pose.translation);
  proof.outer = integer_turn(pose.rotation);
  proof.rounded_deg = angle_between_deg(pose.rotation, rotation_of(proof.outer));
  prove(joint, proof);
  return proof;
}

ClearanceProof prove_turn(const ProofJoint& joint, const JointTurn& turn, double last_deg) {
  ClearanceProof proof;
  proof.outer = integer_turn(turn.outer);
  proof.inner = integer_turn(turn.inner);
  for (std::size_t k = 0; k < 3; ++k)
    proof.axis[k] = static_cast<int>(std::lround(turn.axis[static_cast<Eigen::Index>(k)]));
  proof.last = half_angle(last_deg);
  proof.rounded_deg = angle_between_deg(turn.outer, rotation_of(proof.outer)) +
                      angle_between_deg(turn.inner, rotation_of(proof.inner));
  prove(joint, proof);
  return proof;
}

std::string proof_text(const ClearanceProof& proof) {
  const bool clear = proof.says == ClearanceProof::Says::clear;
  return std::string("impinge certificate 2 ") + (clear ? "clear" : "contact") + "\nfiles" +
         whole_numbers(proof.files) + "centre " + numbers(proof.centre) + "\nshift " + numbers(proof.shift) +
         "\nouter" + whole_numbers(proof.outer) + "axis" + whole_numbers(proof.axis) + "inner" +
         whole_numbers(proof.inner) + "last" + whole_numbers(proof.last) + "unit " +
         std::to_string(kCutUnit) + "\n" + evidence_text(proof) + "end\n";
}

}  // namespace impinge
