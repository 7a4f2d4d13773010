// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The frame of a program with options: what is wrong with them or with its work is told on standard error.
#pragma once

#include "particles/error.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <new>

namespace bench {

// Reads the options and does `work` with them, which returns the exit code.
template <class Options>
int run_program(const char *name, const char *purpose, int argc, char **argv,
                void (*add_options)(CLI::App &, Options &), int (*work)(const Options &)) {
  try {
    CLI::App command(purpose);
    Options options;
    add_options(command, options);
    try {
      command.parse(argc, argv);
      return work(options);
    } catch (const CLI::Error &error) {
      return command.exit(error);
    }
  } catch (const std::bad_alloc &) {
    std::fprintf(stderr, "%s: not enough memory\n", name);
    return 1;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s: %s\n", name, particles::message_of(error).c_str());
    return 1;
  }
}

}  // namespace bench
