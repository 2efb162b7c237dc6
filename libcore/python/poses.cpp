// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/poses.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

#include "gap/nearest_rotation.hpp"
#include "hip/pose_travel.hpp"
#include "python/arrays.hpp"
#include "python/joint_class.hpp"

namespace impinge::python {
namespace {

constexpr const char* kAdvice =
    "give angles in degrees of shape (n, 3), flexion, abduction and internal rotation, matrices of shape "
    "(n, 4, 4) or (n, 3, 4), or quaternions w, x, y, z of shape (n, 4), of which 3 or 4 need the shape (n, "
    "1, 4)";

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("poses: " + what + "; " + kAdvice);
}

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")); }

// Replaces NumPy's own message for text that is no number.
Doubles numbers_of(const py::object& given) {
  auto array = Doubles::ensure(given);
  if (!array) {
    PyErr_Clear();
    refuse("no array of numbers");
  }
  return array;
}

Motion motion_at(const double* angles) {
  for (int k = 0; k < 3; ++k) {
    if (!(std::abs(angles[k]) <= kLargestAngle))
      throw std::invalid_argument("poses: an angle is not within 180 degrees of 0");
  }
  return {angles[0], angles[1], angles[2]};
}

Pose turned(const SessionJoint& joint, const Motion& motion) {
  try {
    return pose_of(joint, motion);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("poses: ") + error.what() + " with side=");
  }
}

// Three or four quaternions have the shape of a matrix, so the message mentions them.
[[noreturn]] void refuse_matrix(const py::array& array, std::size_t place, const std::string& what) {
  throw std::invalid_argument("poses: matrix " + std::to_string(place) + " " + what +
                              (array.ndim() == 2 ? "; quaternions, 3 or 4, need the shape (n, 1, 4)" : ""));
}

Pose placed(const SessionJoint& joint, const py::array& array, const double* rows, std::size_t place) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> matrix(rows);
  const auto rotation = nearest_rotation(matrix.leftCols<3>());
  if (!rotation || !matrix.allFinite())
    refuse_matrix(array, place, "does not turn only: it is more than 0.0001 off from any rotation");
  return pose_about(joint.joint.centre, *rotation, matrix.col(3));
}

// A rotation about the centre, in the axes of the meshes.
Pose turned_by(const double* wxyz, std::size_t place) {
  const Eigen::Quaterniond given(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  if (!(std::abs(given.norm() - 1.0) <= kLargestLengthError))
    throw std::invalid_argument("poses: quaternion " + std::to_string(place) +
                                " has not the length 1; give w, x, y, z of unit length");
  return {given.normalized().toRotationMatrix(), Vec3::Zero()};
}

}  // namespace

std::vector<Pose> poses_of(const SessionJoint& joint, const py::object& given) {
  if (py::isinstance<py::str>(given)) return {turned(joint, parse_motion(given.cast<std::string>()))};
  const Doubles array = numbers_of(given);
  const auto size = [&array](py::ssize_t from_last) {
    return array.ndim() < from_last ? 0 : array.shape(array.ndim() - from_last);
  };
  const bool matrices =
      array.ndim() >= 2 && array.ndim() <= 3 && size(1) == 4 && (size(2) == 3 || size(2) == 4);
  const bool angles = array.ndim() >= 1 && array.ndim() <= 2 && size(1) == 3;
  const bool quaternions =
      !matrices && size(1) == 4 && (array.ndim() <= 2 || (array.ndim() == 3 && size(2) == 1));
  if (!matrices && !angles && !quaternions) refuse("an array of shape " + shape_text(array) + " holds none");
  if (angles && array.size() == 9 && nearest_rotation(Eigen::Map<const Eigen::Matrix3d>(array.data())))
    refuse("an array of shape (3, 3) that is a rotation would be read as three poses of angles");
  if (!angles && joint.joint.from_neutral())
    throw std::invalid_argument(
        "poses: matrices and quaternions begin at the pose of the scan, and landmarks of the femur at "
        "neutral; "
        "give angles, or leave the landmarks out");
  const auto stride = static_cast<std::size_t>(matrices ? 4 * size(2) : size(1));
  std::vector<Pose> poses(static_cast<std::size_t>(array.size()) / stride);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const double* row = array.data() + k * stride;
    if (stride == 16 && (row[12] != 0.0 || row[13] != 0.0 || row[14] != 0.0 || row[15] != 1.0))
      refuse_matrix(array, k, "has another last row than 0,0,0,1");
    poses[k] = matrices      ? placed(joint, array, row, k)
               : quaternions ? turned_by(row, k)
                             : turned(joint, motion_at(row));
  }
  if (!matrices) return poses;
  const std::string doubt =
      doubtful_travel(joint.joint, poses.size(), [&](std::size_t k) { return poses[k]; });
  warn(doubt.empty() ? doubt : "poses: " + doubt);
  return poses;
}

py::array matrices_of(const SessionJoint& joint, const std::vector<Pose>& poses) {
  py::array_t<double> matrices({static_cast<py::ssize_t>(poses.size()), py::ssize_t{4}, py::ssize_t{4}});
  const Vec3& centre = joint.joint.centre;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> m(matrices.mutable_data() + 16 * k);
    m.setIdentity();
    m.topLeftCorner<3, 3>() = poses[k].rotation;
    m.topRightCorner<3, 1>() = centre + poses[k].translation - poses[k].rotation * centre;
  }
  return matrices;
}

}  // namespace impinge::python
