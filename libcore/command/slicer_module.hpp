// SPDX-License-Identifier: GPL-3.0-or-later
// A command as a module of 3D Slicer.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace impinge {

/// The description of a command that asks a question of a joint, in the XML of Slicer's execution model: a
/// panel for each group of options, a parameter for each option that a window can set. Flags have _ for -, as
/// the schema of CTK asks.
std::string slicer_module(const CLI::App& command);

}  // namespace impinge
