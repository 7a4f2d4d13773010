// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The commands of hgrid-mpi. Each adds itself, its options and what it does to the parent; failures are thrown, as
// those of hgrid are.
#pragma once

namespace CLI {
class App;
}

namespace command {

void add_rank_pairs(CLI::App &parent);
void add_plan(CLI::App &parent);
void add_rank_run(CLI::App &parent);

}  // namespace command
