// SPDX-License-Identifier: GPL-3.0-or-later
// How far a session's joint turns: limits of the meshes themselves, found without steps that could jump over
// a contact (limits/told_limit.hpp), and the smallest gaps on the way, by the tables.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "files/fields.hpp"
#include "joint/pose_answer.hpp"
#include "limits/told_limit.hpp"

namespace impinge {

/// One angle grows from a start.
struct LimitRequest {
  Motion start;                     // degrees
  std::string growing;              // of motion_names()
  double largest_deg = 360.0;       // of the growth; cut to largest_growth() (hip/motion.hpp)
  Vec3 translation = Vec3::Zero();  // shift of the ball, mm, input frame
  double cartilage_mm = 4.0;        // both layers together
};

/// One limit, and where it is reached.
struct LimitAnswer {
  const char* about;            // "ball" or "socket": about whose centre the ball turns
  Vec3 centre;                  // this centre, mm, input frame
  ToldLimit told;               // its bracket, and what half a millimetre changes
  std::optional<double> hours;  // where they touch, on the dial
  std::string ball_part;        // what of the ball touches there (hip/joint_places.hpp), or the name of its
                                // part (mesh/mesh_parts.hpp); empty without a contact
  std::string socket_part;      // the same of the socket
};

/// What meets what, as "rim and neck"; empty where nothing does.
std::string meets(const LimitAnswer& answer);
/// What a reader must know: what meets what, and a mark where half a millimetre changes the limit
/// (ToldLimit::hangs_on_less()) or the ball's mesh ends. The column `what` of limits.csv.
std::string what_of(const LimitAnswer& answer);

/// The limits of one growing angle.
struct LimitAnswers {
  double largest_deg = 0.0;           // of the growth that was looked at
  LimitAnswer contact;                // of contact, about the ball's centre
  std::optional<LimitAnswer> socket;  // about the centre of a sphere fitted to the socket; none if none fits
                                      // or the ball is shifted
  LimitAnswer cartilage;              // of a gap of cartilage_mm, about the ball's centre; `contact` if 0
};
LimitAnswers answer_limits(Session& session, const LimitRequest& request);

/// The smallest gap at each step to the largest angle, by the tables.
struct Sweep {
  std::vector<double> angles;    // of the growth, degrees
  std::vector<double> smallest;  // mm, NaN where the surfaces do not face each other
};
Sweep sweep(Session& session, const LimitRequest& request, double step_deg);

/// What is asked of several motions.
struct LimitsRequest {
  std::vector<std::string> motions;
  std::optional<Motion> pose;
  double largest_deg = 360.0;
  std::optional<Vec3> translation;
  double cartilage_mm = 4.0;

  static constexpr auto fields() {
    using Asked = LimitsRequest;
    return std::tuple{
        Field{"motions", "",
              "what grows: flexion, extension, abduction, adduction, internal_rotation, external_rotation "
              "from `pose`; or from a "
              "pose of its own internal_rotation_at_45, _70 or _90, external_rotation_at_90, fadir, faber "
              "[all; with a pose, the first six]",
              &Asked::motions},
        Field{"pose", "", "where motions begin, as flexion=90 [the pose of the scan]", &Asked::pose},
        Field{"largest_deg", "deg", "growth that is looked at", &Asked::largest_deg, kPositive},
        Field{"translation", "mm", "X,Y,Z by which the ball is shifted first, frame of the meshes [none]",
              &Asked::translation},
        Field{"cartilage_mm", "mm", "thickness of both layers together", &Asked::cartilage_mm, kNotNegative}};
  }
  /// std::invalid_argument for a motion that there is not, and for a pose of one that has its own.
  void check() const;
  /// Gaps up to this are asked about, too.
  double threshold_mm() const { return cartilage_mm; }
  static constexpr const char* kThresholdOption = "--cartilage";
};

/// A row of limits.csv.
struct LimitRow {
  std::string motion;
  double threshold_mm = 0.0;
  std::string_view centre;
  LimitState state = LimitState::unknown;
  double low_deg = 0.0;
  double high_deg = 0.0;
  double centre_low_deg = 0.0;
  std::optional<double> centre_high_deg;
  std::optional<double> half_mm_gap_deg;
  std::optional<std::string> clock;
  std::string what;

