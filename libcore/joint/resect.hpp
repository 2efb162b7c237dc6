// SPDX-License-Identifier: GPL-3.0-or-later
// The bone to cut from a session's ball or socket so that required motions are reached
// (change/resection.hpp), with checks of the joint and exact tests of what is left.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "change/resection.hpp"
#include "files/fields.hpp"
#include "joint/required_motions.hpp"
#include "joint/session.hpp"
#include "limits/turn_limit.hpp"

namespace impinge {

/// Default depth inside its rim to which a socket may be cut, mm. Our choice: we know of no published limit.
inline constexpr double kMostRim = 5.0;

/// Default width of the bar that a cut leaves of the neck, as a share of the neck's width. Up to 30 % of the
/// anterolateral quadrant of the neck can be resected before a cadaver femur breaks at a
/// lower load (Mardones et al. 2005).
inline constexpr double kNeckShare = 0.7;

struct ResectRequest {
  std::vector<Motion> require;  // degrees
  double clearance_mm = 0.5;
  Surface cut = Surface::ball;
  std::optional<double> rim_mm{};   // kMostRim if not given
  std::optional<double> neck_mm{};  // kNeckShare of the neck's width if not given
  bool least = false;

  /// Throws std::invalid_argument for motions that cannot be required, or options that exclude each other.
  void check() const;

  static constexpr std::tuple fields{
      Field{"require", "deg", kRequireText, &ResectRequest::require},
      Field{"clearance_mm", "mm", "radial gap to keep along the whole motion", &ResectRequest::clearance_mm,
            kPositive},
      Field{"cut", "", "which bone is cut: the ball, or the socket at its rim", &ResectRequest::cut},
      Field{"rim_mm", "mm", "how far inside its rim a cut of the socket may come; 5 where it is not given",
            &ResectRequest::rim_mm, kPositive},
      Field{"neck_mm", "mm",
            "least width of the neck that a cut of the ball leaves; 70 % of the neck's width where it is not "
            "given",
            &ResectRequest::neck_mm, kPositive},
      Field{"least", "",
            "also the smallest cut of the ball that may leave an undercut; the socket must be a closed mesh",
            &ResectRequest::least}};
};

/// Proven lower and upper end of a number.
using TwoEnds = std::array<double, 2>;

inline TwoEnds ends_of(const Ends& ends) { return {ends.low, ends.high}; }
inline std::optional<TwoEnds> known_ends(const Ends& ends) {
  return ends.high < kInfinity ? std::optional(ends_of(ends)) : std::nullopt;
}

/// The size of a cut.
template <>
inline constexpr std::tuple fields_of<CutSize>{
    Field{"volume_mm3", "mm^3",
          "of bone that has to go, at least and at most; null where the mesh does not tell where bone is",
          via(&CutSize::volume_mm3, &known_ends)},
    Field{"area_mm2", "mm^2", "of the bone's surface that has to go, at least and at most",
          via(&CutSize::area_mm2, &ends_of)},
    Field{"depth_mm", "mm",
          "the largest along a ray from the centre, at least and at most: to where the other bone is "
          "clear of it, or a closed mesh ends",
          via(&CutSize::depth_mm, &ends_of)}};

struct LeastExtent : CutSize {
  std::size_t cells = 0;

  static constexpr auto fields = std::tuple_cat(
      fields_of<CutSize>,
      std::tuple{Field{"cells", "1", "parts of the ball's surface in swept.csv", &LeastExtent::cells}});
};

/// Widths of the round bar inside the neck, mm.
struct NeckBar {
  double least = 0.0;
  double before = 0.0;
  double after = 0.0;

  static constexpr std::tuple fields{
      Field{"least_mm", "mm", "that was to be left", &NeckBar::least},
      Field{"before_mm", "mm", "in the uncut ball, where it is cut", &NeckBar::before},
      Field{"after_mm", "mm", "in the cut ball", &NeckBar::after}};
};

/// The first contact along a leg.
template <>
inline constexpr std::tuple fields_of<TurnLimit>{
    Field{"state", "", "how the search for first contact ended", &TurnLimit::state},
    Field{"low_deg", "deg", "no contact from the start of the leg to here", &TurnLimit::low_deg},
    Field{"high_deg", "deg", "where limited, contact here", &TurnLimit::high_deg}};

/// A leg of a required path, before and after the cut.
struct ResectLeg : RequiredLeg {
  TurnLimit before;
  TurnLimit after;

