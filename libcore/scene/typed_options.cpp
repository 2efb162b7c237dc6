// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/typed_options.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "files/finite_number.hpp"
#include "files/one_line.hpp"
#include "hip/anatomy.hpp"
#include "hip/named_motion.hpp"
#include "joint/pose_list.hpp"
#include "sphere/scheme_choice.hpp"

namespace impinge {

OptionError::OptionError(const std::string& message) : std::invalid_argument(one_line(message)) {}

void refuse_option(std::string_view option, std::string_view value, std::string_view advice) {
  throw OptionError("option " + std::string(option) + ": '" + std::string(value) + "' " +
                    std::string(advice));
}

namespace {

double parse_number(std::string_view option, std::string_view text, std::string_view advice) {
  const std::optional<double> value = finite_number(text);
  if (!value) refuse_option(option, text, advice);
  return *value;
}

// A number of mm.
double parse_positive(std::string_view option, std::string_view text) {
  constexpr std::string_view advice = "is no length; give a number of mm above 0";
  const double value = parse_number(option, text, advice);
  if (!(value > 0.0)) refuse_option(option, text, advice);
  return value;
}

// A number of mm; 0 where it is not given.
double parse_length(std::string_view option, std::string_view text) {
  constexpr std::string_view advice = "is no length; give a number of mm, 0 or more";
  const double value = text.empty() ? 0.0 : parse_number(option, text, advice);
  if (value < 0.0) refuse_option(option, text, advice);
  return value;
}

double parse_tilt(std::string_view text) {
  constexpr std::string_view advice = "is no tilt; give degrees from -90 to 90, backwards positive";
  const double value = parse_number("--tilt", text, advice);
  if (!(std::abs(value) <= 90.0)) refuse_option("--tilt", text, advice);
  return value;
}

Vec3 parse_centre(const std::string& text) {
  constexpr std::string_view advice = "is no centre; give 'fit' or three numbers in mm as X,Y,Z";
  Vec3 centre;
  std::string_view rest = text;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const std::size_t comma = rest.find(',');
    if ((comma == rest.npos) != (k == 2)) refuse_option("--centre", text, advice);
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

void set_accuracy(const TypedOptions& typed, SceneOptions& options) {
  if (!typed.max_error.empty()) {
    constexpr std::string_view advice = "is no accuracy; give a number of mm above 0";
    options.max_error_mm = parse_number("--max-error", typed.max_error, advice);
    if (*options.max_error_mm <= 0.0) refuse_option("--max-error", typed.max_error, advice);
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

std::string motion_advice() {
  std::string names;
  for (const NamedMotion& motion : named_motions()) names += std::string(motion.name) + ", ";
  return "there are " + names + "all";
}

bool still(const Motion& motion) {
  return motion.flexion == 0.0 && motion.abduction == 0.0 && motion.internal_rotation == 0.0;
}

// Those that a clinician does in flexion bring the pose that they begin at.
void set_motion(const TypedOptions& typed, SceneOptions& options) {
  const auto named =
      std::ranges::find(named_motions(), options.all_motions ? "flexion" : typed.motion, &NamedMotion::name);
  if (named == named_motions().end())
    throw std::invalid_argument("unknown motion '" + typed.motion + "'; " + motion_advice());
  options.limit = &motion_name(named->growing);
  if (still(named->start) && !options.all_motions) return;
  if (!typed.pose.empty())
    throw std::invalid_argument("'" + typed.motion + "' begins at a pose of its own; leave --pose out");
  options.motion = named->start;
  if (!options.all_motions) options.pose = std::string(named->meaning);
}

// A limit is found on the faces: of the outputs of tables it has none.
void set_limit(const TypedOptions& typed, SceneOptions& options) {
  const bool all = typed.question == "limits" || typed.motion == "all";
  if (typed.question == "limits" && !typed.motion.empty())
    refuse_option("--motion", typed.motion, "is one motion, and limits are of all; leave it out");
  if (typed.question == "limits" && !options.side && !options.bones)
    refuse_option("--question", typed.question,
                  "needs the side of the body; add --side left or --side right");
  if (!all && typed.motion.empty())
    refuse_option("--question", typed.question,
                  "needs the motion whose limit is wanted; add it, as --motion flexion");
  if (options.cartilage_map)
    refuse_option("--cartilage", typed.cartilage,
                  "is a map, and a limit has one threshold; give a number of mm");
  options.question = Question::first_contact;
  options.motion_asked = all ? "all" : typed.motion;
  options.all_motions = all;
  for_option("--motion", [&] {
    set_motion(typed, options);
    largest_growth(options.motion, *options.limit);
    if (!options.side && !options.bones && (options.all_motions || options.limit->angle != &Motion::flexion))
      throw std::invalid_argument(
          "abduction and rotation need to know the side; give left or right with --side");
    return 0;
  });
}

// One of the required motions, along whose path something turns.
Motion parse_required(const std::string& text, bool knows_side) {
  return for_option("--require", [&] {
    const Motion motion = parse_motion(text);
    if (motion.flexion == 0.0 && motion.abduction == 0.0 && motion.internal_rotation == 0.0)
      throw std::invalid_argument("'" + text + "' moves nothing; give an angle other than 0");
    if (!knows_side && (motion.abduction != 0.0 || motion.internal_rotation != 0.0))
      throw std::invalid_argument(
          "abduction and rotation need to know the side; give left or right with --side");
    return motion;
  });
}

// Which bone is cut, and what is asked of that one alone.
void set_cut(const TypedOptions& typed, ChangeOptions& change) {
  if (!typed.cut.empty() && typed.cut != "ball" && typed.cut != "socket")
    refuse_option("--cut", typed.cut, "is no bone that can be cut; give ball or socket");
  change.cut = typed.cut == "socket" ? Surface::socket : Surface::ball;
  const bool of_ball = change.cut == Surface::ball;
  if (!typed.neck.empty() && !of_ball)
    refuse_option("--neck", typed.neck, "is of a cut of the ball; leave it or --cut socket out");
  if (typed.least && !of_ball)
    throw OptionError("option --least: is a cut of the ball; leave it or --cut socket out");
  if (!typed.rim.empty() && of_ball)
    refuse_option("--rim", typed.rim, "is of a cut of the socket; add --cut socket");
  if (!typed.neck.empty()) change.least_neck_mm = parse_positive("--neck", typed.neck);
  if (!typed.rim.empty()) change.most_rim_mm = parse_positive("--rim", typed.rim);
  change.least = typed.least;
}

void set_change(const TypedOptions& typed, SceneOptions& options) {
  if (typed.required.empty())
    refuse_option("--question", typed.question,
                  "needs the motions that are to be reached; add them, as --require flexion=90");
  if (!typed.pose.empty())
    refuse_option("--pose", typed.pose, "has no place here: required motions begin in the pose of the scan");
  if (options.many())
    refuse_option("--question", typed.question, "is asked of required motions; leave out --path and --poses");
  options.question = Question::first_contact;
  ChangeOptions change;
  for (const std::string& text : typed.required) {
    change.required.push_back(parse_required(text, options.side || options.bones));
    change.text += (change.text.empty() ? "" : "; ") + text;
  }
  if (!typed.clearance.empty()) change.clearance_mm = parse_positive("--clearance", typed.clearance);
  set_cut(typed, change);
  change.of_socket = typed.question == "orientation";
  if (!typed.tilt.empty()) change.tilt_deg = parse_tilt(typed.tilt);
  if (change.of_socket && !options.side && !options.bones)
    refuse_option("--question", typed.question, "needs to know the side; give left or right with --side");
  options.change = std::move(change);
}

// All rotations are asked for.
void set_volume(const TypedOptions& typed, SceneOptions& options) {
  VolumeOptions volume;
  if (!typed.width.empty()) {
    constexpr std::string_view advice = "is no share; give a number above 0 and below 1, as 0.01";
    volume.width = parse_number("--width", typed.width, advice);
    if (!(volume.width > 0.0 && volume.width < 1.0)) refuse_option("--width", typed.width, advice);
  }
  volume.gap_mm = parse_length("--gap", typed.gap);
  volume.centre_within_mm = parse_length("--centre-within", typed.centre_within);
  options.volume = volume;
}

// A volume is of all poses.
void require_all_poses(const TypedOptions& typed, const SceneOptions& options) {
  if (!typed.pose.empty())
    refuse_option("--pose", typed.pose, "is one pose, and the question is about all of them; leave it out");
  if (options.many())
    refuse_option("--question", typed.question, "is about all poses; leave out --poses and --path");
}

// Options of a question that was not asked.
void require_asked(const TypedOptions& typed) {
  const std::string required = typed.required.empty() ? "" : typed.required.front();
  const auto belongs = [&](const char* option, const std::string& text, std::string_view first,
                           std::string_view second = "") {
    if (text.empty() || typed.question == first || typed.question == second) return;
    const std::string name(first);
    refuse_option(option, text,
                  second.empty() ? "comes with the question " + name + " alone; add --question " + name
                                 : "comes with the questions " + name + " and " + std::string(second) +
                                       " alone; add one of them");
  };
  if (typed.question != "limits") belongs("--motion", typed.motion, "limit");
  belongs("--require", required, "resection", "orientation");
  belongs("--clearance", typed.clearance, "resection");
  belongs("--cut", typed.cut, "resection");
  belongs("--rim", typed.rim, "resection");
  belongs("--neck", typed.neck, "resection");
  if (typed.least && typed.question != "resection")
    throw OptionError("option --least: comes with the question resection alone; add --question resection");
  belongs("--tilt", typed.tilt, "orientation");
  belongs("--width", typed.width, "volume");
  belongs("--gap", typed.gap, "volume");
  belongs("--centre-within", typed.centre_within, "volume");
}

void set_question(const TypedOptions& typed, SceneOptions& options) {
  if (typed.question == "touch") {
    options.question = Question::touch;
  } else if (typed.question == "first-contact") {
    options.question = Question::first_contact;
  } else if (typed.question == "limit" || typed.question == "limits") {
    set_limit(typed, options);
  } else if (typed.question == "volume") {
    options.question = Question::first_contact;
    set_volume(typed, options);
  } else if (typed.question == "resection" || typed.question == "orientation") {
    set_change(typed, options);
  } else if (typed.question == "measures") {
    options.question = Question::first_contact;
    options.measures = true;
    if (!options.side && !options.bones)
      refuse_option("--question", typed.question, "need to know the side; give left or right with --side");
  } else if (typed.question != "all-gaps") {
    refuse_option("--question", typed.question,
                  "is no question; ask touch, first-contact, limit, limits, volume, measures, resection, "
                  "orientation or all-gaps");
  }
  if (typed.surfaces != "both" && typed.surfaces != "ball" && typed.surfaces != "socket")
    refuse_option("--surfaces", typed.surfaces, "is no choice of surfaces; give ball, socket or both");
  options.scan_ball = typed.surfaces != "socket";
  options.scan_socket = typed.surfaces != "ball";
}

void set_outputs(const TypedOptions& typed, SceneOptions& options) {
  if (options.question != Question::all_gaps) options.outputs = {false, false, false, false};
  if (typed.outputs.empty()) return;
  if (options.question != Question::all_gaps)
    refuse_option("--outputs", typed.outputs,
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
      refuse_option("--outputs", word,
                    "is no output; give some of gaps, bounds, distances and verdicts, with commas between");
    *output = true;
    more = comma != rest.npos;
    rest.remove_prefix(more ? comma + 1 : 0);
  }
}

// What one pose alone is asked, and many are not.
void require_for_many(const TypedOptions& typed, SceneOptions& options) {
  const std::string option = options.poses ? "--poses" : "--path";
  const bool cartilage = typed.cartilage.empty() || (options.areas && !options.cartilage_map);
  if (options.limit != nullptr || options.measures || options.everything || typed.surfaces != "both" ||
      !cartilage) {
    throw OptionError("option " + option +
                      ": many poses give touch and the smallest gap of both surfaces only; leave out "
                      "--question limit or measures, --surfaces and --everything; --cartilage needs "
                      "--question all-gaps and a number of mm");
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
void require_both_surfaces(const TypedOptions& typed, const SceneOptions& options) {
  if (typed.surfaces == "both" || options.question != Question::all_gaps) return;
  const PoseOutputs& outputs = options.outputs;
  if (!typed.outputs.empty() && !outputs.bounds && !outputs.distances && !outputs.verdicts) return;
  refuse_option("--surfaces", typed.surfaces,
                "leaves out what bounds, distances and verdicts need; add --outputs gaps");
}

// A number is one thickness, anything else a file.
void set_cartilage(const TypedOptions& typed, SceneOptions& options) {
  const std::string& text = typed.cartilage;
  if (text.empty()) return;
  const std::optional<double> value = finite_number(text);
  std::error_code ignored;
  if (!value && std::filesystem::exists(text, ignored)) {
    options.cartilage_map = text;
    return;
  }
  if (!value || *value < 0.0) {
    refuse_option(
        "--cartilage", text,
        "is no thickness and no file; give a number of mm, 0 or more, or a CSV of x,y,z,thickness_mm");
  }
  options.cartilage_mm = *value;
}

}  // namespace

void interpret(const TypedOptions& typed, SceneOptions& options) {
  if (typed.centre != "fit") options.centre = parse_centre(typed.centre);
  if (typed.keep != "all" && typed.keep != "largest")
    refuse_option("--keep", typed.keep, "is no choice of pieces; give all or largest");
  options.keep_largest = typed.keep == "largest";
  options.overlap_mm = parse_length("--overlap", typed.overlap);
  set_accuracy(typed, options);
  for_option("--axes", [&] { return input_to_joint(options.axes); });
  if (!typed.side.empty()) options.side = for_option("--side", [&] { return parse_side(typed.side); });
  if (!typed.pose.empty()) {
    options.pose = typed.pose;
    options.motion = for_option("--pose", [&] { return parse_motion(typed.pose); });
    for_option("--pose", [&] {
      try {
        return joint_rotation(options.motion, options.bones ? std::optional(Side::right) : options.side);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(std::string(error.what()) + " with --side");
      }
    });
  }
  set_cartilage(typed, options);
  set_question(typed, options);
  require_asked(typed);
  set_outputs(typed, options);
  if (options.volume) require_all_poses(typed, options);
  require_both_surfaces(typed, options);
  if (options.many()) require_for_many(typed, options);
  if (options.certificate && options.landmarks)
    throw OptionError(
        "option --certificate: it is about the meshes as they lie in their files; leave out --landmarks");
  if (options.certificate && (options.overlap_mm > 0.0 || options.keep_largest))
    throw OptionError(
        "option --certificate: it is about all of the meshes in their files; leave out --overlap and --keep");
  if (options.certificate && options.all_motions)
    throw OptionError(
        "option --certificate: it is of one pose or motion; add --question limit --motion NAME");
  if (options.bones && options.question == Question::all_gaps)
    throw OptionError("option --bones: its answer is a table; add a --question other than all-gaps");
  if (!options.everything) return;
  options.question = Question::all_gaps;
  options.limit = nullptr;
  options.change.reset();
  options.measures = false;
  options.volume.reset();
  options.scan_ball = options.scan_socket = true;
  options.outputs = {};
}

}  // namespace impinge
