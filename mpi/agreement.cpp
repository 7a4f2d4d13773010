// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/agreement.hpp"

namespace hgrid::mpi {

void agree(MPI_Comm comm, const Outcome &mine, int64_t number, const char *name) {
  int rank = 0, size = 0;
  check_mpi(MPI_Comm_rank(comm, &rank), "MPI_Comm_rank");
  check_mpi(MPI_Comm_size(comm, &size), "MPI_Comm_size");
  // The lowest rank that failed, the smallest number, and the complement of the largest.
  const int64_t told[3] = {mine.status != HG_OK ? rank : size, number, ~number};
  int64_t least[3] = {0, 0, 0};
  check_mpi(MPI_Allreduce(told, least, 3, MPI_INT64_T, MPI_MIN, comm), "MPI_Allreduce");
  if (least[0] < size) {
    Outcome theirs = mine;
    check_mpi(MPI_Bcast(&theirs, sizeof theirs, MPI_BYTE, static_cast<int>(least[0]), comm), "MPI_Bcast");
    if (mine.status != HG_OK) fail(mine.status, "rank %d: %s", rank, mine.text);
    fail(HG_ERR_REMOTE, "rank %d: %s: %s", static_cast<int>(least[0]), hg_status_string(theirs.status), theirs.text);
  }
  if (least[1] != ~least[2]) {
    fail(HG_ERR_ARGUMENT, "rank %d: %s is not the same on all ranks", rank, name);
  }
}

}  // namespace hgrid::mpi