  static constexpr auto fields() {
    using Row = LimitRow;
    return std::tuple{
        Field{"motion", "", "what grows", &Row::motion},
        Field{"threshold_mm", "mm", "0: contact of the surfaces; else the gap of a vertex",
              &Row::threshold_mm},
        Field{"centre", "", "about whose centre the ball turns: ball or socket", &Row::centre},
        Field{"state", "",
              "limited; free up to the largest angle; blocked from the start; unknown beyond low_deg",
              &Row::state},
        Field{"low_deg", "deg", "free up to here", &Row::low_deg},
        Field{"high_deg", "deg", "where limited, not free here", &Row::high_deg},
        Field{"centre_low_deg", "deg", "free up to here for every common centre within 0.5 mm",
              &Row::centre_low_deg},
        Field{"centre_high_deg", "deg", "and not free here for any; null where that is not known",
              &Row::centre_high_deg},
        Field{"half_mm_gap_deg", "deg", "where the gap of a vertex first falls to 0.5 mm",
              &Row::half_mm_gap_deg},
        Field{"clock", "", "where on the rim's clock they touch", &Row::clock},
        Field{"what", "", "what meets what, and what a reader must know", &Row::what}};
  }
};

/// A limit in a document.
struct LimitDocument : LimitRow {
  Motion start;
  double largest_deg = 0.0;
  Vec3 centre_of_rotation = Vec3::Zero();
  double play_low_deg = 0.0;
  std::optional<double> play_high_deg;
  bool hangs_on_less_than_half_mm = false;
  std::optional<double> leaves_ball_mesh_deg;
  std::optional<std::string> ball_part;
  std::optional<std::string> socket_part;
  std::optional<std::string> meets;
  std::optional<Vec3> position;
  std::optional<ContactKind> contact;

  static constexpr auto fields() {
    using Limit = LimitDocument;
    return std::tuple_cat(
        LimitRow::fields(),
        std::tuple{Field{"start", "", "pose that the motion begins at", &Limit::start},
                   Field{"largest_deg", "deg", "growth that was looked at", &Limit::largest_deg},
                   Field{"centre_of_rotation", "mm", "x, y, z in the frame of the meshes",
                         &Limit::centre_of_rotation},
                   Field{"play_low_deg", "deg", "free up to here for every play of the ball up to 0.5 mm",
                         &Limit::play_low_deg},
                   Field{"play_high_deg", "deg", "and not free here for any; null where that is not known",
                         &Limit::play_high_deg},
                   Field{"hangs_on_less_than_half_mm", "",
                         "does half a millimetre change it by more than 5 degrees?",
                         &Limit::hangs_on_less_than_half_mm},
                   Field{"leaves_ball_mesh_deg", "deg", "from here on the ball's mesh ends under the socket",
                         &Limit::leaves_ball_mesh_deg},
                   Field{"ball_part", "", "what of the ball's bone touches; null without a contact",
                         &Limit::ball_part},
                   Field{"socket_part", "", "what of the socket's bone touches", &Limit::socket_part},
                   Field{"meets", "", "what meets what, as rim and neck", &Limit::meets},
                   Field{"position", "mm", "x, y, z where they touch, frame of the meshes", &Limit::position},
                   Field{"contact", "", "how they touch", &Limit::contact}});
  }
};

struct LimitsAnswer {
  double centre_within_mm = 0.0;
  std::vector<LimitDocument> limits;

  static constexpr auto fields() {
    return std::tuple{
        Field{"centre_within_mm", "mm", "how far off centres and play may be in the ranges",
              &LimitsAnswer::centre_within_mm},
        Field{"limits", "", "of each motion: contact about both centres, and the gap of the cartilage",
              &LimitsAnswer::limits}};
  }
};

/// The limits of one growing angle, under the name of a motion.
std::vector<LimitDocument> documents_of(const SessionJoint& joint, std::string_view motion,
                                        const LimitRequest& asked, const LimitAnswers& found);

/// std::invalid_argument where a motion needs a side, or nothing is left to grow.
LimitsAnswer answer(Session& session, const LimitsRequest& request);

}  // namespace impinge
