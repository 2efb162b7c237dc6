// SPDX-License-Identifier: GPL-3.0-or-later
// Where +x, +y and +z of mesh files point, as their headers declare.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace impinge {

/// "RAS" or "LPS" if the file says SPACE=RAS or SPACE=LPS, as 3D Slicer writes it (vtkMRMLModelStorageNode):
/// in a comment of PLY, in the 80 bytes or the first line of STL, in the comments at the beginning of OBJ, in
/// the title of VTK, or as the value of a field SPACE in VTP. std::nullopt if it does not say, or cannot be
/// opened. Throws FileError if it says both, if the extension names no mesh format, or if a VTP cannot be
/// read. Part of impinge::mesh_io.
std::optional<std::string> declared_axes(const std::filesystem::path& file);
/// The same from the first kAxesHead bytes of a file, or all it has; the extension of `name` names the
/// format. std::nullopt for a VTP file, which may say it anywhere.
std::optional<std::string> declared_axes(const std::filesystem::path& name, std::string_view head);
inline constexpr std::size_t kAxesHead = 65536;

/// An axis code (hip/anatomy.hpp), and where it comes from.
struct AxesChoice {
  std::string code = "RAS";
  std::string from = "assumed";  // or "given", or "header"
};

/// What declared_axes() has found in a file.
struct SaidAxes {
  std::filesystem::path file;       // as messages name it
  std::optional<std::string> code;  // std::nullopt if its header does not say
};

/// The axes of files in one frame, the ball's first: `given`, else what a header says, else RAS. Throws
/// FileError if the headers contradict each other or `given`; `option` is the name of the option that gives
/// it.
AxesChoice agreed_axes(const std::vector<SaidAxes>& files, const std::optional<std::string>& given,
                       const std::string& option);
/// The same of what the headers of files say.
AxesChoice agreed_axes_of(const std::vector<std::filesystem::path>& files,
                          const std::optional<std::string>& given, const std::string& option);

}  // namespace impinge
