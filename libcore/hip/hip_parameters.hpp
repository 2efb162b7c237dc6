// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of a generated hip. Lengths in mm, angles in degrees, both in the joint frame of anatomy.hpp
// (standing, knee forward) with the centre of the head as origin; "lateral" is +x on the right side. The
// defaults are the normal hip; a published number has its source beside it, the others are our choice.
//
// Clock positions are those of clock.hpp: 12 superior, 3 anterior on both sides.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "hip/anatomy.hpp"

namespace impinge {

struct HipParameters {
  Side side = Side::right;  // of the body

  /// Head: a sphere, or an ellipsoid of revolution about the neck axis, or a conchoid.
  double head_radius = 24.0;     // perpendicular to the neck axis. Cartilage of five heads: 23 to 26 (LibHip)
  double head_axis_ratio = 1.0;  // half axis along the neck divided by head_radius: the sphericity
  /// If both are positive, the head is Menschik's conchoid r = a + b cos(phi) turned about the neck axis
  /// (thesis, Eq. 11; sphere/conchoid_shape.hpp). The sphere that fits it best over phi <= 90 degrees is
  /// centred at the origin; head_radius is ignored.
  double conchoid_a = 0.0;
  double conchoid_b = 0.0;  // below conchoid_a

  /// Cam: a bump of height * cos^2(pi/2 * angle / half width) on top of the head.
  double cam_height = 0.0;  // of its top. The largest height of cam patients has a mean of 3.3 (Harris 2013)
  double cam_half_width = 30.0;  // from the top to the foot, as seen from the centre
  double cam_polar = 50.0;       // of the top, from the neck axis
  double cam_clock = 1.5;        // of the top about the neck axis, hours

  /// Neck: a cylinder round the neck axis, which runs from the centre of the head to the shaft.
  double head_neck_offset = 9.1;    // head radius minus neck radius; 0.19 of the head's diameter (Toogood)
  double neck_fillet = 7.0;         // reach of the rounding between head and neck; 7 gives alpha 46 degrees
  double neck_length = 53.0;        // from the centre to the axis of the shaft
  double neck_shaft_angle = 128.0;  // CCD, at the medial side. Medians: 122, 129, 133 (three collections)
  double femoral_torsion = 12.0;    // anteversion, in the plane square to the shaft, from the transverse
                                    // axis (a knee that looks forward has its condyles along it). 9.7 to 14.2
  double shaft_length = 40.0;       // of the stump; 0 ends the neck in a dome, and the ball is star-shaped
  double shaft_radius = 14.0;       // of the stump

  /// Trochanters: rounded bodies on the shaft. They are separate parts of the ball, which limits and touch
  /// take into account (limits/body_pairs.hpp). No preset has them, nor has a hip without a shaft.
  double greater_trochanter_width = 0.0;  // from front to back; 0 leaves it out
  /// Height of its tip above the centre of the head, along the shaft. 7.3 +- 5.1 (519 femora by CT, Gupta),
  /// 9.5 +- 6 (150 radiographs, doi:10.1016/j.arth.2005.11.003).
  double greater_trochanter_tip = 7.3;
  /// From the centre of the head to the tip, perpendicular to the shaft. 46.2 follows from 46.8 along the
  /// line between them (194 hips, doi:10.21037/apm-21-2538).
  double greater_trochanter_offset = 46.2;
  double greater_trochanter_behind = 5.0;  // how far its tip is behind the plane of neck and shaft
  double lesser_trochanter_height = 0.0;   // over the shaft; 0 leaves it out
  double lesser_trochanter_angle = 24.0;   // behind the medial side. 24 +- 11.5 (doi:10.1093/jhps/hnv067)

  /// Acetabulum: a sphere with a rim. Its axis points out of the opening.
  double joint_space = 4.5;   // socket radius minus head radius, bone to bone. 4.5 (Turley 2013)
  double inclination = 54.0;  // of the axis from straight down, as seen from the front (radiographic)
  double version = 19.0;      // of the axis from lateral to anterior, as seen from above. 18.2 to 19.9
  double half_opening =
      87.0;  // from the pole of the socket to its rim. 87 +- 4, cam 84, pincer 96 (Cobb 2010)
  /// Angle from the vertical to the rim, laterally, in the coronal plane through the centre. 32.7. If half
  /// opening and inclination give another angle, the rim is raised or lowered to this one, over two hours to
  /// either side.
  double lateral_centre_edge = 32.7;
  double pincer_height = 0.0;      // of the additional rim at its highest, along the sphere
  double pincer_clock = 1.0;       // of its middle about the axis of the socket, hours
  double pincer_half_width = 2.0;  // from its middle to its end, hours
  /// Anterior inferior iliac spine: a rounded body beside the rim, a separate part of the socket. It is as
  /// long and wide as the origin of the rectus femoris on it, 22 and 16 mm (Hapa 2013,
  /// doi:10.1016/j.arthro.2013.08.023). Hetsroni's (2013) type I ends short of the rim, type II reaches it.
  double aiis_height = 0.0;     // over the plane of the rim; 0 leaves it out
  double aiis_distance = 11.0;  // of its middle from the rim, outwards in that plane; 11 reaches the rim
  double aiis_clock = 1.5;      // hours. From 1 to 1:30 on its lateral side to 2 to 2:30 medially (Hapa 2013)
  double fossa_depth = 2.0;     // of the pit in the floor
  double fossa_half_width = 25.0;  // as seen from the centre
  double fossa_polar = 25.0;       // of its middle, from the pole of the socket towards 6 o'clock
  double shift_lateral = 0.0;      // from the centre of the head to the centre of the socket
  double shift_anterior = 0.0;
  double shift_superior = 0.0;
  double wall_thickness = 0.0;  // 0: only the surface that faces the head, open at its rim, star-shaped;
                                // otherwise a closed shell
};

/// A parameter as the programs read and write it.
struct HipParameter {
  std::string_view name;         // name of the member
  std::string_view unit;         // "mm", "deg", ...
  double HipParameters::*value;  // the member
  double least;                  // smallest accepted value
  double most;                   // largest accepted value
  std::string_view meaning;      // in words
};

/// All parameters but the side, in the order of the members.
inline constexpr std::size_t kHipParameters = 39;
const std::array<HipParameter, kHipParameters>& hip_parameter_list();  // their names, units and ranges

/// Sets one parameter from "name=value", or the side from side=left or side=right. Throws
/// std::invalid_argument, one line, for a text that it cannot read and for a value out of range.
void set_hip_parameter(HipParameters& parameters, std::string_view text);

/// Throws std::invalid_argument if a parameter is outside its range or not a number.
void require_in_range(const HipParameters& parameters);

}  // namespace impinge
