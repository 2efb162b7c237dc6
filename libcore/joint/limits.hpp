// SPDX-License-Identifier: GPL-3.0-or-later
// How far a session's joint turns. A limit is found on the meshes themselves, without steps that could jump
// over a contact (limits/told_limit.hpp); the tables give the smallest gaps on the way. Limits of the rim
// alone use only the faces that hip/joint_places.hpp keeps for it. On scans whose head and socket overlap
// they tell where the rim would meet neck, trochanter or shaft.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "files/fields.hpp"
#include "joint/session.hpp"
#include "limits/told_limit.hpp"

namespace impinge {

/// One angle grows from a start.
struct LimitRequest {
  Motion start;                     // degrees
  std::string growing;              // of motion_names()
  std::string_view motion{};        // its name in answers; `growing` where it is empty
  double largest_deg = 360.0;       // of the growth; cut to largest_growth() (hip/motion.hpp)
  Vec3 translation = Vec3::Zero();  // shift of the ball, mm, input frame
  double cartilage_mm = 0.0;        // both layers together; 0: contact alone
  bool rim = false;                 // use the rim alone?
};

/// The smallest gap at each step to the largest angle, by the tables.
struct Sweep {
  std::vector<double> angles;    // of the growth, degrees
  std::vector<double> smallest;  // mm, NaN where the surfaces do not face each other
};
Sweep sweep(Session& session, const LimitRequest& request, double step_deg);

/// A question about the limits of several motions.
struct LimitsRequest {
  std::vector<std::string> motions;
  std::optional<Motion> pose;
  double largest_deg = 360.0;
  std::optional<Vec3> translation;
  double cartilage_mm = 0.0;
  bool rim = false;

  static constexpr std::tuple fields{
      Field{"motions", "",
            "what grows: flexion, extension, abduction, adduction, internal_rotation, external_rotation "
            "from `pose`; or from a "
            "pose of its own internal_rotation_at_45, _70 or _90 (degrees of flexion), "
            "external_rotation_at_90, fadir (internal rotation at 90 of flexion and 15 of adduction), faber "
            "(external rotation at 45 of flexion and 30 of abduction) [all; with a pose, the first six]",
            &LimitsRequest::motions},
      Field{"pose", "", "where motions begin, as flexion=90 [all angles 0]", &LimitsRequest::pose},
      Field{"largest_deg", "deg", "growth that is looked at", &LimitsRequest::largest_deg, kPositive},
      Field{"translation", "mm", "X,Y,Z by which the ball is shifted first, frame of the meshes [none]",
            &LimitsRequest::translation},
      Field{"cartilage_mm", "mm",
            "thickness of both layers together: where the gap falls to it, too; 0: contact alone",
            &LimitsRequest::cartilage_mm, kNotNegative},
      Field{"rim", "",
            "the rim alone: where the socket's bone within 2.5 mm of its rim (a tenth of its radius) meets "
            "neck, trochanter or shaft; other contact is ignored, also where all angles are 0",
            &LimitsRequest::rim}};
  /// Throws std::invalid_argument for an unknown motion, and for a pose with a motion that has its own.
  void check() const;
  /// Gaps up to this are asked about, too.
  double threshold_mm() const { return cartilage_mm; }
  static constexpr const char* kThresholdOption = "--cartilage";
};

/// The upper end if it is known.
inline std::optional<double> end_or_none(const CentreInterval& range) {
  return range.limited ? std::optional(range.high_deg) : std::nullopt;
}

/// Why nothing is known beyond a limit: only an opening of a mesh could tell whether one bone is inside the
/// other; the ball's mesh ends; or surfaces graze.
enum class UnknownBy : std::uint8_t { opening, end_of_ball, graze };
template <>
inline constexpr std::array<std::string_view, 3> words_of<UnknownBy>{"opening", "end of ball", "graze"};

/// A row of limits.csv: one limit, and where it is reached.
struct LimitRow {
  std::string motion;
  std::string_view centre;        // "ball" or "socket": about whose centre the ball turns
  ToldLimit told{};               // its bracket, and what half a millimetre changes
  std::optional<double> hours{};  // where they touch, on the dial
  /// Name of the place on the ball that touches (hip/joint_places.hpp) or of its part (mesh/mesh_parts.hpp).
  std::optional<std::string> ball_part{};
  std::optional<std::string> socket_part{};
  std::optional<UnknownBy> unknown_by{};

  std::optional<std::string> clock() const { return clock_text(hours); }
  /// What meets, such as "rim and neck"; none if nothing does.
  std::optional<std::string> meets() const;
  /// meets(), and the doubts: half a millimetre changes the limit (ToldLimit::sensitivity()), the ball's mesh
  /// ends, why the limit is not known.
  std::string what() const;

