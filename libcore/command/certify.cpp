// SPDX-License-Identifier: GPL-3.0-or-later
#include "command/question_command.hpp"
#include "files/formatted.hpp"
#include "joint/proof.hpp"

namespace impinge {
namespace {

constexpr const char* kFile = "certificate.txt";

std::string describe_certificate(const CertifyAnswer& found, bool kept) {
  std::string text = "certificate         ";
  if (found.says == "crossing") {
    text += "contact, surfaces cross";
  } else if (found.says == "inside") {
    text += "contact, one body is inside the other";
  } else {
    text += found.closed ? "no contact" : "surfaces do not meet";
    if (found.to_deg) text += " from 0 to " + rounded_down(*found.to_deg, 4) + " degrees";
    if (!found.closed) text += ", and nothing is inside a closed mesh";
  }
  text += formatted("; rotations rounded by %.1g degrees\n", found.rounded_deg);
  return kept ? text
              : text + "                    add --out DIR to keep it, and check it with impinge check\n";
}

Told told(Session& session, const CertifyRequest& request, const Work& work) {
  const CertifyAnswer found = answer(session, request);
  Told told{.words = describe_certificate(found, work.out.has_value()), .document = json_of(found)};
  told.files = {{kFile, found.text}};
  told.row_of_one = {{"says", "/says"}, {"to_deg", "/to_deg"}};
  return told;
}

}  // namespace

QuestionCommand certify_question() {
  QuestionCommand made = question_of<CertifyRequest, CertifyAnswer>(
      "certify",
      "A proof that a pose or motion is free of contact, or that bones touch, which others can check without "
      "this program.",
      "femur.ply pelvis.ply --side right --motion flexion --out proof", &told);
  // A certificate is about the meshes as they lie in their files.
  made.without.insert(made.without.end(), {"--keep", "--overlap", "--ignore-rest-contact"});
  return made;
}

}  // namespace impinge
