// SPDX-License-Identifier: GPL-3.0-or-later
// Every joint of the folder that IMPINGE_BONES names, as whole bones, cropped, and in parts, about its
// described centre and in the joint frame; and oracles of what meets: CGAL with exact predicates, and the
// solid angle for what is inside.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "joint/joint_folder.hpp"
#include "joint/limits.hpp"
#include "joint/session.hpp"
#include "mesh/io.hpp"
#include "mesh/validation.hpp"

namespace impinge::test {

// Of the joints in that folder, for a test of each: the first, the ninth and so on for 0. None without it.
inline constexpr std::size_t kShares = 8;
inline std::vector<JointFolder> joints_of(std::size_t share) {
  const char* bones = std::getenv("IMPINGE_BONES");  // NOLINT(concurrency-mt-unsafe)
  std::vector<JointFolder> of;
  const std::vector<JointFolder> all = bones == nullptr ? of : find_joints(bones).joints;
  for (std::size_t k = share; k < all.size(); k += kShares) of.push_back(all[k]);
  return of;
}

// Which of its files a joint is made of.
struct BoneVariant {
  std::string name;
  JointInput input;   // joint frame, about the centre, mm
  TriangleMesh ball;  // all of it in one mesh
  TriangleMesh socket;
};

// The main surface is the faces within a distance of the centre, mm; the others become its first part.
inline void part_beyond(NamedMesh& bone, double within) {
  const TriangleMesh whole = std::exchange(bone.mesh, {});
  std::array<TriangleMesh, 2> sides{whole, whole};
  for (const bool beyond : {false, true}) {
    std::erase_if(sides[beyond].faces, [&](const Face& face) {
      const Vec3 middle = corner(whole, face, 0) + corner(whole, face, 1) + corner(whole, face, 2);
      return (middle.norm() > 3.0 * within) != beyond;
    });
  }
  bone.mesh = sides[0];
  append_part(bone.mesh, bone.parts, "rest", sides[1]);
}

// Whole, or what comes nearest to it; cropped to what looks at the other; with both sides of the socket's
// wall; and the whole bones cut round the head, with the rest as a part.
inline std::vector<BoneVariant> variants(const JointFolder& joint) {
  const std::filesystem::path folder = joint.ball.parent_path();
  const Eigen::Matrix3d axes = input_to_joint(joint.axes.value_or("RAS"));
  const auto first = [&](const std::vector<const char*>& names, const std::filesystem::path& otherwise) {
    for (const char* name : names)
      if (std::filesystem::exists(folder / name)) return folder / name;
    return otherwise;
  };
  std::vector<BoneVariant> made;
  const auto add = [&](const char* name, const std::filesystem::path& ball,
                       const std::filesystem::path& socket) {
    BoneVariant one{name, {}, read_mesh(ball), read_mesh(socket)};
    for (TriangleMesh* mesh : {&one.ball, &one.socket})
      for (Vec3& x : mesh->vertices) x = axes * (x - joint.centre.value());
    one.input.ball = {"ball", one.ball};
    one.input.socket = {"socket", one.socket};
    one.input.centre = Vec3::Zero();
    one.input.side = joint.side;
    made.push_back(std::move(one));
  };
  const auto bone = first({"femur.ply", "humerus.ply"}, joint.ball);
  const auto walls = first({"acetabulum.ply", "glenoid.ply"}, joint.socket);
  add("whole", bone, first({"pelvis.ply", "scapula.ply"}, walls));
  add("cropped", joint.ball, joint.socket);
  add("two walls", joint.ball, walls);
  if (bone != joint.ball) {
    BoneVariant parts = made.front();
    parts.name = "parts";
    part_beyond(parts.input.ball, 1.45 * joint.radius.value());
    if (first({"pelvis.ply", "scapula.ply"}, walls) != walls)
      part_beyond(parts.input.socket, 1.45 * joint.radius.value());
    made.push_back(std::move(parts));
  }
  return made;
}

inline CentredLimits limits_of(const Joint& joint) {
  return {joint, BallSocketPair{joint.ball.mesh, joint.socket.mesh}, Vec3::Zero()};
}

inline Pose pose_at(const JointTurn& turn, double degrees) {
  return {turn.outer * Eigen::AngleAxisd(degrees * kDegree, turn.axis).toRotationMatrix() * turn.inner,
          Vec3::Zero()};
}

// Have two surfaces a common point, one of them moved? A tree of boxes finds pairs of faces, and exact signs
// decide.
class ExactMeeting {
 public:
  ExactMeeting(const TriangleMesh& moved, const TriangleMesh& fixed)
      : moved_(moved), fixed_(triangles(fixed)) {
    tree_.insert(fixed_.cbegin(), fixed_.cend());
    tree_.build();
    // Those in one cube, with a ball round them.
    std::map<std::array<int, 3>, std::vector<Face>> cubes;
    for (const Face& face : moved.faces) {
      const Vec3& a = corner(moved, face, 0);
      if (CGAL::collinear(point(a), point(corner(moved, face, 1)), point(corner(moved, face, 2)))) continue;
      const Eigen::Vector3i at = (a / kCube).array().floor().cast<int>();
      cubes[{at.x(), at.y(), at.z()}].push_back(face);
    }
    for (auto& [at, faces] : cubes) {
      const Vec3 middle = kCube * (Vec3(at[0], at[1], at[2]).array() + 0.5).matrix();
      double radius = 0.0;
      for (const Face& face : faces)
        for (const VertexIndex v : face) radius = std::max(radius, (moved.vertices[v] - middle).norm());
      runs_.push_back({middle, radius, std::move(faces)});
    }
  }
  ExactMeeting(const ExactMeeting&) = delete;  // the tree is of what is here
  ExactMeeting& operator=(const ExactMeeting&) = delete;

