// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_mpi_killed: steps without end, in the middle of which the last rank is killed. What MPI then does to the
// others, which wait for it inside of a call of the library, must end them.
#include "tests/mpi/scene.hpp"

#include <csignal>

namespace {

using namespace hgtest::mpi;

int step_for_ever(const Ranks &ranks) {
  const World world(hg_default_grid_def());
  const int64_t gid = ranks.rank();
  double center[3] = {static_cast<double>(gid), 0, 0};
  const double radius = 0.6;
  need(hg_mpi_set(world.get(), 1, &gid, center, &radius));
  for (int64_t step = 0;; step++) {
    center[1] += 0.01;
    need(hg_mpi_move(world.get(), 1, center, nullptr, nullptr));
    if (step == 20 && ranks.rank() == ranks.size() - 1) (void)std::raise(SIGKILL);
  }
}

}  // namespace

int main(int argc, char **argv) { return on_ranks(argc, argv, step_for_ever); }
