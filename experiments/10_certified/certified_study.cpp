// SPDX-License-Identifier: GPL-3.0-or-later
#include "10_certified/certified_study.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "files/file_bytes.hpp"
#include "files/stopwatch.hpp"
#include "harness/statistics.hpp"
#include "methods/cgal.hpp"
#include "reference/shadow.hpp"

namespace impinge::lab {
namespace {

constexpr double kMicrometres = 1000.0;  // in a millimetre

std::filesystem::path witness_file(const CertifiedStudy& study) {
  return study.folder / "certified_witness.json";
}

// Counts a wrong verdict and keeps the pose of the first.
void refute(CertifiedStudy& study, const std::string& joint, const Pose& pose, const std::string& what) {
  if (study.wrong++ > 0) return;
  nlohmann::json witness{{"joint", joint}, {"wrong", what}};
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) witness["rotation"].push_back(pose.rotation(i, k));
    witness["translation_mm"].push_back(pose.translation[i]);
  }
  write_if_changed(witness_file(study), witness.dump(2) + "\n");
}

JudgedPose judge(const SurfaceOverlay& joint, const Pose& pose) {
  TriangleMesh ball = joint.ball();
  for (Vec3& x : ball.vertices) x = to_socket(pose, x);
  TriangleMesh socket = joint.socket();
  for (Vec3& y : socket.vertices) y = to_ball(pose, y);
  const ShadowReference at_socket(ball, joint.socket());
  const ShadowReference at_ball(joint.ball(), socket);
  return {pose, at_socket.ball_vertices_impinged(), at_ball.socket_vertices_impinged(),
          at_socket.ball_beyond_socket() || at_ball.socket_within_ball()};
}

// What all poses of a joint say about its surfaces.
struct PoseSummary {
  std::size_t impinged = 0;
  std::size_t common_point = 0;  // by CGAL
  std::vector<double> missed;    // mm, how deep surfaces are in each other whose vertices are all clear
  std::size_t wrong = 0;
  std::vector<double> later;  // mm of the way, from the contact of the surfaces to that of a vertex
  double overlay_s = 0.0;
};

// How much farther a motion goes before a vertex is impinged.
void add_delay(const SurfaceOverlay& joint, const ContactPose& pose, PoseSummary& summary) {
  if (!pose.contact) return;
  const auto by_vertices =
      first_contact(pose.path, [&joint](const Pose& at) { return vertices_impinged(joint, at); });
  if (by_vertices)
    summary.later.push_back(std::max(0.0, *by_vertices - *pose.contact) * path_length(pose.path));
}

void add_pose(CertifiedStudy& study, CertifiedJoint& joint, const Touch& tree, const Pose& pose,
              PoseSummary& summary) {
  JudgedPose judged = judge(joint.overlay, pose);
  Stopwatch watch;
  const bool impinged = joint.overlay.impinged(pose);
  summary.overlay_s += watch.lap_s();
  const bool common = tree(pose);
  if (impinged != judged.surfaces || (common && !impinged)) {
    refute(study, joint.name, pose, "the surfaces have the wrong verdict");
    ++summary.wrong;
  }
  summary.common_point += common ? 1U : 0U;
  summary.impinged += impinged ? 1U : 0U;
  if (impinged && !judged.vertices()) {
    const auto deepest = joint.overlay.deepest(pose);
    summary.missed.push_back(deepest ? deepest->depth : 0.0);
  }
  joint.poses.push_back(std::move(judged));
}

std::vector<Column> scheme_columns() {
  return {{"joint", "", "generated pair with the faces of each model, or a real joint"},
          {"scheme", "", "name of the sampling scheme"},
          {"precision_deg", "deg", "spacing of the entries at the equator"},
          {"poses", "1", "poses of the joint that were scanned"},
          {"vertices", "1", "vertices of both surfaces over all poses"},
          {"clear", "1", "of these, proven clear by the ranges"},
          {"impinged", "1", "of these, proven impinged by the ranges"},
          {"undecided", "1", "of these, left to the exact test"},
          {"wrong", "1", "verdicts that the oracle refutes, before and after the exact test"},
          {"crossings_matter", "1",
           "of all poses of the joint, with every vertex clear and the surfaces impinged"},
          {"largest_missed_um", "um", "how deep the surfaces are in each other in the worst of these"},
          {"ns_per_vertex_certified", "ns", "both scans and the exact test of what is left, a vertex"}};
}

