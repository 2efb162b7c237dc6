// SPDX-License-Identifier: GPL-3.0-or-later
// What the sources of the page's engine answer on this machine: hips as plain numbers and the gaps of scenes
// with them, for engine_test.js to hold the WebAssembly against.
//
//   joint3d_scenes FOLDER     writes scenes.json, and NAME.positions, NAME.faces, SCENE.ball, SCENE.socket as
//   raw numbers
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "session/joint_files.hpp"
#include "session/limits.hpp"

namespace {

using namespace impinge;
using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t kFaces = 3000;  // enough to meet every face of a cube, and few enough for a quick test

struct NamedStorage {
  const char* name;
  Storage storage;
};
constexpr NamedStorage kUint16{"uint16", Storage::sixteen_bits};
constexpr NamedStorage kFloat{"float", Storage::single_precision};
constexpr NamedStorage kDouble{"double", Storage::double_precision};

struct TableCase {
  const char* scheme;
  double precision;
  NamedStorage storage;
};
constexpr TableCase kTables[] = {{"cube_gnomonic", 0.5, kUint16},
                                 {"cube_gnomonic", 1.0, kFloat},
                                 {"cube_gnomonic", 1.0, kDouble},
                                 {"rsid", 1.0, kUint16},
                                 {"rsid", 1.0, kFloat},
                                 {"rsid", 1.0, kDouble},
                                 {"usid", 1.0, kDouble},
                                 {"usid", 1.0, kUint16},
                                 {"icosahedral_sine", 2.0, kFloat},
                                 {"icosahedral_gnomonic", 2.0, kUint16},
                                 {"octahedral_equal_area", 2.0, kDouble},
                                 {"fibonacci", 2.0, kDouble}};

const std::vector<PoseRequest>& poses() {
  static const std::vector<PoseRequest> kPoses{{{}, Vec3::Zero(), 4.0},
                                               {{}, Vec3(0.25, 0.5, -0.125), 2.0},
                                               {{90.0, 0.0, 0.0}, Vec3::Zero(), 4.0},
                                               {{100.0, -15.0, 25.0}, Vec3(0.0, 0.5, 0.0), 4.0}};
  return kPoses;
}

template <class Number>
void write(const fs::path& file, const std::vector<Number>& numbers) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(numbers.data()),
            static_cast<std::streamsize>(numbers.size() * sizeof(Number)));
}

void write_mesh(const fs::path& stem, const TriangleMesh& mesh) {
  std::vector<double> positions;
  for (const Vec3& x : mesh.vertices) positions.insert(positions.end(), {x.x(), x.y(), x.z()});
  std::vector<std::uint32_t> corners;
  for (const Face& face : mesh.faces) corners.insert(corners.end(), face.begin(), face.end());
  write(stem.string() + ".positions", positions);
  write(stem.string() + ".faces", corners);
}

json point(const Vec3& x) { return {x.x(), x.y(), x.z()}; }

json smallest(const PoseAnswer& found) {
  if (!found.smallest) return nullptr;
  return {{"gap_mm", found.smallest->gap_mm},
          {"surface", name(found.smallest->surface)},
          {"vertex", found.smallest->vertex},
          {"clock", clock_text(*found.smallest->hours)}};
}

json pose_json(const PoseRequest& request) {
  return {{"flexion", request.motion.flexion},
          {"abduction", request.motion.abduction},
          {"internal_rotation", request.motion.internal_rotation},
          {"translation", point(request.translation)},
          {"cartilage_mm", request.cartilage_mm}};
}

json matrix(const Pose& pose) {
  json columns = json::array();
  for (const double entry : pose.rotation.reshaped()) columns.push_back(static_cast<float>(entry));
  return columns;
}

// Every pose against the tables that the session has.
void answer_poses(Session& session, const TableCase& table, const fs::path& folder, json& scenes) {
  for (const PoseRequest& request : poses()) {
    const PoseAnswer found = answer_pose(session, request);
    const std::string file = std::to_string(scenes.size());
    write(folder / (file + ".ball"), found.ball.gap);
    write(folder / (file + ".socket"), found.socket.gap);
    scenes.push_back(
        {{"file", file},
         {"tables",
          {{"scheme", table.scheme}, {"precision_deg", table.precision}, {"storage", table.storage.name}}},
         {"pose", pose_json(request)},
         {"matrix", matrix(found.pose)},
         {"smallest", smallest(found)},
         {"bone_mm2", found.ball.bone.impinged_area + found.socket.bone.impinged_area},
         {"cartilage_mm2", found.socket.cartilage.impinged_area}});
  }
}

json limit_json(const LimitAnswer& found) {
  const TurnLimit& limit = found.told.limit;
  const auto& half = found.told.half_mm_gap_deg;
  return {{"about", found.about},
          {"threshold_mm", found.told.threshold_mm},
          {"state", name(limit.state)},
          {"low_deg", limit.low_deg},
          {"high_deg", limit.high_deg},
          {"half_mm_gap_deg", half ? json(*half) : json(nullptr)},
          {"clock", found.hours ? json(clock_text(*found.hours)) : json(nullptr)}};
}

json limits_json(Session& session, const char* growing) {
  const LimitAnswers found = answer_limits(session, {.start = {}, .growing = growing, .largest_deg = 150.0});
  return {{"motion", growing},
          {"limits", {limit_json(found.contact), limit_json(*found.socket), limit_json(found.cartilage)}}};
}

// Of the deepest of the poses.
json verdicts_json(Session& session) {
  const PoseVerdicts found = answer_verdicts(session, poses().back());
  return {{"pose", pose_json(poses().back())},   {"clear", found.vertices.clear},
          {"impinged", found.vertices.impinged}, {"undecided", found.vertices.undecided},
          {"largest_mm", found.largest_mm},      {"median_mm", found.median_mm},
          {"low_mm", found.smallest.low},        {"high_mm", found.smallest.high}};
}

json hip_json(const std::string& name, const fs::path& folder) {
  const HipParameters parameters = hip_preset(name);
  Hip hip = make_hip(parameters, kFaces);
  write_mesh(folder / (name + "-ball"), hip.ball);
  write_mesh(folder / (name + "-socket"), hip.socket);
  JointInput input;
  input.ball = {"ball", std::move(hip.ball)};
  input.socket = {"socket", std::move(hip.socket)};
  input.centre = Vec3::Zero();
  input.side = parameters.side;
  Session session;
  session.tables.settings = {"cube_gnomonic", 4.0, Storage::sixteen_bits};
  use_meshes(session, std::move(input));
  json scenes = json::array();
  for (const TableCase& table : kTables) {
    fill_tables(session, {table.scheme, table.precision, table.storage.storage});
    fs::create_directories(folder / name);
    answer_poses(session, table, folder / name, scenes);
  }
  fill_tables(session, {"cube_gnomonic", 4.0, Storage::sixteen_bits});
  bound_tables(session);
  return {{"name", name},
          {"side", parameters.side == Side::left ? "left" : "right"},
          {"bound_mm", whole_bound(session.tables)},
          {"verdicts", verdicts_json(session)},
          {"csv", gaps_csv(*session.joint, answer_pose(session, {}))},
          {"limits", {limits_json(session, "flexion"), limits_json(session, "internal_rotation")}},
          {"scenes", scenes}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: joint3d_scenes FOLDER" << std::endl;
    return 2;
  }
  const fs::path folder = argv[1];
  fs::create_directories(folder);
  json hips = json::array();
  for (const char* name : {"normal", "mixed", "patient_b"}) hips.push_back(hip_json(name, folder));
  std::ofstream(folder / "scenes.json") << hips.dump(1);
  return 0;
}
