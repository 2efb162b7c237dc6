// SPDX-License-Identifier: GPL-3.0-or-later
// What is said where something is refused.
#pragma once

#include <string>

namespace impinge::test {

// The message of the Error that work() throws; empty where it throws nothing.
template <class Error, class Work>
std::string thrown(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace impinge::test
