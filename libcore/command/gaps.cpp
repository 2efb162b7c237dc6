// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/gaps.hpp"

#include <algorithm>
#include <cmath>

#include "command/pose_words.hpp"
#include "command/question_command.hpp"
#include "files/formatted.hpp"
#include "joint/joint_files.hpp"
#include "mesh/io.hpp"

namespace impinge {
namespace {

std::string describe_centre(const Joint& joint) {
  std::string text = formatted("centre of rotation  %.3f %.3f %.3f mm, %s", joint.centre.x(),
                               joint.centre.y(), joint.centre.z(), joint.fit ? "fitted" : "given");
  if (joint.fit) {
    text += formatted(" (radius %.2f mm, residual %.2f mm rms over %zu vertices)", joint.fit->radius,
                      joint.fit->rms, joint.fit->points);
  }
  return text + "\n";
}

std::string describe_table(const GapsRequest& request, const GapsAnswer& found) {
  if (found.precision_deg) {
    return formatted("table               %s at %g degrees, %zu entries a surface\n",
                     request.scheme.value_or(PoseQuestion().scheme).c_str(), *found.precision_deg,
                     found.entries_per_table);
  }
  if (!request.max_error_mm) return "table               none: gaps are those of the faces\n";
  return formatted("table               none: gaps within %g mm, of the faces\n", *request.max_error_mm);
}

// Of the main surfaces, along rays.
std::string describe_overlap(const std::optional<RadialOverlapDocument>& found) {
  if (!found) return "";
  if (!found->overlap) return "radial overlap      none\n";
  const bool vertices = found->ball.impinged + found->socket.impinged > 0;
  return "radial overlap      by up to " + rounded_up(*found->deepest_mm, 3) + " mm at a " +
         std::string(word_of(*found->deepest_at)) + (vertices ? "" : "; of no vertex") + "\n";
}

std::string describe_zones(const ImpingedDocument& found) {
  if (!found.clock_zones) return "no clock positions: the socket looks straight up, down, forward or back";
  std::string text;
  for (const ZoneDocument& zone : *found.clock_zones) {
    if (zone.from == zone.to) return "all round the clock";
    text += (text.empty() ? "" : ", ") + zone.from + "-" + zone.to;
  }
  return text.empty() ? "nowhere" : "at " + text + " o'clock";
}

std::string describe_level(const ImpingementDocument& level) {
  const std::string text = level.gap_up_to_mm ? formatted("impinged at %3g mm   ", *level.gap_up_to_mm)
                                              : std::string("cartilage touches   ");
  if (level.ball.vertices + level.socket.vertices == 0) return text + "nowhere\n";
  return text + formatted("ball %.1f mm^2 %s; socket %.1f mm^2 %s\n", level.ball.area_mm2,
                          describe_zones(level.ball).c_str(), level.socket.area_mm2,
                          describe_zones(level.socket).c_str());
}

// Megabytes as a person reads them.
std::string size_text(double bytes) {
  const double size = std::abs(bytes);
  if (size >= 1e6) return formatted("%.3g MB", size / 1e6);
  if (size >= 1e3) return formatted("%.3g kB", size / 1e3);
  return formatted("%.0f bytes", size);
}

std::string describe_way(const GapsAnswer& found) {
  std::string items;
  for (const LeftOutDocument& item : found.left_out) {
    items += (items.empty() ? "left out            " : "                    ") + item.meaning +
             (item.reason.empty() ? "" : ": " + item.reason);
    if (item.bytes_saved)
      items += (*item.bytes_saved > 0.0 ? "; saves " : "; takes ") + size_text(*item.bytes_saved) +
               (*item.bytes_saved > 0.0 ? "" : " more");
    items += "\n";
  }
  return "way                 " + found.way + "\n" +
         (items.empty() ? "left out            nothing\n" : items);
}

std::string describe_gaps(const SessionJoint& joint, const GapsRequest& request, const GapsAnswer& found) {
  std::string text = describe_centre(joint.joint) + describe_table(request, found) +
                     (found.contact ? describe(*found.contact) : "") +
                     describe_overlap(found.radial_overlap) + describe(found.nearest_part) +
                     describe(found.smallest_gap);
  if (found.smallest_gap)
    for (const ImpingementDocument& level : found.impingement) text += describe_level(level);
  return text + describe_way(found);
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
  const auto asked = [&request](Output output) {
    return request.outputs.empty() ||
           std::find(request.outputs.begin(), request.outputs.end(), output) != request.outputs.end();
  };
  if (asked(Output::gaps)) {
    for (const Surface surface : kSurfaces) {
      if (found.found.of(surface).gap.empty()) continue;
      const std::string file = work.mesh_file(std::string(name(surface)));
      const auto write = [&](const TriangleMesh& mesh, const MeshNotes& notes) {
        return mesh_bytes(file, mesh, notes);
      };
      told.files.push_back({file, surface_file(joint, found.found, surface, write)});
    }
    told.files.push_back({"gaps.csv", gaps_csv(joint, found.found)});
  }
  if (asked(Output::distances)) told.files.push_back({"distances.csv", distances_csv(found.found)});
  return told;
}

}  // namespace

QuestionCommand gaps_question() {
  QuestionCommand made = question_of<GapsRequest, GapsAnswer>(
      "gaps", "All gaps of a pose: where the joint is narrow, what impinges, with coloured meshes.",
      "femur.ply pelvis.ply --side right --pose flexion=90 --out pose", &told);
  made.takes_map = true;
  made.writes_meshes = true;
  return made;
}

std::string describe(const std::optional<SmallestGapDocument>& gap) {
  if (!gap) return "smallest gap        none: the surfaces do not face each other\n";
  std::string text = formatted("smallest gap        %.3f mm at %s vertex %zu", gap->gap_mm,
                               name(gap->surface).data(), gap->vertex);
  if (gap->clock) text += ", " + *gap->clock + " o'clock";
  if (gap->error_bound_mm && std::isfinite(*gap->error_bound_mm))
    text += " (error of this gap at most " + rounded_up(*gap->error_bound_mm, 3) + " mm)";
  if (gap->euclidean_distance_mm) {
    text += "\nEuclidean distance  " + rounded_down(gap->euclidean_distance_mm->front(), 3) + " to " +
            rounded_up(gap->euclidean_distance_mm->back(), 3) + " mm there";
  }
  return text + "\n";
}

std::string describe(const std::optional<NearestPartDocument>& part) {
  if (!part) return "";
  const std::string bodies =
      part->ball_part.value_or("ball") + " and " + part->socket_part.value_or("socket");
  if (part->touch) return "parts               " + bodies + " touch\n";
  return "parts               " + bodies + " are nearest, " + rounded_down(part->distance_mm, 3) +
         " mm apart\n";
}

}  // namespace impinge