  // Of corners that are moved in doubles, as gap/pose.hpp has it: what contact is decided of.
  bool of_doubles(const Pose& pose) const { return meets<Rounding, double>(pose); }
  // Of the corners themselves, moved by the numbers of the pose without any rounding.
  bool of_reals(const Pose& pose) const { return meets<Exact, Exact::FT>(pose); }

 private:
  using Rounding = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Triangles = std::vector<Rounding::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Rounding, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Rounding, Primitive>>;
  static constexpr double kCube = 2.0;    // mm
  static constexpr double kWider = 1e-6;  // mm, more than rounding
  struct Run {
    Vec3 middle;
    double radius;
    std::vector<Face> faces;
  };

  static Rounding::Point_3 point(const Vec3& x) { return {x.x(), x.y(), x.z()}; }
  static Triangles triangles(const TriangleMesh& mesh) {
    Triangles list;
    for (const Face& f : mesh.faces) {
      const Rounding::Triangle_3 one(point(corner(mesh, f, 0)), point(corner(mesh, f, 1)),
                                     point(corner(mesh, f, 2)));
      if (!one.is_degenerate()) list.push_back(one);
    }
    return list;
  }
  template <class Field>
  static std::array<Field, 3> moved(const Pose& pose, const Vec3& x) {
    std::array<Field, 3> y;
    for (int k = 0; k < 3; ++k) {
      const auto term = [&](int l) { return Field(pose.rotation(k, l)) * Field(x[l]); };
      y[static_cast<std::size_t>(k)] = ((term(0) + term(1)) + term(2)) + Field(pose.translation[k]);
    }
    return y;
  }
  template <class Of, class Field>
  bool meets(const Pose& pose) const {
    const auto at = [](const auto& p) { return typename Of::Point_3(p[0], p[1], p[2]); };
    return std::ranges::any_of(runs_, [&](const Run& run) {
      const Vec3 middle = pose.rotation * run.middle + pose.translation;
      const Vec3 low = middle.array() - run.radius - kWider;
      const Vec3 high = middle.array() + run.radius + kWider;
      if (!tree_.do_intersect(CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z())))
        return false;
      return std::ranges::any_of(run.faces, [&](const Face& face) {
        std::array<typename Of::Point_3, 3> c;
        for (std::size_t k = 0; k < 3; ++k) c[k] = at(moved<Field>(pose, moved_.vertices[face[k]]));
        const typename Of::Triangle_3 one(c[0], c[1], c[2]);
        std::vector<Tree::Primitive_id> near;
        tree_.all_intersected_primitives(one.bbox(), std::back_inserter(near));
        return std::ranges::any_of(near, [&](const auto& other) {
          const auto& [a, b, d] = std::tie((*other)[0], (*other)[1], (*other)[2]);
          return CGAL::do_intersect(one, typename Of::Triangle_3(at(a), at(b), at(d)));
        });
      });
    });
  }

  const TriangleMesh& moved_;
  Triangles fixed_;
  Tree tree_;
  std::vector<Run> runs_;
};

// Of a closed mesh in one piece: is x within it? By the solid angle of all faces.
inline bool within(const TriangleMesh& mesh, const Vec3& x) {
  double sum = 0.0;
  for (const Face& f : mesh.faces) {
    const std::array<Vec3, 3> c{corner(mesh, f, 0) - x, corner(mesh, f, 1) - x, corner(mesh, f, 2) - x};
    const std::array<double, 3> n{c[0].norm(), c[1].norm(), c[2].norm()};
    sum += 2.0 * std::atan2(c[0].dot(c[1].cross(c[2])), n[0] * n[1] * n[2] + c[0].dot(c[1]) * n[2] +
                                                            c[1].dot(c[2]) * n[0] + c[2].dot(c[0]) * n[1]);
  }
  return std::abs(sum) > 2.0 * kPi;
}

// Where surfaces do not meet: is a closed body in one piece inside of another? It is with its lowest point.
inline bool holds(const TriangleMesh& mesh, const std::vector<Vec3>& of_other) {
  const Vec3 x = *std::ranges::min_element(of_other, {}, [](const Vec3& v) { return v.z(); });
  const double lowest = std::ranges::min(mesh.vertices, {}, [](const Vec3& v) { return v.z(); }).z();
  return x.z() > lowest && within(mesh, x);
}

inline bool closed(const TriangleMesh& mesh) {
  const MeshReport report = validate(mesh);
  return report.closed() && report.components == 1;
}

}  // namespace impinge::test
