// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/options.hpp"

#include <CLI/CLI.hpp>

#include "scene/typed_options.hpp"
#include "sphere/scheme_choice.hpp"

namespace impinge {
namespace {

// An empty text is what a script gives whose variable is not set.
void require_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& value : option->results()) {
      if (value.empty())
        refuse_option(option->get_name(), value, "is empty; give it a value or leave it out");
    }
  }
}

// Of one joint both are needed, of a folder neither; and a place for the answer.
void require_meshes(const CLI::App& app, const SceneOptions& options) {
  for (const char* mesh : {"--ball", "--socket"}) {
    const bool given = app.count(mesh) > 0;
    if (!options.bones && !given) throw OptionError(std::string(mesh) + " is required; see scene --help");
    if (options.bones && given) throw OptionError(std::string(mesh) + " excludes --bones; see scene --help");
  }
  if (app.count("--out") == 0) throw OptionError("--out is required; see scene --help");
  if (!options.bones) return;
  for (const char* one : {"--ball-part", "--socket-part", "--centre", "--landmarks", "--poses", "--path",
                          "--certificate", "--everything", "--explain"}) {
    if (app.count(one) > 0)
      throw OptionError("option --bones: " + std::string(one) + " is of one joint; leave one of the two out");
  }
}

}  // namespace

