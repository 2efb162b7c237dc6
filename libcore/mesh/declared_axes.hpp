// SPDX-License-Identifier: GPL-3.0-or-later
// Where +x, +y and +z of mesh files point, as their headers declare.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace impinge {

/// "RAS" or "LPS" of a file that says SPACE=RAS or SPACE=LPS, as 3D Slicer writes it
/// (vtkMRMLModelStorageNode): in a comment of PLY, in the 80 bytes or the first line of STL, in the comments
/// that OBJ begins with, in the title of VTK, and as the value of a field SPACE in VTP. None if it does not
/// say, and for a file that cannot be opened. FileError if it says both, or the extension is that of no mesh
/// format, and for a VTP that cannot be read. Of impinge::mesh_io.
std::optional<std::string> declared_axes(const std::filesystem::path& file);
/// The same from the first kAxesHead bytes of a file, or all it has; the extension of `name` is the format.
/// None of a VTP file, which may have them anywhere.
std::optional<std::string> declared_axes(const std::filesystem::path& name, std::string_view head);
inline constexpr std::size_t kAxesHead = 65536;

/// An axis code (hip/anatomy.hpp), and where it is from.
struct AxesChoice {
  std::string code = "RAS";
  std::string from = "assumed";  // or "given", or "header"
};

/// What declared_axes() has found in a file.
struct SaidAxes {
  std::filesystem::path file;       // as messages name it
  std::optional<std::string> code;  // none where its header does not say
};

/// The axes of two files in one frame: what is given, else what a header says, else RAS. FileError if the
/// headers contradict each other or what is given; `option` is the name of the option that gives it.
AxesChoice agreed_axes(const SaidAxes& ball, const SaidAxes& socket, const std::optional<std::string>& given,
                       const std::string& option);
AxesChoice agreed_axes(const std::filesystem::path& ball, const std::filesystem::path& socket,
                       const std::optional<std::string>& given, const std::string& option);

}  // namespace impinge
