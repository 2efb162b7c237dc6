# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D IN=FILE -D OUT=FILE.cpp -D NAME=kName -P embed.cmake: the bytes of a file as a constant of the program.
set(bytes "")
if(EXISTS "${IN}")
  file(READ "${IN}" bytes HEX)
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
endif()
file(WRITE "${OUT}" "#include <string_view>\nnamespace impinge {\nextern const std::string_view ${NAME};\n"
                    "const std::string_view ${NAME} = \"${bytes}\";\n}  // namespace impinge\n")
