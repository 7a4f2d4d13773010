// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The commands of the program: each adds itself, its options and what it does to the parent.
//
// A command sets a callback on its own subcommand and reports failure by throwing particles::Error (exit code 1) or,
// for options that do not fit together, CLI::ValidationError (exit code 2).
#pragma once

namespace CLI {
class App;
}

namespace command {

void add_pairs(CLI::App &parent);
void add_levels(CLI::App &parent);
void add_pack(CLI::App &parent);
void add_bench(CLI::App &parent);
void add_calibrate(CLI::App &parent);
void add_slice(CLI::App &parent);
void add_run(CLI::App &parent);
void add_plot(CLI::App &parent);
void add_picture(CLI::App &parent);
void add_scenes(CLI::App &parent);
void add_accuracy(CLI::App &parent);

}  // namespace command
