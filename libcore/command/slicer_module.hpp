// SPDX-License-Identifier: GPL-3.0-or-later
// Describes a command as a module of 3D Slicer.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace impinge {

/// The description of a question's command in the XML of Slicer's execution model: a panel for each group of
/// options and a parameter for each option that a window can set. CTK's schema wants _ for - in flags.
std::string slicer_module(const CLI::App& command);

}  // namespace impinge
