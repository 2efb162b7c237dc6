// SPDX-License-Identifier: GPL-3.0-or-later
// Which program this is.
#pragma once

namespace impinge {

extern const char* const kVersion;  // of the project
/// Of the sources that it was built from, as git abbreviates it, with "-dirty" where files had changed;
/// "unknown" outside of git.
const char* commit();

}  // namespace impinge
