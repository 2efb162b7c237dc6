// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/named_motion.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace impinge {
namespace {

constexpr std::array kMotions{
    NamedMotion{"flexion", {}, "flexion", "thigh forward"},
    NamedMotion{"extension", {}, "extension", "thigh back"},
    NamedMotion{"abduction", {}, "abduction", "thigh outwards"},
    NamedMotion{"adduction", {}, "adduction", "thigh inwards"},
    NamedMotion{"internal_rotation", {}, "internal_rotation", "knee inwards"},
    NamedMotion{"external_rotation", {}, "external_rotation", "knee outwards"},
    NamedMotion{"internal_rotation_at_45", {45, 0, 0}, "internal_rotation", "at 45 degrees of flexion"},
    NamedMotion{"internal_rotation_at_70", {70, 0, 0}, "internal_rotation", "at 70 degrees of flexion"},
    NamedMotion{"internal_rotation_at_90", {90, 0, 0}, "internal_rotation", "at 90 degrees of flexion"},
    NamedMotion{"external_rotation_at_90", {90, 0, 0}, "external_rotation", "at 90 degrees of flexion"},
    NamedMotion{"fadir", {90, -15, 0}, "internal_rotation", "at 90 of flexion and 15 of adduction"},
    NamedMotion{"faber", {45, 30, 0}, "external_rotation", "at 45 of flexion and 30 of abduction"}};

}  // namespace

std::span<const NamedMotion> named_motions() { return kMotions; }

const NamedMotion& named_motion(std::string_view name) {
  std::string plain(name);
  std::replace(plain.begin(), plain.end(), ' ', '_');
  std::string names;
  for (const NamedMotion& motion : kMotions) {
    if (motion.name == plain) return motion;
    names += (names.empty() ? "" : ", ") + std::string(motion.name);
  }
  throw std::invalid_argument("unknown motion '" + std::string(name) + "'; there are " + names);
}

}  // namespace impinge
