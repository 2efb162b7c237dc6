// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

#include "files/formatted.hpp"

namespace impinge {
namespace {

constexpr double kClosest = 20.0;  // mm between landmarks of one bone: closer ones do not tell a direction
constexpr double kWidestPelvis = 600.0;  // mm between ASIS: no human has half of it, so it is another unit
constexpr double kWidestKnee = 250.0;    // mm between epicondyles: no human has half of it
// Widths of the knee from the knee to the hip; a human has five to nine. A farther centre is of another scan.
constexpr double kFarthest = 20.0;

[[noreturn]] void refuse(const std::string& reason) { throw std::invalid_argument(reason); }

const Vec3& required(const std::optional<Vec3>& point, const std::string& name) {
  if (!point) refuse("the landmark " + name + " is missing; mark it");
  return *point;
}

void require_apart(const Vec3& from, const Vec3& to, const std::string& names, double widest) {
  const double apart = (to - from).norm();
  if (apart < kClosest) refuse("the landmarks " + names + " are closer than 20 mm; check them");
  if (apart > widest)
    refuse("the landmarks " + names + formatted(" are %.0f mm apart; give all places in mm", apart));
}

// A point on the line through two others does not define a plane.
void require_beside(const Vec3& point, const Vec3& from, const Vec3& to, const std::string& names) {
  if ((to - from).normalized().cross(point - from).norm() < kClosest)
    refuse("the landmarks " + names + " lie on one line within 20 mm; check them");
}

// Rows right, anterior, superior. The first keeps its direction, the third nearly.
Eigen::Matrix3d frame_of(const Vec3& right, const Vec3& superior) {
  Eigen::Matrix3d rows;
  const Vec3 x = right.normalized();
  const Vec3 y = superior.cross(x).normalized();
  rows << x.transpose(), y.transpose(), x.cross(y).transpose();
  return rows;
}

// Rows right, anterior, superior; the third keeps its direction.
Eigen::Matrix3d upright(const Vec3& right, const Vec3& superior) {
  Eigen::Matrix3d rows;
  const Vec3 z = superior.normalized();
  const Vec3 y = z.cross(right).normalized();
  rows << y.cross(z).transpose(), y.transpose(), z.transpose();
  return rows;
}

Eigen::Matrix3d pelvis_of(const Landmarks& landmarks, const Vec3& centre, std::optional<Side> side,
                          const Eigen::Matrix3d& axes) {
  const Vec3& right = required(landmarks.asis_right, "asis_right");
  const Vec3& left = required(landmarks.asis_left, "asis_left");
  const Vec3 pubis = 0.5 * (required(landmarks.pubic_tubercle_right, "pubic_tubercle_right") +
                            required(landmarks.pubic_tubercle_left, "pubic_tubercle_left"));
  const Vec3 middle = 0.5 * (right + left);
  require_apart(left, right, "asis_left and asis_right", kWidestPelvis);
  require_beside(pubis, left, right, "of the ASIS and of the pubic tubercles");
  if ((axes * (right - left)).x() <= 0.0 ||
      (*landmarks.pubic_tubercle_right - *landmarks.pubic_tubercle_left).dot(right - left) < 0.0)
    refuse(
        "the right landmarks of the pelvis lie to the left of the left ones; check the labels and the axes");
  if ((axes * (middle - pubis)).z() <= 0.0)
    refuse("the ASIS lie below the pubic tubercles; check the labels and the axes");
  const double lateral = (centre - middle).dot((right - left).normalized());
  if (side && (*side == Side::right ? lateral : -lateral) < -kClosest)
    refuse(
        "the centre of rotation lies on the other side of the middle of both ASIS; check the side and the "
        "axes, and that landmarks and meshes are of one scan");
  return frame_of(right - left, middle - pubis);
}

Eigen::Matrix3d femur_of(const Landmarks& landmarks, const Vec3& centre, Side side,
                         const Eigen::Matrix3d& pelvis) {
  const Vec3& medial = required(landmarks.epicondyle_medial, "epicondyle_medial");
  const Vec3& lateral = required(landmarks.epicondyle_lateral, "epicondyle_lateral");
  const Vec3 knee = 0.5 * (medial + lateral);
  require_apart(medial, lateral, "epicondyle_medial and epicondyle_lateral", kWidestKnee);
  require_beside(centre, medial, lateral, "of the epicondyles and the centre of rotation");
  if ((knee - centre).norm() > kFarthest * (lateral - medial).norm())
    refuse(
        "the epicondyles are too far from the centre of rotation for a femur; check that landmarks and "
        "meshes are of one scan");
  const Vec3 at = pelvis * (knee - centre);
  if (at.z() > 0.0 && at.y() < 0.5 * at.z())  // flexed by more than 153 degrees, or extended by 90
    refuse("the knee lies above the hip, and behind; check the labels and the axes");
  const Vec3 right = side == Side::right ? Vec3(lateral - medial) : Vec3(medial - lateral);
  if (right.dot(pelvis.row(0)) <= 0.0)
    refuse("the lateral epicondyle lies medially; check the labels, the side and the axes");
  return upright(right, centre - knee);
}

}  // namespace

Motion motion_of_rotation(const Eigen::Matrix3d& rotation, Side side) {
  // R = Rx(f) Ry(-+a) Rz(+-i): its last column is (sin b, -sin f cos b, cos f cos b), its first row
  // (cos b cos c, -cos b sin c, sin b).
  const double mirror = side == Side::left ? -1.0 : 1.0;
  const double b = std::asin(std::clamp(rotation(0, 2), -1.0, 1.0));
  Motion motion;
  motion.flexion = std::atan2(-rotation(1, 2), rotation(2, 2)) / kDegree;
  motion.abduction = -mirror * b / kDegree;
  motion.internal_rotation = mirror * std::atan2(-rotation(0, 1), rotation(0, 0)) / kDegree;
  return motion;
}

AnatomicalFrames anatomical_frames(const Landmarks& landmarks, const Vec3& centre, std::optional<Side> side,
                                   const Eigen::Matrix3d& axes) {
  AnatomicalFrames frames;
  frames.pelvis = pelvis_of(landmarks, centre, side, axes);
  const Vec3 up = axes * frames.pelvis.row(2).transpose();
  frames.pelvic_tilt_deg = std::atan2(up.y(), up.z()) / kDegree;
  if (!landmarks.epicondyle_medial && !landmarks.epicondyle_lateral) return frames;
  if (!side) refuse("which epicondyle is lateral hangs on the side; give left or right");
  frames.femur = femur_of(landmarks, centre, *side, frames.pelvis);
  frames.scanned = motion_of_rotation(frames.pelvis * frames.femur->transpose(), *side);
  return frames;
}

}  // namespace impinge
