// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "hip/hip_presets.hpp"
#include "hip/named_motion.hpp"
#include "hip/recorded_range.hpp"
#include "joint/limits.hpp"
#include "replies.hpp"
#include "sphere/scheme_list.hpp"

namespace impinge {
namespace {

constexpr std::array kPrecisions{4.0, 2.0, 1.0, 0.5, 0.35, 0.25, 0.2};  // degrees, of those that a scheme has

Json preset_document(std::string_view name) {
  const HipParameters parameters = hip_preset(name);
  return {
      {"name", name}, {"side", word_of(parameters.side)}, {"parameters", parameters_document(parameters)}};
}

Json parameter_document(const HipParameter& parameter) {
  return {{"key", parameter.name},
          {"meaning", parameter.meaning},
          {"unit", parameter.unit},
          {"least", parameter.least},
          {"most", parameter.most}};
}

Json motion_document(const NamedMotion& motion) {
  return {{"name", motion.name},
          {"start", json_of(motion.start)},
          {"growing", motion.growing},
          {"meaning", motion.meaning}};
}

Json recorded_document(const RecordedRange& range) {
  return {{"motion", range.motion}, {"patient_a", range.patient_a}, {"patient_b", range.patient_b}};
}

Json schemes_document() {
  Json schemes = Json::array();
  for_each_scheme([&]<class S>() {
    Json precisions = Json::array();
    for (const double precision : kPrecisions)
      if (scheme_of_precision<S>(precision)) precisions.push_back(precision);
    schemes.push_back({{"name", S::name}, {"label", S::label}, {"precisions", precisions}});
  });
  return schemes;
}

template <class List, class Document>
Json documents(const List& list, const Document& document) {
  Json made = Json::array();
  for (const auto& item : list) made.push_back(document(item));
  return made;
}

}  // namespace

Json parameters_document(const HipParameters& parameters) {
  Json values = Json::object();
  for (const HipParameter& parameter : hip_parameter_list())
    values[std::string(parameter.name)] = parameters.*parameter.value;
  return values;
}

Json catalogue() {
  return {{"presets", documents(hip_preset_names(), preset_document)},
          {"parameters", documents(hip_parameter_list(), parameter_document)},
          {"motions", documents(named_motions(), motion_document)},
          {"recorded", documents(kRecordedRanges, recorded_document)},
          {"schemes", schemes_document()},
          {"rim", schema_of<LimitsRequest>()["properties"]["rim"]["description"]}};
}

}  // namespace impinge
