// SPDX-License-Identifier: GPL-3.0-or-later
// Which files a scene writes into its folder.
#pragma once

#include <string>
#include <vector>

#include "scene/options.hpp"

namespace impinge {

/// Name of the mesh of a bone that was cut.
std::string resected_file(Surface cut);

/// Names of the files that write_scene() or an answered question leaves behind.
std::vector<std::string> scene_files(const SceneOptions& options);

/// Names of the files that any scene may write.
std::vector<std::string> every_scene_file();

/// Names of files in the folder that an earlier scene wrote and this one does not, unfinished .part files of
/// many poses included. They are only listed, not changed.
std::vector<std::string> older_files(const SceneOptions& options);

}  // namespace impinge
