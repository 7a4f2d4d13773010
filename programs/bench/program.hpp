// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The frame of a program with options: what is wrong with them or with its work is told on standard error.
#pragma once

#include "particles/error.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

namespace bench {

// Reads the options and does `work`, which returns the exit code.
template <class Work>
int run_program(CLI::App &command, const char *name, int argc, char **argv, Work &&work) {
  try {
    command.parse(argc, argv);
    return work();
  } catch (const CLI::Error &error) {
    return command.exit(error);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s: %s\n", name, particles::message_of(error).c_str());
    return 1;
  }
}

}  // namespace bench
