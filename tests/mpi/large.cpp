// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_mpi_large: by hand, on two ranks. Rows of a megabyte, so many that one message has more than 2^31 bytes, go to
// ghosts and back. Takes 15 GiB of memory.
#include "tests/mpi/scene.hpp"

namespace {

using namespace hgtest::mpi;

int exchange(const Ranks &ranks) {
  constexpr size_t kRows = 2100, kColumns = size_t{1} << 17;
  static_assert(kRows * kColumns * sizeof(double) > size_t{1} << 31);
  // All particles are at one place: those of rank 0, of smaller gids, are ghosts nowhere, those of rank 1 on rank 0.
  const size_t count = ranks.rank() < 2 ? kRows : 0;
  std::vector<int64_t> gids;
  for (size_t k = 0; k < count; k++)
    gids.push_back(static_cast<int64_t>(k + kRows * static_cast<size_t>(ranks.rank())));
  const std::vector<double> centers(3 * count);
  const std::vector<double> radii(count, ranks.rank() == 0 ? 1.0 : 2.0);
  const World world(hg_default_grid_def());
  need(hg_mpi_set(world.get(), count, gids.data(), centers.data(), radii.data()));
  const auto ghosts = static_cast<size_t>(world.stats().ghost_count);
  Checks checks;
  checks.that(ghosts == (ranks.rank() == 0 ? kRows : 0), "the larger ones are ghosts of the smaller ones");

  const bool sends = ranks.rank() == 1;
  std::vector<double> own(sends ? kRows * kColumns : 0), theirs(ghosts * kColumns);
  for (size_t k = 0; k < own.size(); k++) own[k] = static_cast<double>(k % 1000003);
  std::vector<double> small(1);
  double *owned = sends ? own.data() : small.data();
  need(hg_mpi_forward(world.get(), kColumns * sizeof(double), owned, theirs.data()));
  for (size_t k = 0; k < theirs.size(); k++)
    checks.that(theirs[k] == static_cast<double>(k % 1000003), "a number sent");
  need(hg_mpi_reverse_add(world.get(), kColumns, theirs.data(), owned));
  for (size_t k = 0; k < own.size(); k++) checks.that(own[k] == 2 * static_cast<double>(k % 1000003), "a number back");
  const int64_t sent = sum_of(world.stats().sent_byte_count);
  if (ranks.is_first()) std::printf("%lld bytes sent\n", static_cast<long long>(sent));
  return checks.conclude();
}

}  // namespace

int main(int argc, char **argv) { return on_ranks(argc, argv, exchange); }
