// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/options.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include <CLI/CLI.hpp>

#include "files/one_line.hpp"
#include "hip/anatomy.hpp"
#include "scene/pose_list.hpp"
#include "sphere/scheme_choice.hpp"

namespace impinge {
namespace {

// The options as they are typed; the empty text stands for an option not given.
struct Typed {
  std::string centre = "fit";
  std::string scheme;
  std::string precision;
  std::string max_error;
  std::string pose;
  std::string side;
  std::string cartilage;
  std::string question = "all-gaps";
  std::string motion;
  std::string surfaces = "both";
  std::string outputs;
};

[[noreturn]] void refuse(std::string_view option, std::string_view value, std::string_view advice) {
  throw OptionError("option " + std::string(option) + ": '" + std::string(value) + "' " +
                    std::string(advice));
}

double parse_number(std::string_view option, std::string_view text, std::string_view advice) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    refuse(option, text, advice);
  return value;
}

Vec3 parse_centre(const std::string& text) {
  constexpr std::string_view advice = "is no centre; give 'fit' or three numbers in mm as X,Y,Z";
  Vec3 centre;
  std::string_view rest = text;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const std::size_t comma = rest.find(',');
    if ((comma == rest.npos) != (k == 2)) refuse("--centre", text, advice);
    centre[k] = parse_number("--centre", rest.substr(0, comma), advice);
    rest.remove_prefix(comma == rest.npos ? rest.size() : comma + 1);
  }
  return centre;
}

// Turns an exception of a parser in the library into one that names the option.
template <class Parse>
auto for_option(std::string_view option, Parse&& parse) {
  try {
    return parse();
  } catch (const OptionError&) {
    throw;  // names its option already
  } catch (const std::invalid_argument& error) {
    throw OptionError("option " + std::string(option) + ": " + error.what());
  }
}

// An empty text is what a script gives whose variable is not set.
void require_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& value : option->results()) {
      if (value.empty()) refuse(option->get_name(), value, "is empty; give it a value or leave it out");
    }
  }
}

void set_accuracy(const Typed& typed, SceneOptions& options) {
  if (!typed.max_error.empty()) {
    constexpr std::string_view advice = "is no accuracy; give a number of mm above 0";
    options.max_error_mm = parse_number("--max-error", typed.max_error, advice);
    if (*options.max_error_mm <= 0.0) refuse("--max-error", typed.max_error, advice);
  }
  if (!typed.precision.empty()) {
    options.precision_deg =
        parse_number("--precision", typed.precision, "is no precision; give a number of degrees");
  }
  if (!typed.scheme.empty()) {
    options.scheme = typed.scheme;
    if (!options.by_tables()) options.precision_deg = kUsualPrecision;
  }
  for_option("--scheme", [&] {
    with_scheme(options.scheme, [&]<class S>() {
      for_option("--precision",
                 [&] { return S::with_precision(options.precision_deg.value_or(kUsualPrecision)); });
    });
    return 0;
  });
}

// A limit is found on the faces: of the outputs of tables it has none.
void set_limit(const Typed& typed, SceneOptions& options) {
  if (typed.motion.empty())
    refuse("--question", typed.question,
           "needs the motion whose limit is wanted; add it, as --motion flexion");
  if (options.cartilage_map)
    refuse("--cartilage", typed.cartilage, "is a map, and a limit has one threshold; give a number of mm");
  options.question = Question::first_contact;
  for_option("--motion", [&] {
    options.limit = &motion_name(typed.motion);
    largest_growth(options.motion, *options.limit);
    if (!options.side && options.limit->angle != &Motion::flexion)
      throw std::invalid_argument(
          "abduction and rotation need to know the side; give left or right with --side");
    return 0;
  });
}

