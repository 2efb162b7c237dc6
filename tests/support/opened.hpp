// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/io.hpp"
#include "support/turned.hpp"

namespace impinge::test {

/// Without the faces within an angle, radians, of a unit direction, as the origin sees their centroids.
inline TriangleMesh opened(TriangleMesh mesh, const Vec3& towards, double angle) {
  std::erase_if(mesh.faces, [&](const Face& face) {
    const auto [a, b, c] = corners_of(mesh, face);
    return (a + b + c).normalized().dot(towards) > std::cos(angle);
  });
  return mesh;
}

/// What a command is asked of: the cam's pair, with a part `speck` of the ball in a part `flask` of the
/// socket, which do not touch, far from the pair. The speck is open by one face; the flask's mouth has this
/// angle, radians.
inline std::string speck_in_flask(const std::filesystem::path& folder, double mouth) {
  const auto [ball, socket] = make_ball_socket_pair(400, impinging_cam());
  const Vec3 there(0.0, 90.0, 0.0);
  TriangleMesh speck = octahedron(1.0);
  speck.faces.pop_back();
  const auto written = [&folder](const char* name, const TriangleMesh& mesh) {
    const std::filesystem::path path = folder / (std::string(name) + ".ply");
    write_mesh(path, mesh);
    return " " + path.string();
  };
  return written("ball", ball) + written("socket", socket) + " --centre 0,0,0 --side right --ball-part" +
         written("speck", moved(speck, there)) + " --socket-part" +
         written("flask", moved(opened(icosphere(8.0, 4), -Vec3::UnitY(), mouth), there));
}

}  // namespace impinge::test
