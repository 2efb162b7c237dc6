// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include "files/file_error.hpp"
#include "mesh/file_checks.hpp"
#include "mesh/ply_header.hpp"
#include "mesh/ply_values.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

const PlyProperty* corner_list(const PlyElement& face) {
  const PlyProperty* list = find_property(face, "vertex_indices");
  if (list == nullptr) list = find_property(face, "vertex_index");
  return list != nullptr && list->count && !list->type.floating ? list : nullptr;
}

[[noreturn]] void throw_no_faces(const fs::path& file) {
  throw FileError(file, "has no faces, only points", "triangulate the surface first");
}

void check_elements(const fs::path& file, const PlyHeader& header) {
  const PlyElement* vertex = find_element(header, "vertex");
  const PlyElement* face = find_element(header, "face");
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) {
      throw FileError(file, "its PLY element '" + element.name + "' has no properties", "export it again");
    }
  }
  const auto has_scalar = [vertex](const char* name) {
    const PlyProperty* property = vertex == nullptr ? nullptr : find_property(*vertex, name);
    return property != nullptr && !property->count;
  };
  if (!has_scalar("x") || !has_scalar("y") || !has_scalar("z")) {
    throw FileError(file, "its PLY header has no vertices with x, y and z", "export it again");
  }
  if (face == nullptr || face->count == 0) {
    throw_no_faces(file);
  }
  if (corner_list(*face) == nullptr || face < vertex) {
    throw FileError(file, "its PLY faces have no list vertex_indices, or come before the vertices",
                    "export it again");
  }
}

// Walks through all values.
class Walk {
 public:
  Walk(const fs::path& file, const PlyHeader& header)
      : file_(file),
        header_(header),
        values_(ply_values(header)),
        vertices_(find_element(header, "vertex")->count) {}

  MeshFileContent content() {
    for (const PlyElement& element : header_.elements) {
      for (std::int64_t i = 0; i < element.count; ++i) record(element, i);
    }
    return {static_cast<std::size_t>(vertices_), polygons_, sums_};
  }

 private:
  void record(const PlyElement& element, std::int64_t i) {
    const PlyProperty* const corners = element.name == "face" ? corner_list(element) : nullptr;
    values_->next_record();
    for (const PlyProperty& property : element.properties) {
      if (&property == corners) {
        polygon(property, element, i);
        continue;
      }
      const std::int64_t length = property.count ? list_length(property, element, i) : 1;
      for (std::int64_t k = 0; k < length; ++k) {
        const double x = value(property.type, element, i);
        if (element.name == "vertex" && is_coordinate(property)) sums_.coordinates += std::abs(x);
      }
    }
  }

  static bool is_coordinate(const PlyProperty& property) {
    return property.name == "x" || property.name == "y" || property.name == "z";
  }

  void polygon(const PlyProperty& list, const PlyElement& face, std::int64_t i) {
    const std::int64_t length = list_length(list, face, i);
    double sum = 0.0;
    for (std::int64_t k = 0; k < length; ++k) {
      const double v = value(list.type, face, i);
      if (!(v >= 0.0 && v < static_cast<double>(vertices_) && v == std::floor(v))) {
        throw FileError(file_,
                        "face " + std::to_string(i) + " names a vertex that is not there, it is damaged",
                        "export it again");
      }
      sum += v;
    }
    if (length < 3) return;
    ++polygons_;
    sums_.corners += sum;
  }

  std::int64_t list_length(const PlyProperty& list, const PlyElement& element, std::int64_t i) {
    const double length = value(*list.count, element, i);
    if (length >= 0.0 && length <= 4294967295.0) return static_cast<std::int64_t>(length);
    throw_damaged(element, i);
  }

  double value(NumberType type, const PlyElement& element, std::int64_t i) {
    const std::optional<double> x = values_->next(type);
    if (!x) throw_damaged(element, i);
    return *x;
  }

  [[noreturn]] void throw_damaged(const PlyElement& element, std::int64_t i) const {
    throw FileError(file_,
                    "ends within or cannot be read at " + element.name + ' ' + std::to_string(i) +
                        " of the " + std::to_string(element.count) + " declared, it is cut short or damaged",
                    "export or copy it again");
  }

  const fs::path& file_;
  const PlyHeader& header_;
  std::unique_ptr<PlyValues> values_;
  std::int64_t vertices_;
  std::size_t polygons_ = 0;
  MeshFileSums sums_;
};

}  // namespace

MeshFileContent check_ply(const fs::path& file, std::string_view bytes) {
  const PlyHeader header = parse_ply_header(file, bytes);
  check_elements(file, header);
  const MeshFileContent content = Walk(file, header).content();
  if (content.polygons == 0) throw_no_faces(file);
  return content;
}

}  // namespace impinge
