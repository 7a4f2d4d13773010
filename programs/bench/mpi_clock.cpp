// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/bench/mpi_clock.hpp"

#include <mpi.h>

#include <ctime>

namespace {

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double in_mpi = 0;

template <class Call>
int watched(Call &&call) {
  const double start = processor_seconds();
  const int code = call();
  in_mpi += processor_seconds() - start;
  return code;
}

}  // namespace

bench::RankTime bench::rank_time() { return {processor_seconds(), in_mpi}; }

extern "C" {

int MPI_Allreduce(const void *from, void *to, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  return watched([&] { return PMPI_Allreduce(from, to, count, type, op, comm); });
}

int MPI_Allgather(const void *from, int count, MPI_Datatype type, void *to, int to_count, MPI_Datatype to_type,
                  MPI_Comm comm) {
  return watched([&] { return PMPI_Allgather(from, count, type, to, to_count, to_type, comm); });
}

int MPI_Allgatherv(const void *from, int count, MPI_Datatype type, void *to, const int *counts, const int *places,
                   MPI_Datatype to_type, MPI_Comm comm) {
  return watched([&] { return PMPI_Allgatherv(from, count, type, to, counts, places, to_type, comm); });
}

int MPI_Alltoall(const void *from, int count, MPI_Datatype type, void *to, int to_count, MPI_Datatype to_type,
                 MPI_Comm comm) {
  return watched([&] { return PMPI_Alltoall(from, count, type, to, to_count, to_type, comm); });
}

int MPI_Isend(const void *from, int count, MPI_Datatype type, int rank, int tag, MPI_Comm comm, MPI_Request *request) {
  return watched([&] { return PMPI_Isend(from, count, type, rank, tag, comm, request); });
}

int MPI_Irecv(void *to, int count, MPI_Datatype type, int rank, int tag, MPI_Comm comm, MPI_Request *request) {
  return watched([&] { return PMPI_Irecv(to, count, type, rank, tag, comm, request); });
}

int MPI_Waitall(int count, MPI_Request requests[], MPI_Status statuses[]) {
  return watched([&] { return PMPI_Waitall(count, requests, statuses); });
}
}