void set_question(const Typed& typed, SceneOptions& options) {
  if (typed.question == "touch") {
    options.question = Question::touch;
  } else if (typed.question == "first-contact") {
    options.question = Question::first_contact;
  } else if (typed.question == "limit") {
    set_limit(typed, options);
  } else if (typed.question != "all-gaps") {
    refuse("--question", typed.question, "is no question; ask touch, first-contact, limit or all-gaps");
  }
  if (!typed.motion.empty() && options.limit == nullptr)
    refuse("--motion", typed.motion, "comes with the question limit alone; add --question limit");
  if (typed.surfaces != "both" && typed.surfaces != "ball" && typed.surfaces != "socket")
    refuse("--surfaces", typed.surfaces, "is no choice of surfaces; give ball, socket or both");
  options.scan_ball = typed.surfaces != "socket";
  options.scan_socket = typed.surfaces != "ball";
}

void set_outputs(const Typed& typed, SceneOptions& options) {
  if (options.question != Question::all_gaps) options.outputs = {false, false, false, false};
  if (typed.outputs.empty()) return;
  if (options.question != Question::all_gaps)
    refuse("--outputs", typed.outputs,
           "come with the question all-gaps alone; leave one of the two options out");
  options.outputs = {false, false, false, false};
  std::string_view rest = typed.outputs;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const std::string_view word = rest.substr(0, comma);
    bool* const output = word == "gaps"        ? &options.outputs.gaps
                         : word == "bounds"    ? &options.outputs.bounds
                         : word == "distances" ? &options.outputs.distances
                         : word == "verdicts"  ? &options.outputs.verdicts
                                               : nullptr;
    if (output == nullptr)
      refuse("--outputs", word,
             "is no output; give some of gaps, bounds, distances and verdicts, with commas between");
    *output = true;
    more = comma != rest.npos;
    rest.remove_prefix(more ? comma + 1 : 0);
  }
}

// What one pose alone is asked, and many are not.
void require_for_many(const Typed& typed, SceneOptions& options) {
  const std::string option = options.poses ? "--poses" : "--path";
  if (options.limit != nullptr || options.everything || typed.surfaces != "both" ||
      !typed.cartilage.empty()) {
    throw OptionError("option " + option +
                      ": of many poses touch and the smallest gap of both surfaces are worked out; leave out "
                      "--question limit, --surfaces, --cartilage and --everything");
  }
  if (!options.path) return;
  for_option("--path", [&] {
    if (parse_pose_grid(*options.path).needs_side() && !options.side)
      throw std::invalid_argument(
          "abduction and rotation need to know the side; give left or right with --side");
    return 0;
  });
}

// Both surfaces are in the outputs that compare them.
void require_both_surfaces(const Typed& typed, const SceneOptions& options) {
  if (typed.surfaces == "both" || options.question != Question::all_gaps) return;
  const PoseOutputs& outputs = options.outputs;
  if (!typed.outputs.empty() && !outputs.bounds && !outputs.distances && !outputs.verdicts) return;
  refuse("--surfaces", typed.surfaces,
         "leaves out what bounds, distances and verdicts need; add --outputs gaps");
}

// A number is one thickness, anything else a file.
void set_cartilage(const Typed& typed, SceneOptions& options) {
  const std::string& text = typed.cartilage;
  if (text.empty()) return;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool number = error == std::errc() && end == text.data() + text.size();
  std::error_code ignored;
  if (!number && std::filesystem::exists(text, ignored)) {
    options.cartilage_map = text;
    return;
  }
  if (!number || !(value >= 0.0 && std::isfinite(value))) {
    refuse("--cartilage", text,
           "is no thickness and no file; give a number of mm, 0 or more, or a CSV of x,y,z,thickness_mm");
  }
  options.cartilage_mm = value;
}

void interpret(const Typed& typed, SceneOptions& options) {
  if (typed.centre != "fit") options.centre = parse_centre(typed.centre);
  set_accuracy(typed, options);
  for_option("--axes", [&] { return input_to_joint(options.axes); });
  if (!typed.side.empty()) options.side = for_option("--side", [&] { return parse_side(typed.side); });
  if (!typed.pose.empty()) {
    options.pose = typed.pose;
    options.motion = for_option("--pose", [&] { return parse_motion(typed.pose); });
    for_option("--pose", [&] {
      try {
        return joint_rotation(options.motion, options.side);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(std::string(error.what()) + " with --side");
      }
    });
  }
  set_cartilage(typed, options);
  set_question(typed, options);
  set_outputs(typed, options);
  require_both_surfaces(typed, options);
  if (options.many()) require_for_many(typed, options);
  if (!options.everything) return;
  options.question = Question::all_gaps;
  options.limit = nullptr;
  options.scan_ball = options.scan_socket = true;
  options.outputs = {};
}

}  // namespace

