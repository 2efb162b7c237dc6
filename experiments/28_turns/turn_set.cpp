// SPDX-License-Identifier: GPL-3.0-or-later
#include "28_turns/turn_set.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "harness/build_info.hpp"
#include "harness/provenance.hpp"

namespace impinge::lab {
namespace {

namespace fs = std::filesystem;
using Kind = TurnQuery::Kind;

constexpr std::size_t kPoints = 8;  // columns before the points, or the files
constexpr std::size_t kEach = 9;    // columns of up to three points

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> parts;
  std::istringstream in(line + ',');
  for (std::string cell; std::getline(in, cell, ',');) parts.push_back(cell);
  return parts;
}

// One face; it repeats its last corner if there are fewer than three points.
TriangleMesh feature(const std::vector<std::string>& row, std::size_t from) {
  TriangleMesh mesh;
  for (std::size_t k = from; k < from + kEach && !row[k].empty(); k += 3)
    mesh.vertices.emplace_back(std::stod(row[k]), std::stod(row[k + 1]), std::stod(row[k + 2]));
  const auto last = static_cast<VertexIndex>(mesh.vertices.size() - 1);
  mesh.faces = {{0, std::min(1U, last), last}};
  return mesh;
}

// Reads doubles as they are; mesh/io.hpp rounds to float.
TriangleMesh read_off(const fs::path& path) {
  std::ifstream in(path);
  std::string word;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  in >> word >> vertices >> faces >> edges;
  TriangleMesh mesh;
  mesh.vertices.resize(vertices);
  mesh.faces.resize(faces);
  for (Vec3& x : mesh.vertices) in >> x.x() >> x.y() >> x.z();
  for (Face& f : mesh.faces) in >> edges >> f[0] >> f[1] >> f[2];
  if (!in || word != "OFF") throw std::runtime_error(path.string() + " is no whole OFF file of triangles");
  return mesh;
}

Kind kind_of(const std::string& name) {
  for (const auto& [word, kind] : {std::pair{"vertex_face", Kind::vertex_face},
                                   {"edge_edge", Kind::edge_edge},
                                   {"face_face", Kind::face_face},
                                   {"mesh", Kind::mesh}})
    if (name == word) return kind;
  throw std::runtime_error("'" + name + "' is no kind of query");
}

KnownTurn known(const fs::path& folder, const std::vector<std::string>& row) {
  KnownTurn turn{row[0], row[1], row[2], {}, std::nullopt};
  turn.query.kind = kind_of(row[1]);
  turn.query.axis = Vec3(std::stod(row[3]), std::stod(row[4]), std::stod(row[5])).normalized();
  turn.query.largest = std::stod(row[6]);
  if (!row[7].empty()) turn.first = std::stod(row[7]);
  const bool mesh = turn.query.kind == Kind::mesh;
  turn.query.turning = mesh ? read_off(folder / row[kPoints]) : feature(row, kPoints);
  turn.query.resting = mesh ? read_off(folder / row[kPoints + 1]) : feature(row, kPoints + kEach);
  return turn;
}

}  // namespace

std::vector<KnownTurn> read_turn_set(const fs::path& folder) {
  std::vector<KnownTurn> turns;
  for (const char* name : {"pairs.csv", "meshes.csv"}) {
    std::ifstream in(folder / name);
    std::string line;
    if (!std::getline(in, line)) throw std::runtime_error((folder / name).string() + " cannot be read");
    const std::size_t columns = cells(line).size();
    while (std::getline(in, line)) {
      const std::vector<std::string> row = cells(line);
      if (row.size() != columns)
        throw std::runtime_error((folder / name).string() + ": a row has another number of cells: " + line);
      turns.push_back(known(folder, row));
    }
  }
  return turns;
}

std::vector<KnownTurn> make_turn_set(const TurnSetSizes& sizes) {
  std::string folder = (fs::temp_directory_path() / "impinge-turns-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) throw std::runtime_error(folder + " cannot be made");
  const fs::path script = fs::path(build_info().source_folder) / "experiments/28_turns/turns.py";
  std::string command = shell_quoted(build_info().python) + " -B";
  for (const std::string& word :
       {script.string(), std::string("make"), folder, std::string("--seed"), std::to_string(sizes.seed),
        std::string("--pairs"), std::to_string(sizes.pairs), std::string("--meshes"),
        std::to_string(sizes.meshes)})
    command += " " + shell_quoted(word);
  std::vector<KnownTurn> turns;
  const bool made = std::system(command.c_str()) == 0;
  if (made) turns = read_turn_set(folder);
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  if (!made) throw std::runtime_error("this command failed: " + command);
  return turns;
}

}  // namespace impinge::lab
