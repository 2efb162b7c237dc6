// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/question_method.hpp"

#include <stdexcept>

namespace impinge::python {

Json json_of_arguments(const py::args& args, const py::kwargs& named,
                       std::span<const std::string_view> fields) {
  if (args.size() > fields.size())
    throw py::type_error("there are " + std::to_string(fields.size()) + " arguments at most, not " +
                         std::to_string(args.size()));
  py::dict given;
  for (std::size_t k = 0; k < args.size(); ++k) given[py::str(fields[k].data(), fields[k].size())] = args[k];
  for (const auto& [name, value] : named) {
    if (given.contains(name)) throw py::type_error("'" + name.cast<std::string>() + "' is given twice");
    given[name] = value;
  }
  const auto dumps = py::module_::import("json").attr("dumps");
  const auto plain = py::cpp_function([](const py::object& value) {  // an array or a path
    return py::hasattr(value, "tolist") ? value.attr("tolist")()
                                        : py::module_::import("os").attr("fspath")(value);
  });
  Json arguments = Json::object();
  for (const auto& [name, value] : given) {
    const auto key = name.cast<std::string>();
    const auto text = dumps(value, py::arg("default") = plain).cast<std::string>();
    if ((arguments[key] = Json::parse(text, nullptr, /*allow_exceptions=*/false)).is_discarded())
      throw std::invalid_argument(
          (key + ": ").append(text).append(" is not finite; give a number"));  // NaN or infinity
  }
  return arguments;
}

py::object object_of(const Json& document) {
  return py::module_::import("json").attr("loads")(text_of(document));
}

}  // namespace impinge::python
