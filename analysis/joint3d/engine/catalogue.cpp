// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "hip/hip_presets.hpp"
#include "hip/named_motion.hpp"
#include "hip/recorded_range.hpp"
#include "joint/limits.hpp"
#include "sphere/scheme_list.hpp"

namespace impinge {
namespace {

constexpr std::array kPrecisions{4.0, 2.0, 1.0, 0.5, 0.35, 0.25, 0.2};  // degrees, of those that a scheme has

// "neck_shaft_angle" as a person writes it.
std::string label_of(std::string_view name) {
  std::string label(name);
  std::ranges::replace_if(
      label, [](char c) { return c == '_'; }, ' ');
  if (!label.empty()) label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
  return label;
}

double step_of(std::string_view unit) {
  return unit == "mm" ? 0.1 : unit == "deg" ? 1.0 : unit == "h" ? 0.25 : 0.01;
}

val preset_value(std::string_view name) {
  const HipParameters parameters = hip_preset(name);
  const bool patient = name.starts_with("patient_");
  const std::string label =
      patient ? "Patient " + std::string(1, static_cast<char>(std::toupper(name.back()))) + " (stand-in)"
              : label_of(name);
  return object(std::pair("name", text(name)), std::pair("label", label),
                std::pair("side", text(word_of(parameters.side))),
                std::pair("parameters", parameters_value(parameters)));
}

val parameter_value(const HipParameter& parameter) {
  return object(std::pair("key", text(parameter.name)), std::pair("label", label_of(parameter.name)),
                std::pair("meaning", text(parameter.meaning)), std::pair("unit", text(parameter.unit)),
                std::pair("least", parameter.least), std::pair("most", parameter.most),
                std::pair("step", step_of(parameter.unit)));
}

// "Internal rotation at 45 degrees of flexion", "FADIR (at 90 of flexion and 15 of adduction)".
std::string motion_label(const NamedMotion& motion) {
  if (motion.name.starts_with(motion.growing) && motion.name != motion.growing)
    return label_of(motion.growing) + " " + std::string(motion.meaning);
  std::string label = label_of(motion.name);
  if (motion.name != motion.growing) {
    std::ranges::transform(label, label.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  }
  return label + " (" + std::string(motion.meaning) + ")";
}

val named_motion_value(const NamedMotion& motion) {
  return object(std::pair("name", text(motion.name)), std::pair("label", motion_label(motion)),
                std::pair("start", val_of(json_of(motion.start))),
                std::pair("growing", text(motion.growing)));
}

val recorded_value(const RecordedRange& range) {
  return object(std::pair("motion", text(range.motion)), std::pair("label", label_of(range.motion)),
                std::pair("patient_a", range.patient_a), std::pair("patient_b", range.patient_b));
}

// Of limits of the rim alone, as the program's help has it.
val rim_meaning() {
  std::string_view meaning;
  for_each_field<LimitsRequest>([&](const auto& field) {
    if (field.name == "rim") meaning = field.text;
  });
  return text(meaning);
}

template <SamplingScheme S>
val scheme_value() {
  val precisions = val::array();
  for (const double precision : kPrecisions) {
    if (scheme_of_precision<S>(precision)) precisions.call<void>("push", precision);
  }
  return object(std::pair("name", text(S::name)), std::pair("label", text(S::label)),
                std::pair("precisions", precisions));
}

}  // namespace

val parameters_value(const HipParameters& parameters) {
  val values = val::object();
  for (const HipParameter& parameter : hip_parameter_list())
    values.set(std::string(parameter.name), parameters.*parameter.value);
  return values;
}

val catalogue() {
  val schemes = val::array();
  for_each_scheme([&]<class S>() { schemes.call<void>("push", scheme_value<S>()); });
  return object(std::pair("presets", list(hip_preset_names(), preset_value)),
                std::pair("parameters", list(hip_parameter_list(), parameter_value)),
                std::pair("motions", list(named_motions(), named_motion_value)),
                std::pair("recorded", list(kRecordedRanges, recorded_value)), std::pair("schemes", schemes),
                std::pair("rim", rim_meaning()));
}

}  // namespace impinge
