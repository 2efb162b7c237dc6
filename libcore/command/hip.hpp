// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that ask nothing of a joint.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "command/joint_command.hpp"

namespace impinge {

/// `impinge hip`: meshes of a hip from parameters.
void add_hip_command(CLI::App& program, const Screen& screen, std::function<void()>& work);

/// `impinge check`: runs the checker of certificates, a program of its own in Python that shares no code with
/// this one.
void add_check_command(CLI::App& program, const Screen& screen, std::function<void()>& work);

}  // namespace impinge
