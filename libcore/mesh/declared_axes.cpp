// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/declared_axes.hpp"

#include <algorithm>
#include <string_view>

#include "files/file_error.hpp"
#include "mesh/mesh_format.hpp"

namespace impinge {
namespace {

constexpr std::size_t kStlHead = 80;  // of a binary STL
constexpr std::string_view kTag = "SPACE=";

// The lines of a file before its numbers begin.
std::string_view header_of(MeshFormat format, std::string_view head) {
  switch (format) {
    case MeshFormat::ply:
      return head.substr(0, head.find("end_header"));
    case MeshFormat::stl:
      return head.substr(0, std::max(kStlHead, std::min(head.find('\n'), head.size())));
    case MeshFormat::obj: {
      std::size_t end = 0;
      while (end < head.size() && (head[end] == '#' || head[end] == '\r' || head[end] == '\n'))
        end = std::min(head.find('\n', end), head.size() - 1) + 1;
      return head.substr(0, end);
    }
    case MeshFormat::vtk:
      return head.substr(0, head.find('\n', head.find('\n') + 1));
    case MeshFormat::off:
    case MeshFormat::vtp:
      break;
  }
  return {};
}

// SPACE= must be a word of its own, not the end of COLORSPACE=.
bool says(std::string_view header, const std::string& code) {
  const std::string word = std::string(kTag) + code;
  const auto letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; };
  for (std::size_t at = header.find(word); at != header.npos; at = header.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !letter(header[at - 1])) && (end == header.size() || !letter(header[end]))) return true;
  }
  return false;
}

}  // namespace

std::optional<std::string> declared_axes(const std::filesystem::path& name, std::string_view head) {
  const std::string_view header = header_of(mesh_format(name), head);
  std::optional<std::string> found;
  for (const char* code : {"RAS", "LPS"}) {
    if (!says(header, code)) continue;
    if (found)
      throw FileError(name, "its header says both SPACE=RAS and SPACE=LPS", "leave the one that is true");
    found = code;
  }
  return found;
}

AxesChoice agreed_axes(const std::vector<SaidAxes>& files, const std::optional<std::string>& given,
                       const std::string& option) {
  const SaidAxes* first = nullptr;
  for (const SaidAxes& said : files) {
    if (!said.code) continue;
    if (first == nullptr) first = &said;
    if (said.code != first->code)
      throw FileError(said.file,
                      "its header says SPACE=" + *said.code + ", and that of " +
                          (first == files.data() ? "the ball" : first->file.filename().string()) +
                          " SPACE=" + *first->code,
                      "export both in one frame");
  }
  if (given && first != nullptr && *first->code != *given)
    throw FileError(first->file,
                    "its header says SPACE=" + *first->code + ", and " + option + " says " + *given,
                    "leave " + option + " out, or correct the header");
  if (given) return {*given, "given"};
  return first == nullptr ? AxesChoice() : AxesChoice{*first->code, "header"};
}

}  // namespace impinge