std::vector<Column> pose_columns() {
  return {{"joint", "", "generated pair with the faces of each model, or a real joint"},
          {"ball_faces", "1", "faces of the ball"},
          {"socket_faces", "1", "faces of the socket"},
          {"poses", "1", "poses examined"},
          {"clear", "1", "of these, with surfaces that are clear"},
          {"impinged", "1", "of these, with surfaces that impinge"},
          {"common_point", "1", "of these, with surfaces that meet in a point (CGAL)"},
          {"wrong", "1", "verdicts on surfaces that the oracle refutes"},
          {"crossings_matter", "1", "poses with every vertex clear and the surfaces impinged"},
          {"median_missed_um", "um", "median of how deep the surfaces are in each other in these"},
          {"largest_missed_um", "um", "the deepest of these"},
          {"ways", "1", "motions followed to the contact of the surfaces and on to that of a vertex"},
          {"median_later_um", "um", "median of the way between the two, of a point 25 mm from the centre"},
          {"largest_later_um", "um", "the longest"},
          {"us_per_pose", "us", "the exact verdict on the surfaces of a pose"}};
}

void add_pose_row(CertifiedStudy& study, const CertifiedJoint& joint, const PoseSummary& summary) {
  const auto poses = static_cast<double>(joint.poses.size());
  study.poses.add_row({joint.name, joint.overlay.ball().faces.size(), joint.overlay.socket().faces.size(),
                       joint.poses.size(), joint.poses.size() - summary.impinged, summary.impinged,
                       summary.common_point, summary.wrong, joint.crossings_matter,
                       kMicrometres * quantile(summary.missed, 0.5), kMicrometres * joint.largest_missed,
                       summary.later.size(), kMicrometres * quantile(summary.later, 0.5),
                       kMicrometres * quantile(summary.later, 1.0), 1e6 * summary.overlay_s / poses});
}

}  // namespace

bool JudgedPose::vertices() const {
  return std::ranges::find(ball, true) != ball.end() || std::ranges::find(socket, true) != socket.end();
}

CertifiedStudy make_certified_study(const std::filesystem::path& folder) {
  CertifiedStudy study;
  study.folder = folder;
  study.schemes.columns = scheme_columns();
  study.poses.columns = pose_columns();
  return study;
}

void require_none_wrong(const CertifiedStudy& study) {
  if (study.wrong == 0) return;
  throw std::runtime_error(std::to_string(study.wrong) +
                           " certified verdicts are wrong: the pose of the first is kept in " +
                           witness_file(study).string());
}

CertifiedJoint judge_joint(CertifiedStudy& study, std::string name, const BallSocketPair& meshes,
                           const ContactOptions& options) {
  CertifiedJoint joint{std::move(name), SurfaceOverlay(meshes.ball, meshes.socket), {}, 0, 0.0};
  const auto tree = make_cgal_tree(meshes.ball, meshes.socket);
  PoseSummary summary;
  const std::vector<ContactPose> poses = contact_poses(joint.overlay, options);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    add_pose(study, joint, tree, poses[k].pose, summary);
    if (k % kPosesPerPath == 0 && k / kPosesPerPath < options.ways)
      add_delay(joint.overlay, poses[k], summary);
  }
  joint.crossings_matter = summary.missed.size();
  joint.largest_missed = summary.missed.empty() ? 0.0 : std::ranges::max(summary.missed);
  add_pose_row(study, joint, summary);
  return joint;
}

std::size_t count_wrong(CertifiedStudy& study, const CertifiedJoint& joint, const JudgedPose& judged,
                        std::span<const CertifiedGap> ball, std::span<const CertifiedGap> socket) {
  const std::size_t before = study.wrong;
  const auto check = [&](std::span<const CertifiedGap> gaps, const std::vector<bool>& impinged,
                         const char* surface) {
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      if (gaps[i].verdict == Verdict::undecided || (gaps[i].verdict == Verdict::impinged) == impinged[i])
        continue;
      refute(study, joint.name, judged.pose,
             std::string(surface) + " vertex " + std::to_string(i) + " has the wrong verdict");
    }
  };
  check(ball, judged.ball, "ball");
  check(socket, judged.socket, "socket");
  return study.wrong - before;
}

void add_scheme_row(CertifiedStudy& study, const CertifiedJoint& joint, std::string_view scheme,
                    double precision_deg, const SchemeVerdicts& found) {
  const VerdictCount& count = found.vertices;
  const std::size_t vertices = count.clear + count.impinged + count.undecided;
  study.schemes.add_row({joint.name, scheme, precision_deg, found.poses, vertices, count.clear,
                         count.impinged, count.undecided, found.wrong, joint.crossings_matter,
                         kMicrometres * joint.largest_missed,
                         1e9 * found.seconds / static_cast<double>(vertices)});
}

}  // namespace impinge::lab
