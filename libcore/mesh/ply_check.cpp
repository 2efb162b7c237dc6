// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <memory>

#include "mesh/file_checks.hpp"
#include "mesh/file_error.hpp"
#include "mesh/ply_header.hpp"
#include "mesh/text_scan.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

// The values of the body one after the other; none past the end or where there is no number.
class Values {
 public:
  virtual ~Values() = default;
  virtual void next_record() = 0;
  virtual std::optional<double> next(PlyType type) = 0;
};

class AsciiValues : public Values {
 public:
  explicit AsciiValues(std::string_view body) : lines_(body) {}
  void next_record() override {
    words_ = &lines_.next_words();
    used_ = 0;
  }
  std::optional<double> next(PlyType) override {
    return used_ < words_->size() ? to_number((*words_)[used_++]) : std::nullopt;
  }

 private:
  LineScanner lines_;
  const std::vector<std::string_view>* words_ = nullptr;
  std::size_t used_ = 0;
};

class BinaryValues : public Values {
 public:
  BinaryValues(std::string_view body, bool big_endian) : rest_(body), big_endian_(big_endian) {}
  void next_record() override {}
  std::optional<double> next(PlyType type) override {
    if (rest_.size() < type.size) return std::nullopt;
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < type.size; ++k) {
      const auto byte = static_cast<unsigned char>(rest_[big_endian_ ? k : type.size - 1 - k]);
      bits = bits << 8U | byte;
    }
    rest_.remove_prefix(type.size);
    return decode(bits, type);
  }

 private:
  static double decode(std::uint64_t bits, PlyType type) {
    if (type.size == 8) return std::bit_cast<double>(bits);
    if (type.floating) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    const auto value = static_cast<double>(bits);
    const double range = static_cast<double>(std::uint64_t{1} << (8 * type.size));
    return type.is_signed && value >= range / 2 ? value - range : value;
  }

  std::string_view rest_;
  bool big_endian_;
};

std::unique_ptr<Values> values_of(const PlyHeader& header) {
  if (header.format == PlyFormat::ascii) return std::make_unique<AsciiValues>(header.body);
  return std::make_unique<BinaryValues>(header.body, header.format == PlyFormat::big_endian);
}

const PlyProperty* corner_list(const PlyElement& face) {
  const PlyProperty* list = find_property(face, "vertex_indices");
  if (list == nullptr) list = find_property(face, "vertex_index");
  return list != nullptr && list->count && !list->type.floating ? list : nullptr;
}

[[noreturn]] void throw_no_faces(const fs::path& file) {
  throw MeshFileError(file, "has no faces, only points", "triangulate the surface first");
}

void check_elements(const fs::path& file, const PlyHeader& header) {
  const PlyElement* vertex = find_element(header, "vertex");
  const PlyElement* face = find_element(header, "face");
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) {
      throw MeshFileError(file, "its PLY element '" + element.name + "' has no properties",
                          "export it again");
    }
  }
  const auto has_scalar = [vertex](const char* name) {
    const PlyProperty* property = vertex == nullptr ? nullptr : find_property(*vertex, name);
    return property != nullptr && !property->count;
  };
  if (!has_scalar("x") || !has_scalar("y") || !has_scalar("z")) {
    throw MeshFileError(file, "its PLY header has no vertices with x, y and z", "export it again");
  }
  if (face == nullptr || face->count == 0) {
    throw_no_faces(file);
  }
  if (corner_list(*face) == nullptr || face < vertex) {
    throw MeshFileError(file, "its PLY faces have no list vertex_indices, or come before the vertices",
                        "export it again");
  }
}

// Walks through all values.
class Walk {
 public:
  Walk(const fs::path& file, const PlyHeader& header)
      : file_(file),
        header_(header),
        values_(values_of(header)),
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
        throw MeshFileError(file_,
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

  double value(PlyType type, const PlyElement& element, std::int64_t i) {
    const std::optional<double> x = values_->next(type);
    if (!x) throw_damaged(element, i);
    return *x;
  }

  [[noreturn]] void throw_damaged(const PlyElement& element, std::int64_t i) const {
    throw MeshFileError(file_,
                        "ends within or cannot be read at " + element.name + ' ' + std::to_string(i) +
                            " of the " + std::to_string(element.count) +
                            " declared, it is cut short or damaged",
                        "export or copy it again");
  }

  const fs::path& file_;
  const PlyHeader& header_;
  std::unique_ptr<Values> values_;
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
