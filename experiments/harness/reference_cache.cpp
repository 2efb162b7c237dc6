// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/reference_cache.hpp"

#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "files/file_bytes.hpp"
#include "files/file_error.hpp"
#include "harness/digest.hpp"

namespace impinge::lab {
namespace {

// Changes with the meaning of an answer or the layout of a file: older files are then never found.
constexpr std::string_view kVersion = "impinge reference 1";
constexpr std::size_t kDigestLength = 64;

template <class T>
std::string_view bytes_of(std::span<const T> values) {
  static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, double>);
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

std::string_view bytes_of(std::span<const Vec3> points) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return bytes_of(std::span(points.empty() ? nullptr : points.front().data(), 3 * points.size()));
}

// Digests of the parts are of one length, so that no two lists of parts make the same text.
std::string key_of(std::string_view kind, const TriangleMesh& mesh, std::span<const Vec3> query) {
  std::string text = std::string(kVersion) + " " + std::string(kind);
  for (const std::string_view part :
       {bytes_of(std::span(mesh.vertices)), bytes_of(std::span<const Face>(mesh.faces)), bytes_of(query)})
    text += " " + sha256_hex(part);
  return sha256_hex(text);
}

std::optional<std::vector<double>> stored(const std::filesystem::path& file, std::size_t count) {
  std::string bytes;
  try {
    bytes = read_bytes(file);
  } catch (const FileError&) {
    return std::nullopt;
  }
  const std::size_t length = count * sizeof(double);
  if (bytes.size() != length + kDigestLength) return std::nullopt;
  const std::string_view whole = bytes;
  if (sha256_hex(whole.substr(0, length)) != whole.substr(length)) return std::nullopt;
  std::vector<double> values(count);
  if (count > 0) std::memcpy(values.data(), bytes.data(), length);
  return values;
}

template <class Measure>
std::vector<double> stored_or_measured(const std::filesystem::path& file, std::size_t count,
                                       Measure&& measure) {
  if (auto values = stored(file, count)) return *std::move(values);
  std::vector<double> values = measure();
  std::string bytes(bytes_of(std::span<const double>(values)));
  bytes += sha256_hex(bytes);
  std::filesystem::create_directories(file.parent_path());
  write_bytes(file, bytes);
  return values;
}

}  // namespace

std::vector<double> cached_exact_radii(const std::filesystem::path& folder, const TriangleMesh& mesh,
                                       const RadiusQuery& query) {
  if (folder.empty()) return exact_radii(mesh, query);
  const std::string_view kind = query.layer == Layer::nearest ? "radius nearest" : "radius farthest";
  return stored_or_measured(folder / key_of(kind, mesh, query.directions), query.directions.size(),
                            [&] { return exact_radii(mesh, query); });
}

std::vector<double> cached_closest_distances(const std::filesystem::path& folder, const TriangleMesh& mesh,
                                             const DistanceQuery& query) {
  if (folder.empty()) return closest_distances(mesh, query);
  return stored_or_measured(folder / key_of("distance", mesh, query.points), query.points.size(),
                            [&] { return closest_distances(mesh, query); });
}

}  // namespace impinge::lab
