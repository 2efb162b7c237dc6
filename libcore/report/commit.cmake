# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUT, the commit of SOURCE as C++, at each build; untouched where it is the same.
execute_process(COMMAND git -C "${SOURCE}" describe --always --dirty --abbrev=9 --exclude=* OUTPUT_VARIABLE commit
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT "${OUT}" CONTENT "namespace impinge {\nextern const char* const kVersion;\nconst char* commit();\nconst char* const kVersion = IMPINGE_VERSION;\nconst char* commit() { return \"${commit}\"; }\n}\n" @ONLY)
