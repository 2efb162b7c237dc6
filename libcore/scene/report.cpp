// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/report.hpp"

#include <vector>

#include "files/csv.hpp"
#include "files/file_set.hpp"
#include "hip/gap_files.hpp"
#include "mesh/ply_writer.hpp"
#include "scene/question.hpp"
#include "scene/reported_surface.hpp"

namespace impinge {
namespace {

using nlohmann::json;

std::string csv_of(const ReportedSurface& ball, const ReportedSurface& socket, const Vec3& centre) {
  const auto in_input_frame = [&centre](std::vector<Vec3> places) {
    for (Vec3& x : places) x += centre;
    return places;
  };
  const std::vector<Vec3> ball_places = in_input_frame(ball.posed);
  const std::vector<Vec3> socket_places = in_input_frame(socket.posed);
  return gaps_csv({ball.surface, ball_places, ball.gaps.gap},
                  {socket.surface, socket_places, socket.gaps.gap});
}

std::string distances_csv(const ReportedSurface& ball, const ReportedSurface& socket) {
  Table table;
  table.columns = {{"surface", "", "ball or socket"},
                   {"vertex", "1", "index in the input mesh after welding"},
                   {"gap_mm", "mm", "radial, as in gaps.csv"},
                   {"distance_lower_mm", "mm", "Euclidean distance from the other surface, lower end"},
                   {"distance_upper_mm", "mm", "upper end"}};
  for (const ReportedSurface* v : {&ball, &socket}) {
    for (std::size_t i = 0; i < v->posed.size(); ++i) {
      const DistanceBracket& distance = v->gaps.distance[i];
      table.add_row({name(v->surface), i, v->gaps.gap[i], distance.lower_mm, distance.upper_mm});
    }
  }
  return to_csv(table);
}

std::string part_ply(const ReportedSurface& v, const Vec3& centre) {
  TriangleMesh mesh{v.posed, v.part.mesh.faces};
  for (Vec3& x : mesh.vertices) x += centre;
  const auto levels = gap_levels(v.surface, v.touching);
  std::vector<Rgb> colours;
  for (const double gap : v.against_cartilage) colours.push_back(gap_colour(gap, levels));
  return ply_bytes(mesh, "gap", v.gaps.gap, colours);
}

}  // namespace

void write_scene(const SceneOptions& options, const Joint& joint, const Measurement& measurement,
                 const nlohmann::json& summary) {
  const ReportedSurface ball = reported(Surface::ball, options, joint, measurement);
  const ReportedSurface socket = reported(Surface::socket, options, joint, measurement);
  FileSet files;
  if (options.outputs.gaps) {
    for (const ReportedSurface* v : {&ball, &socket}) {
      if (v->gaps.gap.empty()) continue;
      files.add(options.out / (std::string(name(v->surface)) + ".ply"), part_ply(*v, joint.centre));
    }
    files.add(options.out / "gaps.csv", csv_of(ball, socket, joint.centre));
  }
  if (options.outputs.distances) files.add(options.out / "distances.csv", distances_csv(ball, socket));
  files.add(options.out / "summary.json", json_text(summary));
  files.commit();
}

}  // namespace impinge
