// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the module `impinge`. Docstrings are short; impinge/__init__.pyi says shapes and units.
#pragma once

#include <pybind11/pybind11.h>

namespace impinge::python {

void bind_hip(pybind11::module_& module);
void bind_joint(pybind11::module_& module);
void bind_scheme(pybind11::module_& module);

}  // namespace impinge::python