OptionError::OptionError(const std::string& message) : std::invalid_argument(one_line(message)) {}

std::optional<SceneOptions> parse_scene_options(int argc, const char* const* argv, std::string& help) {
  CLI::App app{"Gaps and impingement of a ball-and-socket joint given as two triangle meshes in mm.",
               "scene"};
  SceneOptions options;
  Typed typed;
  app.add_option("--ball", options.ball, "mesh of the ball (PLY, STL, OBJ or OFF)")->required();
  app.add_option("--socket", options.socket, "mesh of the socket, in the same frame")->required();
  app.add_option("--out", options.out,
                 "folder for what it writes, made where it is missing: ball.ply, socket.ply, "
                 "gaps.csv, distances.csv and summary.json")
      ->required();
  app.add_option("--centre", typed.centre, "centre of rotation: fit, or X,Y,Z in mm")->capture_default_str();
  auto* scheme =
      app.add_option("--scheme", typed.scheme,
                     "answer by tables of this sampling scheme, and not by the faces: " + scheme_names());
  auto* precision = app.add_option("--precision", typed.precision,
                                   "answer by tables of that spacing, degrees [0.5 with --scheme]");
  auto* max_error = app.add_option("--max-error", typed.max_error, "or the proven error of every gap in mm")
                        ->excludes(precision);
  auto* pose = app.add_option(
      "--pose", typed.pose,
      "motion of the ball in degrees, as flexion=90,internal_rotation=10 (also extension, abduction, "
      "adduction, external_rotation)");
  app.add_option("--side", typed.side, "left or right, which abduction and rotation need");
  app.add_option("--axes", options.axes, "where +x, +y and +z of the meshes point: R/L, A/P, S/I")
      ->capture_default_str();
  app.add_option("--cartilage", typed.cartilage,
                 "thickness of both cartilage layers together in mm [4], or a CSV of it by place: "
                 "x,y,z,thickness_mm in the frame of the meshes");
  app.add_option("--question", typed.question,
                 "touch, first-contact (the smallest gap), limit (of --motion) or all-gaps; the others write "
                 "summary.json alone")
      ->capture_default_str();
  app.add_option(
      "--motion", typed.motion,
      "with the question limit: the motion that grows from --pose until the surfaces touch, as flexion");
  app.add_option("--surfaces", typed.surfaces, "whose vertices are looked up: ball, socket or both")
      ->capture_default_str();
  auto* outputs = app.add_option(
      "--outputs", typed.outputs,
      "with all-gaps, some of gaps,bounds,distances,verdicts [all of them]; what is not asked for is not "
      "worked out");
  auto* poses = app.add_option("--poses", options.poses,
                               "many poses: touch and smallest gap of each, to poses.csv. A CSV of motions "
                               "or of matrices, or a motion of OpenSim (.mot, .sto)");
  auto* path = app.add_option("--path", options.path,
                              "many poses: all combinations of angles, as "
                              "flexion=0..120/1,internal_rotation=0..40/5");
  path->excludes(poses);
  for (CLI::Option* many : {poses, path}) {
    for (CLI::Option* one : {pose, outputs, scheme, precision, max_error}) many->excludes(one);
  }
  app.add_flag("--explain", options.explain,
               "say which way was taken and what is left out, why, and what that saves");
  app.add_flag("--everything", options.everything, "leave nothing out, to compare");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success&) {
    help = app.help();
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw OptionError(std::string(error.what()) + "; see scene --help");
  }
  require_values(app);
  interpret(typed, options);
  return options;
}

}  // namespace impinge
