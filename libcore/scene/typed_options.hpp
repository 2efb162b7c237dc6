// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `scene` as they are typed, and what they mean.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/options.hpp"

namespace impinge {

/// Values of the options as text; an empty text means that the option was not given.
struct TypedOptions {
  std::string centre = "fit";
  std::string keep = "all";
  std::string overlap;
  std::string scheme;
  std::string precision;
  std::string max_error;
  std::string pose;
  std::string side;
  std::string cartilage;
  std::string question = "all-gaps";
  std::string motion;
  std::vector<std::string> required;
  std::string clearance;
  std::string cut;
  std::string rim;
  std::string neck;
  bool least = false;
  std::string tilt;
  std::string width;
  std::string gap;
  std::string centre_within;
  std::string surfaces = "both";
  std::string outputs;
};

/// Throws OptionError: "option NAME: 'VALUE' ADVICE".
[[noreturn]] void refuse_option(std::string_view option, std::string_view value, std::string_view advice);

/// Sets `options` from the texts. OptionError if a text cannot be used, alone or together with the others.
void interpret(const TypedOptions& typed, SceneOptions& options);

}  // namespace impinge
