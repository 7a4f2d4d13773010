// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the program lies: what comes with it is found from there, wherever the tree was moved.
#pragma once

#include <string>

namespace command {

// `below` is written from the folder of the program, e.g. "../share/hgrid/scenes"; links are resolved. Throws
// particles::Error where the system does not tell.
std::string beside_program(const char *below);

}  // namespace command
