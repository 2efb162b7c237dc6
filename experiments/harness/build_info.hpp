// SPDX-License-Identifier: GPL-3.0-or-later
// How this program was built; CMake fills it in (build_info.cpp.in).
#pragma once

#include <map>
#include <string>

namespace impinge::lab {

struct BuildInfo {
  std::string compiler;                          // name and version
  std::string flags;                             // every compiler flag of the library's targets
  std::string build_type;                        // Release, RelWithDebInfo ...
  std::string source_folder;                     // where git is asked for the commit
  std::string python;                            // the interpreter that has the packages
  std::map<std::string, std::string> libraries;  // name to version, for libraries that the build found
};

const BuildInfo& build_info();  // of this program

}  // namespace impinge::lab
