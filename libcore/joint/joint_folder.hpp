// SPDX-License-Identifier: GPL-3.0-or-later
// Finds a user's ball-and-socket joints in a folder with one subfolder for each subject. Each subfolder
// holds, in one frame and in millimetres,
//   ball, femoral_head or humeral_head                                      the ball
//   socket, acetabulum_facing, glenoid_facing, acetabulum or glenoid        the socket
// as .ply, .stl, .obj, .off, .vtp or .vtk. Of a _facing mesh and the same without it the former counts; any
// other two are refused, and so are meshes that a command wrote beside its answer. It may also hold
//   subject.json      the centre of rotation, "center_of_rotation_mm": [x, y, z], which is otherwise fitted
//                     to the ball; perhaps more of JointDescription, and notes
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "files/fields.hpp"
#include "hip/anatomy.hpp"
#include "sphere/direction.hpp"

namespace impinge {

/// What a JSON file says of a joint: subject.json, or a file that a user writes. Each key may be missing.
struct JointDescription {
  std::optional<Vec3> centre{};       // mm, input frame; fitted to the ball if not given
  std::optional<double> radius{};     // mm
  std::optional<Side> side{};         // needed for abduction and rotation
  std::optional<std::string> axes{};  // of the meshes (hip/anatomy.hpp); if not given, as their headers say
  std::optional<double> cartilage_mm{};
  std::optional<std::filesystem::path> landmarks{};
  std::vector<std::filesystem::path> ball_parts{};  // meshes in the same frame (mesh/mesh_parts.hpp)
  std::vector<std::filesystem::path> socket_parts{};

  static constexpr std::tuple fields{
      Field{"center_of_rotation_mm", "mm", "[x, y, z] in the frame of the meshes", &JointDescription::centre},
      Field{"centre", "mm", "the same", &JointDescription::centre},
      Field{"side", "", "left or right", &JointDescription::side},
      Field{"axes", "", "an axis code, or words such as \"+x = patient left, +y = posterior, +z = superior\"",
            &JointDescription::axes},
      Field{"radius_mm", "mm", "of the head", &JointDescription::radius, kPositive},
      Field{"cartilage_mm", "mm", "thickness of both layers together", &JointDescription::cartilage_mm,
            kNotNegative},
      Field{"landmarks", "", "a file, relative to the folder of the JSON file", &JointDescription::landmarks},
      Field{"ball_part", "", "bone beside the ball: a file or a list of files, relative to the same folder",
            &JointDescription::ball_parts},
      Field{"socket_part", "", "the same of the socket", &JointDescription::socket_parts}};
};

/// May a description have other keys? Those of a saved session of Joint3D, "program", "commit", "page",
/// "ball" and "socket", it always may.
enum class OtherKeys {
  refused,  // a file of options, whose every key is to count
  of_data   // subject.json also has notes, a source, a licence
};
/// Reads a description. Throws FileError for a file that is no JSON object, or std::runtime_error, one line
/// with its name: for a value of the wrong kind, axes that are none, another "unit" or "units" than mm, and a
/// key that is refused. Of data those are refused that were surely meant to count: a letter or two away from
/// one of these, one of these cut short or with more behind it ("centre_mm"), and options of the program.
JointDescription read_description(const std::filesystem::path& file, OtherKeys others);

/// One joint, as its folder describes it.
struct JointFolder : JointDescription {
  std::string subject;           // name of its folder
  std::filesystem::path ball;    // mesh file
  std::filesystem::path socket;  // mesh file
};

/// The joints of a folder.
struct JointFolders {
  std::vector<JointFolder> joints;  // in the order of their names
  std::vector<std::string>
      left_out;  // a line each: "FOLDER has no ball mesh", or what is wrong with its description
};

/// Finds the joints of a folder. Throws std::runtime_error, one line, if it holds none.
JointFolders find_joints(const std::filesystem::path& folder);

}  // namespace impinge
