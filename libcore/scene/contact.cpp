// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/contact.hpp"

#include "scene/asked.hpp"

namespace impinge {

std::string describe_contact(const Joint& joint, const BodyPairs::Verdict& found) {
  const std::string line = "contact             ";
  if (found.contact == Contact::no) return line + "none\n";
  const std::string ball = body_name(joint.ball.parts, found.pair.ball);
  const std::string socket = body_name(joint.socket.parts, found.pair.socket);
  const std::string both = (ball.empty() ? "ball" : ball) + " and " + (socket.empty() ? "socket" : socket);
  if (found.contact == Contact::unknown) {
    return line + "not known: the surfaces of " + both +
           " do not meet, and whether one is inside the other hangs on an opening of a mesh; close it, or "
           "give "
           "the whole bone\n";
  }
  switch (found.rule) {
    case ContactRule::surfaces:
      return line + "yes: the surfaces of " + both + " meet\n";
    case ContactRule::inside:
      return line + "yes: of " + both + " one is inside the other\n";
    case ContactRule::radii:
      break;
  }
  return line +
         "yes, by radii: no surfaces meet, but the ball reaches beyond the socket, which is a sheet without "
         "an "
         "inside; the whole bone would decide\n";
}

nlohmann::json contact_json(const Joint& joint, const BodyPairs::Verdict& found) {
  constexpr const char* kRules[] = {"surfaces", "inside", "radii"};
  nlohmann::json contact{{"state", word_of(found.contact)}, {"by", nullptr}};
  if (found.contact == Contact::yes) contact["by"] = kRules[static_cast<std::size_t>(found.rule)];
  if (found.contact != Contact::no) {
    add_part_names(joint, body_name(joint.ball.parts, found.pair.ball),
                   body_name(joint.socket.parts, found.pair.socket), contact);
  }
  return contact;
}

}  // namespace impinge
