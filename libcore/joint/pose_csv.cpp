// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "gap/nearest_rotation.hpp"
#include "joint/pose_lines.hpp"

namespace impinge {
namespace {

constexpr std::array<std::string_view, 7> kQuaternion{"qw", "qx", "qy", "qz", "tx", "ty", "tz"};

// Prefixes of the names of columns, for the ball and for the socket.
constexpr std::array<std::array<std::string_view, 5>, 2> kBones{
    {{"ball_", "femur_", "humerus_"}, {"socket_", "pelvis_", "acetabulum_", "scapula_", "glenoid_"}}};

// Which number a column gives.
struct Place {
  enum { moved, kept, left_out } use = moved;
  std::string name;      // as given
  std::string plain;     // without the bone
  std::size_t bone = 0;  // 1: socket
};

// What the columns of a file mean.
struct Header {
  std::vector<Place> places;
  bool both = false;        // do both bones have columns?
  bool quaternion = false;  // are they quaternions?
  std::size_t each = 0;     // numbers of a bone's matrix; 0 where the list is of named numbers
  PoseList list;
};

Place place_of(std::string_view word) {
  Place place{.name = std::string(word), .plain = plain_name(word)};
  if (place.plain == "frame" || place.plain == "time") place.use = Place::kept;
  if (place.plain == "valid_pose") place.use = Place::left_out;
  for (std::size_t bone = 0; bone < kBones.size(); ++bone) {
    for (const std::string_view before : kBones[bone]) {
      if (before.empty() || !place.plain.starts_with(before)) continue;
      place.plain.erase(0, before.size());
      place.bone = bone;
      return place;
    }
  }
  place.bone = kBones.size();
  return place;
}

// The names of a bone's columns, without its prefix.
std::vector<std::string> names_of(const Header& header, std::size_t bone) {
  std::vector<std::string> names;
  for (const Place& place : header.places)
    if (place.use == Place::moved && place.bone == bone) names.push_back(place.plain);
  return names;
}

bool are_quaternions(const std::vector<std::string>& names) {
  const auto has = [&](std::string_view name) { return std::count(names.begin(), names.end(), name) == 1; };
  const auto from = kQuaternion.begin();
  return std::all_of(from, from + 4, has) &&
         (names.size() == 4 || (names.size() == 7 && std::all_of(from + 4, kQuaternion.end(), has)));
}

bool are_matrices(const std::vector<std::string>& names) { return names.size() == 12 || names.size() == 16; }

// Takes columns that make matrices, of one bone or of both.
bool takes_matrices(const PoseLines& lines, Header& header) {
  const std::vector<std::string> ball = names_of(header, 0);
  const std::vector<std::string> socket = names_of(header, 1);
  const std::vector<std::string> alone = names_of(header, kBones.size());
  header.both = !ball.empty() || !socket.empty();
  if (header.both &&
      (ball.size() != socket.size() || !alone.empty() || are_quaternions(ball) != are_quaternions(socket)))
    lines.refuse(
        "the ball and the socket have not the same columns; give both those of a quaternion or of a matrix");
  const std::vector<std::string>& names = header.both ? ball : alone;
  header.quaternion = are_quaternions(names);
  if (header.quaternion || are_matrices(names)) header.each = names.size();
  return header.each > 0;
}

Header read_header(const PoseLines& lines, const std::vector<std::string_view>& words) {
  Header header;
  PoseList& list = header.list;
  std::vector<std::string> names;
  for (const std::string_view word : words) {
    header.places.push_back(place_of(word));
    if (header.places.back().use == Place::moved) names.emplace_back(word);
  }
  if (names.empty()) lines.refuse("no column names an angle, a quaternion or a matrix");
  const bool matrices = takes_matrices(lines, header);
  PoseList named;
  if (matrices) {
    list.kind = header.each == 4 ? PoseKind::centre : PoseKind::meshes;
  } else {
    try {
      named = named_poses(names);
      list.kind = named.kind;
    } catch (const std::invalid_argument& error) {
      lines.refuse(error.what());
    }
  }
  auto next = named.columns.begin();
  for (const Place& place : header.places) {
    if (place.use == Place::left_out) continue;
    const bool repeated = place.use == Place::kept || header.quaternion;
    if (place.use == Place::moved && !matrices)
      list.columns.push_back(*next++);
    else if (repeated)
      list.columns.push_back({place.name});
  }
  if (matrices) add_matrix_columns(list);
  return header;
}

// A matrix from its 12 or 16 numbers; none where one is missing.
std::optional<PoseMatrix> matrix_of(const PoseLines& lines, const std::vector<double>& n) {
  if (std::any_of(n.begin(), n.end(), [](double x) { return std::isnan(x); })) return std::nullopt;
  if (n.size() == 16 && (n[12] != 0.0 || n[13] != 0.0 || n[14] != 0.0 || n[15] != 1.0))
    lines.refuse("the last row of a matrix is 0,0,0,1");
  PoseMatrix matrix = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(n.data());
  const std::optional<Eigen::Matrix3d> nearest = nearest_rotation(matrix.leftCols<3>());
  if (!nearest) lines.refuse("the matrix does not turn only: it is more than 0.0001 off from any rotation");
  matrix.leftCols<3>() = *nearest;
  return matrix;
}

// A matrix from w, x, y, z and, if given, a translation.
std::optional<PoseMatrix> quaternion_of(const PoseLines& lines, const std::vector<double>& n) {
  const std::optional<Eigen::Matrix3d> turn = lines.turn_of_quaternion(n.data());
  if (!turn || std::any_of(n.begin() + 4, n.end(), [](double x) { return std::isnan(x); }))
    return std::nullopt;
  PoseMatrix matrix = PoseMatrix::Zero();
  matrix.leftCols<3>() = *turn;
  if (n.size() == 7) matrix.col(3) = Vec3(n[4], n[5], n[6]);
  return matrix;
}

// The inverse of the socket's matrix times the ball's.
PoseMatrix relative(const PoseMatrix& ball, const PoseMatrix& socket) {
  const Eigen::Matrix3d back = socket.leftCols<3>().transpose();
  PoseMatrix matrix;
  matrix << back * ball.leftCols<3>(), back * (ball.col(3) - socket.col(3));
  return matrix;
}

// The matrix of a bone from a row.
std::optional<PoseMatrix> bone_of(const PoseLines& lines, const Header& header,
                                  const std::vector<double>& row, std::size_t bone) {
  std::vector<double> numbers(header.each);
  std::size_t next = 0;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const Place& place = header.places[k];
    if (place.use != Place::moved || place.bone != bone) continue;
    const auto at = std::find(kQuaternion.begin(), kQuaternion.end(), place.plain);
    numbers[header.quaternion ? static_cast<std::size_t>(at - kQuaternion.begin()) : next++] = row[k];
  }
  return header.quaternion ? quaternion_of(lines, numbers) : matrix_of(lines, numbers);
}

void add_row(const PoseLines& lines, const std::vector<double>& row, Header& header) {
  PoseList& list = header.list;
  std::size_t column = 0;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const Place& place = header.places[k];
    if (place.use == Place::left_out || (place.use == Place::moved && header.each > 0 && !header.quaternion))
      continue;
    if (const int number = list.columns[column++].number;
        number >= 0 && number < 3 && std::abs(row[k]) > kLargestAngle)
      lines.refuse("an angle of " + place.name + " is not within 180 degrees of 0");
    list.values.push_back(row[k]);
  }
  if (header.each == 0) return;
  std::optional<PoseMatrix> matrix = bone_of(lines, header, row, header.both ? 0 : kBones.size());
  if (header.both) {
    const std::optional<PoseMatrix> socket = bone_of(lines, header, row, 1);
    matrix = matrix && socket ? std::optional(relative(*matrix, *socket)) : std::nullopt;
  }
  add_matrix(matrix, list);
}

