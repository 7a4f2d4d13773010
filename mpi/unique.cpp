// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Equal gids meet on the rank that their remainder says.
#include "mpi/world.hpp"

#include <algorithm>
#include <cinttypes>

namespace hgrid::mpi {

void check_unique(MPI_Comm comm, const std::vector<int64_t> &gids) {
  int size = 1;
  check_mpi(MPI_Comm_size(comm, &size), "MPI_Comm_size");
  std::vector<std::vector<int32_t>> rows;
  together(comm, [&] {
    rows.resize(static_cast<size_t>(size));
    for (size_t k = 0; k < gids.size(); k++) {
      rows[static_cast<uint64_t>(gids[k]) % static_cast<uint64_t>(size)].push_back(static_cast<int32_t>(k));
    }
  });
  Route route(comm);
  route.plan(gids.size(), rows);
  std::vector<int64_t> met = route.send<int64_t>([&](size_t row) { return gids[row]; });
  together(comm, [&] {
    std::sort(met.begin(), met.end());
    const auto twice = std::adjacent_find(met.begin(), met.end());
    if (twice != met.end()) fail(HG_ERR_ARGUMENT, "the gid %" PRId64 " stands twice", *twice);
  });
}

}  // namespace hgrid::mpi
