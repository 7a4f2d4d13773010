// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/agreement.hpp"

#include <algorithm>

namespace hgrid::mpi {

int rank_in(MPI_Comm comm) {
  int rank = 0;
  check_mpi(MPI_Comm_rank(comm, &rank), "MPI_Comm_rank");
  return rank;
}

void agree(MPI_Comm comm, const Outcome &mine, Numbers *numbers) {
  const int rank = rank_in(comm);
  int size = 0;
  check_mpi(MPI_Comm_size(comm, &size), "MPI_Comm_size");
  // First the lowest rank that failed.
  int64_t told[3] = {mine.status != HG_OK ? rank : size, 0, 0}, least[3] = {0, 0, 0};
  if (numbers != nullptr) std::copy(numbers->begin(), numbers->end(), told + 1);
  check_mpi(MPI_Allreduce(told, least, 3, MPI_INT64_T, MPI_MIN, comm), "MPI_Allreduce");
  if (numbers != nullptr) std::copy(least + 1, least + 3, numbers->begin());
  if (least[0] == size) return;
  Outcome theirs = mine;
  check_mpi(MPI_Bcast(&theirs, sizeof theirs, MPI_BYTE, static_cast<int>(least[0]), comm), "MPI_Bcast");
  if (mine.status != HG_OK) fail(mine.status, "rank %d: %s", rank, mine.text);
  fail(HG_ERR_REMOTE, "rank %d: %s: %s", static_cast<int>(least[0]), hg_status_string(theirs.status), theirs.text);
}

}  // namespace hgrid::mpi
