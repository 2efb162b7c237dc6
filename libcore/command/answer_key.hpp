// SPDX-License-Identifier: GPL-3.0-or-later
// Hashes everything that an answer depends on; unfinished work is kept under this name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "joint/document.hpp"
#include "joint/session.hpp"

namespace impinge {

inline constexpr std::uint64_t kFnvStart = 0xcbf29ce484222325U;  // hash of no bytes
/// Hash FNV-1a of 64 bits (Fowler, Noll, Vo). `start` is the hash of the bytes before these.
std::uint64_t fnv1a(std::string_view bytes, std::uint64_t start = kFnvStart);

/// Hash (fnv1a(), 16 hexadecimal digits) of the joint with the bytes of its meshes, of the request, of the
/// program's commit, and of `version`, which names the code that answers and whatever else it reads.
std::string answer_key(const SessionJoint& joint, const Json& request, std::string_view version);

}  // namespace impinge
