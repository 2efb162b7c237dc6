// SPDX-License-Identifier: GPL-3.0-or-later
#include "21_motion_frames/hip_scan.hpp"

#include <stdexcept>

#include "table/exact_raster.hpp"

namespace impinge::lab {

HipScanner hip_scanner(const ReplayedHip& hip, double precision_deg) {
  const auto dial = clock_face(hip.socket);
  if (!dial) throw std::invalid_argument(hip.name + ": the socket has no dial: see hip/clock.hpp");
  const Rsid scheme = Rsid::with_precision(precision_deg);
  return {hip, *dial,
          packed_joint(packed_table<double>(fill_exact(hip.ball, scheme, Layer::farthest)),
                       packed_table<double>(fill_exact(hip.socket, scheme, Layer::nearest)), hip.ball,
                       hip.socket),
          vertex_areas(hip.ball), vertex_areas(hip.socket)};
}

PosedHip scan(const HipScanner& scanner, const Pose& pose) {
  const ReplayedHip& hip = scanner.hip;
  PosedHip posed{{hip.ball.vertices, std::vector<double>(hip.ball.vertices.size()), scanner.ball_area},
                 {hip.socket.vertices, std::vector<double>(hip.socket.vertices.size()), scanner.socket_area}};
  scan_joint(scanner.lanes, pose, posed.ball.gap, posed.socket.gap);
  for (Vec3& x : posed.ball.vertices) x = to_socket(pose, x);
  return posed;
}

}  // namespace impinge::lab
