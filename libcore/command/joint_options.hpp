// SPDX-License-Identifier: GPL-3.0-or-later
// The joint that a command is asked about: its files, and how they are to be read.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "joint/joint_document.hpp"
#include "joint/touch.hpp"

namespace impinge {

/// Lengths in mm, places in the frame of the meshes.
struct JointOptions {
  std::filesystem::path ball{};    // mesh file
  std::filesystem::path socket{};  // mesh file
  /// Meshes of bone beside the ball, in the same frame (mesh/mesh_parts.hpp).
  std::vector<std::filesystem::path> ball_parts{};
  std::vector<std::filesystem::path> socket_parts{};  // beside the socket
  bool keep_largest = false;                          // of each file only the largest piece
  double overlap_mm = 0.0;                            // along a ray, that is no contact (hip/joint.hpp)
  bool ignore_rest_contact = false;                   // the least overlap that leaves none as scanned
  std::optional<Vec3> centre{};                       // fitted to the ball if not given
  std::optional<Side> side{};                         // of the body; abduction and rotation need it
  std::optional<std::string> axes{};  // of the meshes (hip/anatomy.hpp), else as their headers say
  std::optional<std::filesystem::path> landmarks{};  // file that gives the frames (joint/landmark_file.hpp)
  std::optional<std::filesystem::path>
      cartilage_map{};                            // instead of one thickness (joint/cartilage_file.hpp)
  std::optional<std::filesystem::path> config{};  // that says more of these
  std::optional<double> cartilage_mm{};           // both layers together; the request has its own otherwise
  bool cartilage_of_scan = false;                 // instead (joint/rest_contact.hpp)
};

/// Adds them to a command, --config among them: what a file says counts where the command line says nothing.
/// What is returned reads that file, once all options are.
[[nodiscard]] std::function<void()> add_joint_options(CLI::App& command, JointOptions& options);

/// All files that are read, so that no output takes their place.
std::vector<std::filesystem::path> files_of(const JointOptions& options);

/// The meshes as documents name them.
JointNames names_of(const JointOptions& options);

/// Reads the meshes and examines them. What looks wrong becomes a warning of the joint; `told` says which
/// contact as scanned is worth one. FileError or std::runtime_error, one line, for what cannot be used.
Session load_joint(const JointOptions& options, const ScanContactOptions& told);

/// What was taken of whole bones, and what landmarks and headers said, as lines for a terminal; often none.
std::string describe_joint(const JointOptions& options, const Joint& joint);

}  // namespace impinge
