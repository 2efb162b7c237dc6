// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/report.hpp"

#include "files/file_set.hpp"
#include "files/formatted.hpp"
#include "joint/joint_files.hpp"
#include "scene/contact.hpp"
#include "scene/proof_json.hpp"
#include "scene/question.hpp"

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

std::string describe_table(const SceneOptions& options, const Measurement& found) {
  if (options.by_tables()) {
    return formatted("table               %s at %g degrees, %zu entries a surface\n", options.scheme.c_str(),
                     found.precision_deg, found.entries);
  }
  if (!options.max_error_mm) return "table               none: gaps are those of the faces\n";
  return formatted("table               none: gaps within %g mm, of the faces\n", *options.max_error_mm);
}

// Of the main surfaces, along rays.
std::string describe_certificate(const std::optional<Certificate>& found) {
  if (!found) return "";
  if (!found->deepest) return "radial overlap      none\n";
  return "radial overlap      by up to " + rounded_up(found->deepest->depth, 3) + " mm at a " +
         std::string(word_of(found->deepest->kind)) + (found->vertices_impinged() ? "" : "; of no vertex") +
         "\n";
}

std::string describe_part(const std::optional<NearestPartDocument>& part) {
  if (!part) return "";
  const std::string bodies =
      part->ball_part.value_or("ball") + " and " + part->socket_part.value_or("socket");
  if (part->touch) return "parts               " + bodies + " touch\n";
  return "parts               " + bodies + " are nearest, " + rounded_down(part->distance_mm, 3) +
         " mm apart\n";
}

std::string describe_smallest(const SmallestOfPose& smallest, const SurfaceAnswer& of) {
  const std::size_t i = smallest.vertex;
  std::string text = formatted("smallest gap        %.3f mm at %s vertex %zu", smallest.gap_mm,
                               name(smallest.surface).data(), i);
  if (smallest.hours) text += ", " + clock_text(*smallest.hours) + " o'clock";
  if (!of.bound.empty() && std::isfinite(of.bound[i]))
    text += " (error of this gap at most " + rounded_up(of.bound[i], 3) + " mm)";
  if (!of.distance.empty()) {
    text += "\nEuclidean distance  " + rounded_down(of.distance[i].lower_mm, 3) + " to " +
            rounded_up(of.distance[i].upper_mm, 3) + " mm there";
  }
  return text;
}

std::string describe_zones(const SessionJoint& joint, const std::vector<ClockZone>& zones) {
  if (!joint.dial) return "no clock positions: the socket looks straight up, down, forward or back";
  std::string text;
  for (const ClockZone& zone : zones) {
    const std::string from = clock_text(zone.from);
    const std::string to = clock_text(zone.to);
    if (from == to) return "all round the clock";
    if (!text.empty()) text += ", ";
    text.append(from).append("-").append(to);
  }
  return text.empty() ? "nowhere" : "at " + text + " o'clock";
}

std::string describe_level(const SessionJoint& joint, const Measurement& found, bool bone) {
  std::string text = !bone && joint.joint.cartilage
                         ? std::string("\ncartilage touches   ")
                         : formatted("\nimpinged at %3g mm   ", bone ? 0.0 : found.ball.touching);
  const GapSummary& ball = bone ? found.ball.bone : found.ball.cartilage;
  const GapSummary& socket = bone ? found.socket.bone : found.socket.cartilage;
  if (ball.impinged + socket.impinged == 0) return text + "nowhere";
  const auto& ball_zones = bone ? found.ball.bone_zones : found.ball.cartilage_zones;
  const auto& socket_zones = bone ? found.socket.bone_zones : found.socket.cartilage_zones;
  return text + formatted("ball %.1f mm^2 %s; socket %.1f mm^2 %s", ball.impinged_area,
                          describe_zones(joint, ball_zones).c_str(), socket.impinged_area,
                          describe_zones(joint, socket_zones).c_str());
}

}  // namespace

std::string describe_scene(const SceneOptions& options, const SessionJoint& joint, const Measurement& found) {
  std::string text = describe_centre(joint.joint) + describe_table(options, found) +
                     (found.contact ? describe_contact(joint.joint, *found.contact) : "") +
                     describe_certificate(found.certificate) + describe_part(found.part);
  if (!found.smallest) return text + "smallest gap        none: the surfaces do not face each other\n";
  text += describe_smallest(*found.smallest, found.of(found.smallest->surface));
  text += describe_level(joint, found, true);
  if (found.ball.touching > 0.0) text += describe_level(joint, found, false);
  return text + "\n";
}

void write_scene(const SceneOptions& options, const SessionJoint& joint, const Measurement& measurement,
                 const nlohmann::json& summary) {
  FileSet files;
  if (options.outputs.gaps) {
    for (const Surface surface : kSurfaces) {
      if (measurement.of(surface).gap.empty()) continue;
      files.add(options.out / (std::string(name(surface)) + ".ply"),
                surface_ply(joint, measurement, surface));
    }
    files.add(options.out / "gaps.csv", gaps_csv(joint, measurement));
  }
  if (options.outputs.distances) files.add(options.out / "distances.csv", distances_csv(measurement));
  files.add(options.out / "summary.json", json_text(summary));
  files.commit();
}

}  // namespace impinge
