// SPDX-License-Identifier: GPL-3.0-or-later
// Finds a user's ball-and-socket joints in a folder with one subfolder for each subject. Each subfolder
// holds, in one frame and in millimetres,
//   ball, femoral_head or humeral_head                                      the ball
//   socket, acetabulum_facing, glenoid_facing, acetabulum or glenoid        the socket
// as .ply, .stl, .obj, .off, .vtp or .vtk. The first of these names that is there counts. It may also hold
//   subject.json      the centre of rotation, "center_of_rotation_mm": [x, y, z], which is otherwise fitted
//                     to the ball; perhaps the head's radius, "radius_mm", and the "side" and "axes" of
//                     results/README.md
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hip/anatomy.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// One joint, as its folder describes it.
struct JointFolder {
  std::string subject;              // name of its folder
  std::filesystem::path ball;       // mesh file
  std::filesystem::path socket;     // mesh file
  std::optional<Vec3> centre;       // of rotation, in the input frame, mm, from the description
  std::optional<double> radius;     // of the head, from the description, mm
  std::optional<Side> side;         // from the description
  std::optional<std::string> axes;  // where +x, +y and +z point (hip/anatomy.hpp), from the description
};

/// What a JSON file says of a joint: subject.json, or a file that a user writes. Each key may be missing:
///   center_of_rotation_mm or centre   [x, y, z], mm, in the frame of the meshes
///   side          left or right
///   axes          an axis code, or words such as "+x = patient left, +y = posterior, +z = superior"
///   radius_mm     of the head
///   cartilage_mm  thickness of both layers together
///   landmarks     a file, relative to the folder of the JSON file
///   ball_part, socket_part   a file or a list of files, relative to the same folder
struct JointDescription {
  std::optional<Vec3> centre{};
  std::optional<double> radius{};
  std::optional<Side> side{};
  std::optional<std::string> axes{};
  std::optional<double> cartilage_mm{};
  std::optional<std::filesystem::path> landmarks{};
  std::vector<std::filesystem::path> ball_parts{};
  std::vector<std::filesystem::path> socket_parts{};
};
/// Reads a description. Throws FileError for a file that is no JSON object, for a value of the wrong kind,
/// and for a key that differs from one of these by a letter or two.
JointDescription read_description(const std::filesystem::path& file);

/// The joints of a folder.
struct JointFolders {
  std::vector<JointFolder> joints;  // in the order of their names
  std::vector<std::string>
      left_out;  // a line each: "FOLDER has no ball mesh", or what is wrong with its description
};

/// Finds the joints of a folder. Throws std::runtime_error, one line, if it holds none.
JointFolders find_joints(const std::filesystem::path& folder);

}  // namespace impinge