  static constexpr std::tuple fields{
      Field{"words", "", "as internal_rotation from 0 to 30 degrees at flexion 90",
            [](const RequiredLeg& leg) { return describe(leg); }},
      Field{"motion", "", "the angle that grows", &ResectLeg::growing},
      Field{"start", "deg", "where the leg begins", &ResectLeg::start},
      Field{"required_deg", "deg", "of growth", &ResectLeg::largest_deg},
      Field{"before", "", "first contact before the cut, up to what is required", &ResectLeg::before},
      Field{"after", "", "and after it, up to 10 degrees more", &ResectLeg::after}};
};

inline constexpr double kBeyondLeg = 10.0;  // degrees that are looked at beyond the required motion

struct ResectAnswer : CutSize {
  Surface surface = Surface::ball;
  std::optional<std::string_view> volume_why;
  std::optional<Vec3> deepest;
  double mesh_volume_mm3 = 0.0;  // NaN where it is not known
  std::optional<LeastExtent> least;
  std::optional<NeckBar> neck;
  std::vector<ResectLeg> legs;
  // Frame of the meshes, mm; the ball lies as scanned, even where landmarks turn it in the joint.
  TriangleMesh mesh;                  // of the bone that is left
  std::vector<double> depth;          // of each vertex, along its ray
  std::vector<LeastCut::Cell> swept;  // what may have to go in the least cut

  static constexpr auto fields = std::tuple_cat(
      std::tuple{Field{"surface", "",
                       "which bone the least radial cut about the centre of rotation is of. It leaves no "
                       "undercut, and narrows the bone behind the rim all the way out, where a cut that "
                       "follows the rim could take less; of the socket it takes all bone nearer to the "
                       "centre than the ball reaches, with the clearance",
                       &ResectAnswer::surface}},
      fields_of<CutSize>,
      std::tuple{
          Field{"volume_why", "",
                "why there is no volume: the ball has to be closed, or met once by each ray of the cut; the "
                "socket closed, with the centre outside of its bone",
                &ResectAnswer::volume_why},
          Field{"deepest", "mm",
                "where the cut is deepest, x, y, z in the frame of the meshes; null: "
                "nothing has to go",
                &ResectAnswer::deepest},
          Field{"mesh_volume_mm3", "mm^3",
                "that the cut mesh takes away; null where there is no volume, or all of a wall of the socket "
                "goes",
                &ResectAnswer::mesh_volume_mm3},
          Field{"least", "",
                "of the least cut of all, if it was asked for: what the bone of the socket sweeps through "
                "within the clearance; bone beyond stays, over an undercut",
                &ResectAnswer::least},
          Field{"neck", "",
                "widest round bar about the axis of the neck that stays whole; null without a neck, or "
                "without a cut beside it",
                &ResectAnswer::neck},
          Field{"legs", "", "of the required paths; none touches after the cut", &ResectAnswer::legs}});
};

/// Throws std::runtime_error, one line with the place in the frame of the meshes, if the cut is refused;
/// std::invalid_argument as check() does, or if a motion needs a side.
///
/// A cut is refused if
///   * the pose with all angles 0 already touches, or has a gap below the clearance;
///   * the mesh of the ball ends under the socket on the way: the missing bone may be in the way too;
///   * it reaches the bearing surface of the ball: vertices that face the socket in the pose of the scan and
///     lie within SphereFit::trim of the sphere that fits the head (hip/sphere_fit.hpp);
///   * it reaches the bearing surface of the socket: vertices within BallFitOptions::trim of the sphere of
///     measure_acetabulum() (hip/hip_measures.hpp) that lie farther inside the rim than may be trimmed, so
///     that the sphere goes on all round them at that distance. A socket without a rim is not checked;
///   * it thins the neck too much: the widest round bar about the neck axis (hip/hip_measures.hpp) that the
///     cut leaves whole is narrower than asked for. It is checked on a ball with a neck;
///   * bone beside the joint stops a required motion after the cut (limits/body_pairs.hpp). Such parts are
///     not cut, and need no clearance.
///
/// The least cut of all removes bone along the same rays, from the same radius on, so the checks of bearing
/// surface and neck hold for it as well. The socket has no least cut; the ball's is
/// refused if the socket has no wall or there is bone beside the joint.
ResectAnswer answer(Session& session, const ResectRequest& request);

}  // namespace impinge