// Is it a header, with text and without numbers?
bool is_header(const std::vector<std::string_view>& words, char separator) {
  return std::any_of(words.begin(), words.end(), [](std::string_view word) { return !is_missing(word); }) &&
         std::none_of(words.begin(), words.end(),
                      [&](std::string_view word) { return delimited_number(word, separator).has_value(); });
}

}  // namespace

PoseList read_pose_csv(PoseLines lines) {
  if (!lines.next()) lines.refuse_file("holds no pose");
  const char separator = separator_of(lines.line());
  std::vector<std::string_view> words = delimited_words(lines.line(), separator);
  const bool headed = is_header(words, separator);
  if (!headed && words.size() != 12 && words.size() != 16)
    lines.refuse(std::to_string(words.size()) + " numbers without a header are no matrix");
  Header header =
      read_header(lines, headed ? words : std::vector<std::string_view>(words.size(), std::string_view()));
  for (bool more = !headed || lines.next(); more; more = lines.next()) {
    words = delimited_words(lines.line(), separator);
    lines.require_words(words.size(), header.places.size());
    std::vector<double> row;
    for (std::size_t k = 0; k < words.size(); ++k)
      row.push_back(header.places[k].use == Place::left_out ? 0.0 : lines.number(words[k], separator));
    add_row(lines, row, header);
  }
  lines.require_pose(header.list);
  return std::move(header.list);
}

}  // namespace impinge