  static constexpr std::tuple fields{
      Field{"motion", "",
            "what grows: fadir is internal rotation from 90 of flexion and 15 of adduction, faber external "
            "rotation from 45 of flexion and 30 of abduction, _at_90 from 90 of flexion",
            &LimitRow::motion},
      Field{"threshold_mm", "mm", "0: contact of the surfaces; else the gap of a vertex",
            via(&LimitRow::told, &ToldLimit::threshold_mm)},
      Field{"centre", "", "about whose centre the ball turns: ball or socket", &LimitRow::centre},
      Field{"state", "",
            "limited; free up to the largest angle; blocked from the start; unknown beyond low_deg",
            via(&LimitRow::told, &ToldLimit::limit, &TurnLimit::state)},
      Field{"low_deg", "deg", "free up to here",
            via(&LimitRow::told, &ToldLimit::limit, &TurnLimit::low_deg)},
      Field{"high_deg", "deg", "where limited, not free here",
            via(&LimitRow::told, &ToldLimit::limit, &TurnLimit::high_deg)},
      Field{"centre_low_deg", "deg", "free up to here for every common centre within 0.5 mm",
            via(&LimitRow::told, &ToldLimit::common, &CentreInterval::low_deg)},
      Field{"centre_high_deg", "deg", "not free here for any such centre; null where that is not known",
            via(&LimitRow::told, &ToldLimit::common, &end_or_none)},
      Field{"half_mm_gap_deg", "deg", "where the gap of a vertex first falls to 0.5 mm",
            via(&LimitRow::told, &ToldLimit::half_mm_gap_deg)},
      Field{"clock", "", "where on the rim's clock they touch", &LimitRow::clock},
      Field{"what", "", "what meets what, and what a reader must know", &LimitRow::what},
      Field{"play_low_deg", "deg", "free up to here for every play of the ball up to 0.5 mm",
            via(&LimitRow::told, &ToldLimit::play, &CentreInterval::low_deg)},
      Field{"play_high_deg", "deg", "not free here for any such play; null where that is not known",
            via(&LimitRow::told, &ToldLimit::play, &end_or_none)},
      Field{"hangs_on_less_than_half_mm", "", "does half a millimetre change it by more than 5 degrees?",
            via(&LimitRow::told, &ToldLimit::hangs_on_less)}};
};

/// A limit in a document.
struct LimitAnswer : LimitRow {
  Motion start{};
  double largest_deg = 0.0;
  Vec3 centre_of_rotation = Vec3::Zero();
  std::optional<Vec3> position{};

  static constexpr auto fields = std::tuple_cat(
      LimitRow::fields,
      std::tuple{
          Field{"start", "", "pose that the motion begins at", &LimitAnswer::start},
          Field{"largest_deg", "deg", "growth that was looked at", &LimitAnswer::largest_deg},
          Field{"centre_of_rotation", "mm", "x, y, z in the frame of the meshes",
                &LimitAnswer::centre_of_rotation},
          Field{"leaves_ball_mesh_deg", "deg", "from here on the ball's mesh ends under the socket",
                via(&LimitAnswer::told, &ToldLimit::limit, &TurnLimit::leaves_mesh_deg)},
          Field{"ball_part", "", "what of the ball's bone touches; null without a contact",
                &LimitAnswer::ball_part},
          Field{"socket_part", "", "what of the socket's bone touches", &LimitAnswer::socket_part},
          Field{"meets", "", "what meets what, as rim and neck", &LimitAnswer::meets},
          Field{"position", "mm", "x, y, z where they touch, frame of the meshes", &LimitAnswer::position},
          Field{"contact", "", "how they touch",
                via(&LimitAnswer::told, &ToldLimit::limit, &TurnLimit::contact, &TurnContact::kind)},
          Field{"unknown_by", "",
                "why nothing is known beyond low_deg: only an opening of a mesh could tell whether one bone "
                "is inside the other, the ball's mesh ends, or surfaces graze; null elsewhere",
                &LimitAnswer::unknown_by}});
};

/// The limits of one growing angle. Contact is sought about the ball's centre, and about the centre of a
/// sphere fitted to the socket unless none fits or the ball is shifted. A gap of cartilage_mm, unless that is
/// 0, is sought about the ball's centre.
std::vector<LimitAnswer> answer_limits(Session& session, const LimitRequest& request);

struct LimitsAnswer {
  double centre_within_mm = 0.0;
  bool rim = false;
  std::optional<double> rim_in_head_mm{};
  std::vector<LimitAnswer> limits;
  std::optional<double> ball_cut_mm{};

  static constexpr std::tuple fields{
      Field{"centre_within_mm", "mm", "how far off centres and play may be in the ranges",
            &LimitsAnswer::centre_within_mm},
      Field{"rim", "", "of the rim alone? Else of all bone", &LimitsAnswer::rim},
      Field{"rim_in_head_mm", "mm",
            "of the rim alone: how deep the rim lies in the head as scanned; there it meets the neck late or "
            "never. Null: nowhere",
            &LimitsAnswer::rim_in_head_mm},
      Field{"limits", "", "of each motion: contact about both centres, and the gap of the cartilage",
            &LimitsAnswer::limits},
      Field{
          "ball_cut_mm", "mm",
          "how far from the centre the ball's bone is cut off through its neck: what is missing beyond stops "
          "no motion, so that limits may be too large. Null: it is not",
          &LimitsAnswer::ball_cut_mm}};
};

/// Throws std::invalid_argument where a motion needs a side, or where nothing is left to grow.
LimitsAnswer answer(Session& session, const LimitsRequest& request);

}  // namespace impinge
