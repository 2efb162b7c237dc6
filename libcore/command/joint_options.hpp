// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the joint that a command is about: its files, and how they are read.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "joint/joint_document.hpp"
#include "joint/joint_folder.hpp"
#include "joint/touch.hpp"

namespace impinge {

/// Lengths in mm, places in the frame of the meshes.
struct JointOptions : JointDescription {
  std::filesystem::path ball{};      // mesh file
  std::filesystem::path socket{};    // mesh file
  bool keep_largest = false;         // keep only the largest piece of each file
  double overlap_mm = 0.0;           // overlap along a ray that is no contact (hip/joint.hpp)
  bool ignore_rest_contact = false;  // take the least overlap for which nothing touches as scanned
  std::optional<std::filesystem::path>
      cartilage_map{};                            // instead of one thickness (joint/cartilage_file.hpp)
  std::optional<std::filesystem::path> config{};  // file that gives more of these options
  bool cartilage_of_scan = false;                 // take the thickness from the scan (joint/rest_contact.hpp)
};

/// Adds the options, with --config, to a command. The file of --config counts where the command line says
/// nothing. The returned function reads that file; call it after all options are read.
[[nodiscard]] std::function<void()> add_joint_options(CLI::App& command, JointOptions& options);

/// Takes from a description what the command line does not give.
void use_description(const CLI::App& command, const JointDescription& said, JointOptions& options);

/// All files that are read, so that no output replaces them.
std::vector<std::filesystem::path> files_of(const JointOptions& options);

/// The names of the meshes in documents.
JointNames names_of(const JointOptions& options);

/// Reads the meshes and examines them. What looks wrong becomes a warning of the joint; `told` says which
/// contact as scanned deserves one. Throws FileError or std::runtime_error, one line, for unusable input.
Session load_joint(const JointOptions& options, const ScanContactOptions& told);

/// Lines for a terminal: what was taken of whole bones, and what landmarks and headers said. Often empty.
std::string describe_joint(const JointOptions& options, const Joint& joint);

}  // namespace impinge
