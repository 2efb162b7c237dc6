// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/gaps.hpp"

#include "command/question_command.hpp"
#include "files/formatted.hpp"
#include "joint/joint_files.hpp"
#include "mesh/io.hpp"

namespace impinge {
namespace {

std::string describe_table(const GapsRequest& request, const GapsAnswer& found) {
  if (found.precision_deg) {
    return formatted("table               %s at %g degrees, %zu entries a surface\n",
                     request.scheme_name().c_str(), *found.precision_deg, found.entries_per_table);
  }
  if (!request.max_error_mm) return "table               none: gaps are those of the faces\n";
  return formatted("table               none: gaps within %g mm, of the faces\n", *request.max_error_mm);
}

// Words about the overlap of the main surfaces along rays.
std::string describe_overlap(const std::optional<Certificate>& found) {
  if (!found) return "";
  if (!found->deepest) return "radial overlap      none\n";
  return "radial overlap      by up to " + rounded_up(found->deepest->depth, 3) + " mm at a " +
         std::string(word_of(found->deepest->kind)) + (found->vertices_impinged() ? "" : "; of no vertex") +
         "\n";
}

std::string describe_zones(const Impinged& found) {
  if (!found.clock_zones) return "no clock positions: the socket looks straight up, down, forward or back";
  std::string text;
  for (const ClockZone& zone : *found.clock_zones) {
    const std::string from = clock_text(zone.from);
    if (from == clock_text(zone.to)) return "all round the clock";
    text += (text.empty() ? "" : ", ") + from + "-" + clock_text(zone.to);
  }
  return text.empty() ? "nowhere" : "at " + text + " o'clock";
}

std::string describe_level(const Impingement& level) {
  const std::string text = level.gap_up_to_mm == 0.0 ? "bone on bone        " : "within cartilage    ";
  const std::string end =
      level.gap_up_to_mm > 0.0 ? formatted(", up to a gap of %g mm\n", *level.gap_up_to_mm) : "\n";
  if (level.ball.vertices + level.socket.vertices == 0) return text + "nowhere" + end;
  return text +
         formatted("ball %.1f mm^2 %s; socket %.1f mm^2 %s", level.ball.area_mm2,
                   describe_zones(level.ball).c_str(), level.socket.area_mm2,
                   describe_zones(level.socket).c_str()) +
         end;
}

std::string describe_gaps(const SessionJoint& joint, const GapsRequest& request, const GapsAnswer& found) {
  std::string text = describe_centre(joint.joint) + describe_table(request, found) +
                     (found.contact ? describe(*found.contact) : "") +
                     describe_overlap(found.radial_overlap) + describe(found.nearest_part) +
                     describe(found.smallest_gap);
  if (found.smallest_gap)
    for (const Impingement& level : found.impingement()) text += describe_level(level);
  return text;
}

Told told(Session& session, const GapsRequest& request, const Work& work) {
  const GapsAnswer found = answer(session, request);
  const SessionJoint& joint = *session.joint;
  Told told{.words = describe_gaps(joint, request, found), .document = json_of(found)};
  told.row_of_one = {{"contact", "/contact/state"},
                     {"smallest_gap_mm", "/smallest_gap/gap_mm"},
                     {"surface", "/smallest_gap/surface"},
                     {"vertex", "/smallest_gap/vertex"},
                     {"clock", "/smallest_gap/clock"}};
  if (!work.out) return told;
  if (request.asks(Output::gaps)) {
    for (const Surface surface : kSurfaces) {
      if (found.of(surface).gap.empty()) continue;
      const std::string file = work.mesh_file(std::string(name(surface)));
      const auto write = [&](const TriangleMesh& mesh, const MeshNotes& notes) {
        return mesh_bytes(file, mesh, notes);
      };
      told.files.push_back({file, surface_file(joint, found, surface, write)});
    }
    told.files.push_back({"gaps.csv", gaps_csv(joint, found)});
  }
  if (request.asks(Output::distances)) told.files.push_back({"distances.csv", distances_csv(found)});
  return told;
}

}  // namespace

std::string describe_centre(const Joint& joint) {
  std::string text = formatted("centre of rotation  %.3f %.3f %.3f mm, %s", joint.centre.x(),
                               joint.centre.y(), joint.centre.z(), joint.fit ? "fitted" : "given");
  if (joint.fit) {
    text += formatted(" (radius %.2f mm, residual %.2f mm rms over %zu vertices)", joint.fit->radius,
                      joint.fit->rms, joint.fit->points);
  }
  return text + "\n";
}

QuestionCommand gaps_question() {
  QuestionCommand made = question_of<GapsRequest, GapsAnswer>(
      "gaps", "All gaps of a pose: where the joint is narrow, what impinges, with coloured meshes.",
      "femur.ply pelvis.ply --side right --pose flexion=90 --out pose", &told);
  made.takes_map = true;
  made.writes_meshes = true;
  return made;
}

}  // namespace impinge
