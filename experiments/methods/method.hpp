// SPDX-License-Identifier: GPL-3.0-or-later
// A method: one way to do the work, ours or another library's. To add one, add a file to experiments/methods/
// whose head says what it can do and what it is linked with,
//   // @can     points touch
//   // @links   gap peer::embree
// and in which NAME.cpp defines Method NAME_method(). The build puts it into the list of each of these
// abilities; an experiment asks such a list for its cases and names no method itself. Methods whose library
// is not installed are left out.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gap/pose.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

/// Names of a method in one setting. A name begins with that of the library if there is one.
struct Case {
  std::string name = {};     // in the results; empty: the method's
  std::string label = {};    // for readers; empty: the method's
  std::string setting = {};  // such as "1deg float"
  int place = 100;  // order among the cases of all methods; ties by file, then as the method gives them
};

/// The kind of an answer, mm.
enum class Measure {
  radial,    // along the ray from the centre: a radius or a gap
  euclidean  // distance of a point from the surface, or of two surfaces
};
/// "radial" or "euclidean".
constexpr std::string_view name_of(Measure measure) {
  return measure == Measure::radial ? "radial" : "euclidean";
}

/// Do the surfaces touch in this pose? It may keep scratch memory, so only one thread may call it.
using Touch = std::function<bool(const Pose&)>;

/// Whether a pose touches: Tables 4 and 9 of the thesis.
struct TouchCase : Case {
  Touch touches;
  bool gives_distance = false;  // does the same work give the distance between the surfaces, everywhere?
};

// The other abilities, each in the header of its name.
struct BenchmarkScene;
struct PointSizes;
struct PointCase;
struct AskedSurface;
struct GapSizes;
struct GapCase;
struct ContactCase;
struct BaselineSizes;
struct BaselineCase;
struct TurnCase;

/// What a method can do; empty: it cannot. Meshes in their centre frames, mm; they must outlive the cases.
struct Method {
  std::string name = {};   // of its cases, unless they have their own
  std::string label = {};  // of its cases, for readers
  std::string lacks = {};  // what it cannot do, and why
  /// points.hpp: the distance to the surface, point by point.
  std::function<std::vector<PointCase>(const BenchmarkScene&, const PointSizes&)> points = {};
  /// gaps.hpp: the gap at every vertex of one surface in a pose.
  std::function<std::vector<GapCase>(const AskedSurface&, const GapSizes&)> gaps = {};
  /// Whether a pose touches; tables have the given precision, degrees.
  std::function<std::vector<TouchCase>(const BallSocketPair&, double)> touch = {};
  /// contact.hpp: whether the joint touches, or its smallest gap, in many poses of a motion.
  std::function<std::vector<ContactCase>(const BallSocketPair&)> contact = {};
  /// contact.hpp: whether the surfaces touch, in steps up to a first contact; of others' libraries.
  std::function<std::vector<ContactCase>(const BallSocketPair&)> steps = {};
  /// baseline.hpp: the comparison of Section 3.6, at several resolutions.
  std::function<std::vector<BaselineCase>(const BallSocketPair&, const BaselineSizes&)> baseline = {};
  /// turns.hpp: the first meeting of two features or meshes while one turns.
  std::function<std::vector<TurnCase>()> turns = {};
};

// The methods with each ability, in alphabetical order of their files. Each list is a CMake target
// impinge::ABILITY_methods.
std::vector<Method> points_methods();
std::vector<Method> gaps_methods();
std::vector<Method> touch_methods();
std::vector<Method> contact_methods();
std::vector<Method> steps_methods();
std::vector<Method> baseline_methods();
std::vector<Method> turns_methods();

/// The cases of all methods with an ability, in the order of `place`: cases_of(touch_methods(),
/// &Method::touch, pair, 0.1).
template <class OneCase, class... Of>
std::vector<OneCase> cases_of(const std::vector<Method>& methods,
                              std::function<std::vector<OneCase>(Of...)> Method::*ability,
                              std::type_identity_t<Of>... of) {
  std::vector<OneCase> all;
  for (const Method& method : methods) {
    for (OneCase& one : (method.*ability)(of...)) {
      if (one.name.empty()) one.name = method.name;
      if (one.label.empty()) one.label = method.label;
      all.push_back(std::move(one));
    }
  }
  std::ranges::stable_sort(all, {}, [](const Case& one) { return one.place; });
  return all;
}

/// Adds the labels of those cases that have one, by their names, for the sidecar of a result.
template <class Cases>
void add_labels(std::map<std::string, std::string>& labels, const Cases& cases) {
  for (const Case& one : cases) {
    if (!one.label.empty()) labels.emplace(one.name, one.label);
  }
}

}  // namespace impinge::lab
