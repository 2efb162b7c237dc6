// SPDX-License-Identifier: GPL-3.0-or-later
#include "command/answer_key.hpp"

#include <span>

#include "files/formatted.hpp"
#include "joint/joint_document.hpp"
#include "report/answer_document.hpp"

namespace impinge {
namespace {

template <class Item>
std::uint64_t hash_of(std::span<const Item> items, std::uint64_t start) {
  return fnv1a({reinterpret_cast<const char*>(items.data()), items.size_bytes()}, start);
}

std::uint64_t hash_of(const JointPart& part, std::uint64_t key) {
  key = hash_of(std::span(part.mesh.vertices), key);
  key = hash_of(std::span(part.mesh.faces), key);
  for (const MeshPart& beside : part.parts)
    key = fnv1a(formatted("%zu %zu %d %s;", beside.first_vertex, beside.first_face, beside.of_main ? 1 : 0,
                          beside.name.c_str()),
                key);
  return key;
}

}  // namespace

std::uint64_t fnv1a(std::string_view bytes, std::uint64_t start) {
  for (const char byte : bytes) start = (start ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return start;
}

std::string answer_key(const SessionJoint& joint, const Json& request, std::string_view version) {
  std::uint64_t key = hash_of(joint.joint.socket, hash_of(joint.joint.ball, kFnvStart));
  key = hash_of(std::span(joint.axes.data(), 9), key);
  if (const auto& map = joint.joint.cartilage)
    key = hash_of(std::span(map->thickness), hash_of(std::span(map->directions), key));
  key = fnv1a(text_of(json_of(describe(joint, {}))) + text_of(request), key);
  key = fnv1a(version, fnv1a(commit(), key));
  return formatted("%016llx", static_cast<unsigned long long>(key));
}

}  // namespace impinge
