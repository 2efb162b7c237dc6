// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "command/program.hpp"

int main(int argc, char** argv) { return impinge::run_program(argc, argv, std::cout, std::cerr); }
