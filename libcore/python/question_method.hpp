// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a method of a question about a joint. Arguments fill a request (files/fields.hpp), in the order of
// its fields or by name; the answer is its document as a dict.
#pragma once

#include <string>
#include <string_view>

#include "joint/document.hpp"
#include "python/arrays.hpp"
#include "python/joint_class.hpp"

namespace impinge::python {

/// Arguments as JSON; arrays of NumPy become lists.
Json json_of_arguments(const py::args& args, const py::kwargs& named,
                       std::span<const std::string_view> fields);
/// JSON as dicts, lists, numbers and texts.
py::object object_of(const Json& document);

/// `text`, then a line for each field of the request and of the answer.
template <Described Request, Described Answer>
std::string docstring_of(std::string_view text) {
  std::string lines(text);
  const auto add = [&lines](const auto& field) {
    lines += "\n  " + std::string(field.name) +
             (field.unit.empty() || field.unit == "1" ? "" : " (" + std::string(field.unit) + ")") + ": " +
             std::string(field.text);
  };
  constexpr bool kAsked = !std::same_as<std::remove_cvref_t<decltype(fields_of<Request>)>, std::tuple<>>;
  if constexpr (kAsked) {
    lines += "\n\nArguments";
    for_each_field<Request>(add);
  }
  lines += "\n\nReturns a dict with";
  for_each_field<Answer>(add);
  return lines;
}

template <class Request>
auto ask_once(PoseJoint& joint, const Request& request) {
  return joint.ask(request);
}

/// The request that the arguments make.
template <Described Request>
Request request_of(const py::args& args, const py::kwargs& named) {
  std::vector<std::string_view> fields;
  for_each_field<Request>([&](const auto& field) { fields.push_back(field.name); });
  Request request;
  read_request(json_of_arguments(args, named, fields), request);
  if constexpr (requires { request.check(); }) request.check();
  return request;
}

/// `(self, KEYWORD=DEFAULT, ...)` for the beginning of a docstring, where inspect.signature() reads it;
/// `self` may be "self, out".
template <Described Request>
std::string signature_of(const char* name, const char* self = "self") {
  std::string line = std::string(name) + "(" + self;
  for_each_field<Request>([&line, request = Request()](const auto& field) {
    line += ", " + std::string(field.name) + "=" +
            py::repr(object_of(json_of(field.of(request)))).template cast<std::string>();
  });
  return line + ")\n--\n\n";
}

/// Adds the method to the class, and its name to `_questions`. `more(joint, answer, dict)` adds what is not
/// JSON, such as arrays. `ask` runs without Python's lock and may look for interrupts.
template <Described Request, Described Answer>
void bind_question(JointClass& joint, const char* name, std::string_view text,
                   void (*more)(PoseJoint&, const Answer&, py::dict&) = nullptr,
                   Answer (*ask)(PoseJoint&, const Request&) = &ask_once<Request>) {
  if (!py::hasattr(joint, "_questions")) joint.attr("_questions") = py::dict();
  joint.attr("_questions")[name[0] == '_' ? name + 1 : name] = name;
  joint.def(
      name,
      [more, ask](PoseJoint& self, const py::args& args, const py::kwargs& named) {
        const auto request = request_of<Request>(args, named);
        std::optional<Answer> found;
        without_lock(1, [&](std::size_t) { found.emplace(ask(self, request)); });
        py::dict answer = object_of(json_of(*found));
        if (more != nullptr) more(self, *found, answer);
        return answer;
      },
      (signature_of<Request>(name) + docstring_of<Request, Answer>(text)).c_str());
}

}  // namespace impinge::python
