// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>

#include "10_error_against_time/contact.hpp"
#include "contact/culled_joint.hpp"
#include "harness/contact_poses.hpp"
#include "methods/contact.hpp"
#include "sphere/uniform_directions.hpp"

namespace impinge::lab {
namespace {

class ContactReferee {
 public:
  explicit ContactReferee(const BallSocketPair& joint)
      : overlay_(joint.ball, joint.socket),
        culled_(joint),
        fcl_(std::ranges::find(cases_, "fcl_collide", &ContactCase::name)->make().touches) {}

  const CulledJoint& culled() const { return culled_; }

  void judge(const Pose& pose, Agreement& count) {
    const bool truth = vertices_impinged(overlay_, pose);
    const auto least = culled_.least_gap(pose);
    ++count.poses;
    count.impinged += truth ? 1U : 0U;
    const bool missed = !truth && overlay_.impinged(pose);
    count.missed += missed ? 1U : 0U;
    count.culled_wrong += culled_.impinged(pose).has_value() != truth ? 1U : 0U;
    count.least_gap_wrong += (least && least->gap_mm <= 0.0) != truth ? 1U : 0U;
    const bool contact = fcl_(pose);
    if (missed && !contact) ++count.unexplained;  // FCL misses what the faces have
    if (contact == truth) return;
    if (truth) {
      ++count.beyond;
    } else if (missed) {
      ++count.between_vertices;
    } else {
      ++count.unexplained;
    }
  }

 private:
  SurfaceOverlay overlay_;
  CulledJoint culled_;
  std::vector<ContactCase> cases_ = cases_of(contact_methods(), &Method::contact, culled_.meshes());
  Touch fcl_;
};

PosePath any_path(std::mt19937_64& random) {
  PosePath path;
  path.axis = uniform_direction(random);
  path.from_turn = path.to_turn = uniform(random);
  path.shift = 12.0 * uniform_direction(random);
  return path;
}

}  // namespace

Agreement contact_agreement(const BallSocketPair& joint, const AgreementOptions& options) {
  ContactReferee referee(joint);
  std::mt19937_64 random(options.seed);
  Agreement count;
  PosePath path;
  std::optional<double> contact;
  while (count.poses < options.poses) {
    if (count.poses % kPosesPerPath == 0) {
      path = any_path(random);
      contact =
          first_contact(path, [&](const Pose& pose) { return referee.culled().impinged(pose).has_value(); });
    }
    double share = uniform(random);
    if (contact && count.poses % 4 != 0) {
      const double off = std::pow(10.0, -5.0 + 4.5 * uniform(random)) / path_length(path);
      share = std::clamp(*contact + (uniform(random) < 0.5 ? -off : off), 0.0, 1.0);
    }
    referee.judge(path.at(share), count);
  }
  return count;
}

Table agreement_table(const AgreementOptions& options, const Agreement& agreement) {
  Table table{
      {{"triangles", "1", "of each of the two models"},
       {"poses", "1", "three of four within 10^-5 to 10^-0.5 mm of the first contact of a vertex"},
       {"impinged", "1", "poses in which the exact test of every vertex finds one that is impinged"},
       {"missed", "1", "poses in which it finds none and yet the surfaces impinge, by their exact overlay"},
       {"culled_wrong", "1", "poses in which the culled answer is another"},
       {"least_gap_wrong", "1", "poses in which the sign of the smallest gap, rounded, is another"},
       {"between_vertices", "1",
        "poses with a contact of the surfaces, by FCL and by their exact overlay, and of no vertex"},
       {"beyond", "1", "poses with a vertex beyond the other surface where FCL finds no contact of faces"},
       {"unexplained", "1", "poses in which FCL finds a contact and the exact overlay none"}},
      {}};
  table.add_row({options.triangles, agreement.poses, agreement.impinged, agreement.missed,
                 agreement.culled_wrong, agreement.least_gap_wrong, agreement.between_vertices,
                 agreement.beyond, agreement.unexplained});
  return table;
}

}  // namespace impinge::lab
