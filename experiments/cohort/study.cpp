// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string_view>

#include "cohort/spread.hpp"
#include "files/csv.hpp"
#include "files/file_bytes.hpp"
#include "files/one_line.hpp"
#include "harness/provenance.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"

namespace impinge::lab {
namespace {

using nlohmann::json;

constexpr double kMostHips = 1e9;
constexpr double kMostFaces = 1e6;
constexpr double kLargestSeed = 9007199254740992.0;  // 2^53: JSON readers keep whole numbers up to it

std::string told(double value) { return Cell(value).text(); }

// An object of the study, and what messages call it.
struct Node {
  const json& value;
  std::string name;

  [[noreturn]] void refuse(const std::string& what) const { throw std::invalid_argument(name + what); }
  bool has(const char* key) const { return value.contains(key); }
  std::string called(const std::string& key) const { return name + (name.empty() ? "" : ".") + key; }

  void require_keys(std::initializer_list<std::string_view> known) const {
    if (!value.is_object()) refuse(" is no object {...}");
    for (const auto& [key, ignored] : value.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      std::string list;
      for (const std::string_view one : known) list += (list.empty() ? "" : ", ") + std::string(one);
      throw std::invalid_argument(called(key) + " is not known; there are " + list);
    }
  }
  double number(const char* key, double least, double most) const {
    if (!has(key)) throw std::invalid_argument(called(key) + " is missing; give a number");
    const json& found = value[key];
    const double x = found.is_number() ? found.get<double>() : NAN;
    if (x >= least && x <= most) return x;
    throw std::invalid_argument(called(key) + " is " + found.dump() + "; give a number from " + told(least) +
                                " to " + told(most));
  }
  std::size_t whole(const char* key, double least, double most) const {
    const double x = number(key, least, most);
    if (x != std::floor(x))
      throw std::invalid_argument(called(key) + " is " + told(x) + "; give a whole number");
    return static_cast<std::size_t>(x);
  }
  std::string text(const char* key) const {
    if (has(key) && value[key].is_string() && !value[key].get<std::string>().empty())
      return value[key].get<std::string>();
    throw std::invalid_argument(called(key) + " is missing; give a text");
  }
};

const HipParameter& parameter_named(const std::string& name) {
  for (const HipParameter& one : hip_parameter_list()) {
    if (one.name == name) return one;
  }
  HipParameters ignored;
  set_hip_parameter(ignored, name + "=0");  // throws, and lists the existing names
  throw std::invalid_argument(name + " is no parameter that spreads");
}

Spread spread_of(const Node& node, const HipParameter& parameter) {
  node.require_keys({"distribution", "mean", "sd", "median", "sd_of_log", "least", "most", "source"});
  constexpr double kTiny = 1e-9;
  Spread spread;
  spread.parameter = &parameter;
  try {
    spread.shape = shape_of(node.text("distribution"));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(node.called("distribution") + ": " + error.what());
  }
  const bool uniform = spread.shape == Shape::uniform;
  const bool lognormal = spread.shape == Shape::lognormal;
  const auto end = [&](const char* key, double otherwise) {
    return uniform || node.has(key) ? node.number(key, parameter.least, parameter.most) : otherwise;
  };
  spread.least = end("least", parameter.least);
  spread.most = end("most", parameter.most);
  if (lognormal) spread.least = std::max(spread.least, kTiny);
  if (!(spread.least < spread.most)) node.refuse(": least is not below most; exchange them");
  if (!uniform) {
    spread.centre = lognormal ? node.number("median", kTiny, parameter.most)
                              : node.number("mean", parameter.least - parameter.most, 2.0 * parameter.most);
    spread.width = node.number(lognormal ? "sd_of_log" : "sd", kTiny, parameter.most - parameter.least);
  }
  spread.source = node.text("source");
  return spread;
}

void read_parameters(const Node& node, Study& study) {
  if (!node.value.is_object()) node.refuse(" is no object {...}");
  for (const HipParameter& parameter : hip_parameter_list()) {
    const std::string key(parameter.name);
    if (!node.has(key.c_str())) continue;
    const Node one{node.value[key], node.called(key)};
    if (one.value.is_number())
      study.start.*parameter.value = node.number(key.c_str(), parameter.least, parameter.most);
    else
      study.spreads.push_back(spread_of(one, parameter));
  }
  for (const auto& [key, ignored] : node.value.items()) {
    try {
      parameter_named(key);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(node.name + ": " + error.what());
    }
  }
}

void read_correlations(const json& list, Study& study) {
  std::vector<Correlation> found;
  if (!list.is_array()) throw std::invalid_argument("correlations is no list [...]");
  for (const json& entry : list) {
    const Node node{entry, "correlations[" + std::to_string(found.size()) + "]"};
    node.require_keys({"between", "r", "source"});
    node.text("source");
    const json between = entry.value("between", json());
    if (!between.is_array() || between.size() != 2 || !between[0].is_string() || !between[1].is_string())
      node.refuse(".between is missing; give two names of parameters");
    found.push_back({between[0], between[1], node.number("r", -1.0, 1.0)});
  }
  study.mixing = mixing_of(study.spreads, found);
}

CohortQuestions questions_of(const Node& study) {
  CohortQuestions asked;
  const json list = study.value.value("questions", json());
  if (!list.is_array() || list.empty())
    throw std::invalid_argument("questions is missing; list some of limits, morphology, zones, volume");
  for (const json& one : list) {
    if (one == "limits")
      asked.limits = true;
    else if (one == "morphology")
      asked.morphology = true;
    else if (one == "zones")
      asked.zones = true;
    else if (one == "volume")
      asked.volume = true;
    else
      throw std::invalid_argument("questions: " + one.dump() +
                                  " is not known; there are limits, morphology, zones, volume");
  }
  if (asked.zones && !asked.limits)
    throw std::invalid_argument("questions: zones are those at the limits; ask for limits too");
  if (study.has("zone_gap_mm")) asked.zone_gap_mm = study.number("zone_gap_mm", 0.0, 50.0);
  if (study.has("volume_every")) asked.volume_every = study.whole("volume_every", 1.0, kMostHips);
  return asked;
}

void read_drawn(const Node& node, Study& study, const std::optional<std::size_t>& hips) {
  node.require_keys({"title", "hips", "seed", "faces", "start", "parameters", "correlations", "questions",
                     "zone_gap_mm", "volume_every", "check_every", "check_faces"});
  study.hips = hips ? *hips : node.whole("hips", 1.0, kMostHips);
  study.text["hips"] = study.hips;
  study.faces = node.whole("faces", kFewestHipFaces, kMostFaces);
  study.start = hip_preset(node.text("start"));
  if (!node.has("parameters")) throw std::invalid_argument("parameters is missing; name what spreads");
  read_parameters({node.value["parameters"], "parameters"}, study);
  read_correlations(node.value.value("correlations", json::array()), study);
  if (!node.has("check_every")) return;
  study.check_every = node.whole("check_every", 1.0, kMostHips);
  study.check_faces = node.whole("check_faces", kFewestHipFaces, kMostFaces);
}

Study study_of(const json& text, const std::optional<std::size_t>& hips) {
  if (text.is_discarded() || !text.is_object()) throw std::invalid_argument("it is no JSON object {...}");
  Study study;
  study.text = text;
  const Node node{text, ""};
  node.text("title");
  study.seed = node.whole("seed", 0.0, kLargestSeed);
  study.questions = questions_of(node);
  if (node.has("joints")) {
    node.require_keys({"title", "seed", "joints", "questions", "zone_gap_mm", "volume_every"});
    study.joints = node.text("joints");
    if (hips) throw std::invalid_argument("its hips are those of a folder; leave out --hips");
  } else {
    read_drawn(node, study, hips);
  }
  json lasting = study.text;  // hip j does not depend on the number of hips
  lasting.erase("hips");
  study.digest = sha256_hex(lasting.dump());
  return study;
}

}  // namespace

Study read_study(const std::filesystem::path& file, std::optional<std::size_t> hips) {
  try {
    return study_of(json::parse(read_bytes(file), nullptr, /*allow_exceptions=*/false), hips);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(one_line("study " + file.string() + ": " + error.what()));
  } catch (const json::exception& error) {  // text that is not UTF-8
    throw std::runtime_error(one_line("study " + file.string() + ": " + error.what()));
  }
}

}  // namespace impinge::lab