std::optional<SceneOptions> parse_scene_options(int argc, const char* const* argv, std::string& help) {
  CLI::App app{"Gaps and impingement of a ball-and-socket joint given as two triangle meshes in mm.",
               "scene"};
  SceneOptions options;
  TypedOptions typed;
  app.add_option("--ball", options.ball, "mesh of the ball (PLY, STL, OBJ or OFF)");
  app.add_option("--socket", options.socket, "mesh of the socket, in the same frame");
  app.add_option(
      "--ball-part", options.ball_parts,
      "mesh of bone beside the ball that can stop it too, such as a trochanter, in the same frame; "
      "one or more");
  app.add_option("--socket-part", options.socket_parts,
                 "the same beside the socket, such as the anterior inferior iliac spine; one or more");
  app.add_option("--keep", typed.keep,
                 "all, or of each file only the largest of the pieces that do not hang together [all]");
  app.add_option(
      "--bones", options.bones,
      "instead of --ball and --socket: a folder with one sub-folder per joint; answers any question but "
      "all-gaps for all of them in one table");
  app.add_option("--out", options.out,
                 "output folder, created if missing; which files it gets depends on the question");
  app.add_option(
      "--overlap", typed.overlap,
      "depth along a ray to which the surfaces may overlap, mm [0]: the ball is taken so much smaller");
  app.add_option("--centre", typed.centre, "centre of rotation: fit, or X,Y,Z in mm")->capture_default_str();
  auto* scheme =
      app.add_option("--scheme", typed.scheme,
                     "read gaps from tables of this sampling scheme, not from the faces: " + scheme_names());
  auto* precision =
      app.add_option("--precision", typed.precision,
                     "spacing of the tables, degrees [0.5 with --scheme]; also turns tables on");
  auto* max_error = app.add_option("--max-error", typed.max_error,
                                   "refuse an answer unless each gap is proven to be within this error, mm")
                        ->excludes(scheme)
                        ->excludes(precision);
  auto* pose = app.add_option(
      "--pose", typed.pose,
      "motion of the ball in degrees, as flexion=90,internal_rotation=10 (also extension, abduction, "
      "adduction, external_rotation)");
  app.add_option("--side", typed.side, "side of the body: left or right; needed for abduction and rotation");
  app.add_option(
      "--axes", options.axes,
      "where +x, +y and +z of the meshes point: R/L, A/P, S/I [as SPACE= in their headers says, else RAS]");
  app.add_option(
      "--landmarks", options.landmarks,
      "markups of 3D Slicer (.mrk.json) or a CSV label,x,y,z: asis_right, asis_left, "
      "pubic_tubercle_right, pubic_tubercle_left give the frame of the pelvis, epicondyle_medial and "
      "epicondyle_lateral that of the femur, from which angles are then counted");
  app.add_option("--cartilage", typed.cartilage,
                 "thickness of both cartilage layers together in mm [4], or a CSV of it by place: "
                 "x,y,z,thickness_mm in the frame of the meshes");
  app.add_option(
         "--question", typed.question,
         "touch, first-contact (the smallest gap), limit (of --motion), limits (of all motions), volume (all "
         "rotations), measures (alpha, offset, torsion, version, coverage ...), resection or orientation "
         "(for --require), or all-gaps: experiments/scene.md says what each writes")
      ->capture_default_str();
  app.add_option(
      "--motion", typed.motion,
      "with the question limit: the motion that grows from --pose until the surfaces touch, as "
      "flexion; fadir, faber, "
      "internal_rotation_at_45, _70 or _90 and external_rotation_at_90 begin at a pose of their own; "
      "all: every motion, as --question limits");
  app.add_option(
         "--require", typed.required,
         "with the questions resection and orientation: a motion that is to be reached, as "
         "flexion=90,internal_rotation=30, along its path from the pose of the scan: flexion first, then "
         "abduction, then rotation; give it again for more of them")
      ->allow_extra_args(false);
  app.add_option("--clearance", typed.clearance,
                 "with resection: radial gap to keep along the whole motion, mm [0.5]");
  app.add_option("--cut", typed.cut, "with resection: which bone is cut, ball or socket (its rim) [ball]");
  app.add_option("--rim", typed.rim,
                 "with --cut socket: how far inside the rim the bearing surface may be cut, mm [5]");
  app.add_option(
      "--neck", typed.neck,
      "with resection: least uncut width about the axis of the neck, mm [70 % of the neck's width]");
  app.add_flag(
      "--least", typed.least,
      "with resection: also the smallest cut that may leave an undercut; the socket must be a closed mesh");
  app.add_option("--tilt", typed.tilt,
                 "with orientation: posterior pelvic tilt relative to the scan, degrees [0]");
  app.add_option("--width", typed.width,
                 "with the question volume: share of all rotations that may stay undecided [0.05]");
  app.add_option(
      "--gap", typed.gap,
      "with the question volume: smaller gaps count as contact, mm [0], e.g. the cartilage thickness");
  app.add_option(
      "--centre-within", typed.centre_within,
      "with the question volume: make the answer hold for every centre within this distance, mm [0]");
  app.add_option("--surfaces", typed.surfaces, "vertices at which gaps are measured: ball, socket or both")
      ->capture_default_str();
  auto* outputs =
      app.add_option("--outputs", typed.outputs,
                     "with all-gaps, some of gaps,bounds,distances,verdicts [all of them]; the rest is not "
                     "computed");
  auto* poses =
      app.add_option("--poses", options.poses,
                     "many poses: touch and smallest gap of each, with --question all-gaps impinged "
                     "areas too, to poses.csv. A CSV of motions "
                     "or of matrices, or a motion of OpenSim (.mot, .sto)");
  auto* path = app.add_option("--path", options.path,
                              "many poses: all combinations of angles, as "
                              "flexion=0..120/1,internal_rotation=0..40/5");
  auto* certificate = app.add_option(
      "--certificate", options.certificate,
      "a file for a proof: that the pose, or with the question limit the way to the limit, is free of "
      "contact, or that bodies touch in the pose; experiments/check_certificate.py checks it");
  path->excludes(poses);
  for (CLI::Option* many : {poses, path}) {
    for (CLI::Option* one : {pose, outputs, scheme, precision, max_error, certificate}) many->excludes(one);
  }
  app.add_flag("--explain", options.explain,
               "report how the answer was found, what was skipped and why, and what that saved");
  app.add_flag("--everything", options.everything,
               "compute all gaps and all outputs, whatever --question says");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success&) {
    help = app.help();
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw OptionError(std::string(error.what()) + "; see scene --help");
  }
  require_values(app);
  require_meshes(app, options);
  options.axes_given = app.count("--axes") > 0;
  options.areas = options.many() && typed.question == "all-gaps" && app.count("--question") > 0;
  interpret(typed, options);
  return options;
}

}  // namespace impinge
