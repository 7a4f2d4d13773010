// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How ranks agree.
#include "dem_mpi/ranks.hpp"

namespace dem::ranks {

Ranks::Ranks(MPI_Comm comm) : comm_(comm) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

bool Ranks::all(bool mine) const {
  int told = mine ? 1 : 0, least = 0;
  MPI_Allreduce(&told, &least, 1, MPI_INT, MPI_MIN, comm_);
  return least != 0;
}

int64_t Ranks::largest(int64_t mine) const {
  int64_t most = 0;
  MPI_Allreduce(&mine, &most, 1, MPI_INT64_T, MPI_MAX, comm_);
  return most;
}

double Ranks::largest(double mine) const {
  double most = 0;
  MPI_Allreduce(&mine, &most, 1, MPI_DOUBLE, MPI_MAX, comm_);
  return most;
}

void Ranks::add_up(std::vector<int64_t> &numbers) const {
  MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_INT64_T, MPI_SUM, comm_);
}

void Ranks::agree(const std::optional<std::string> &fault) const {
  const int told = fault ? rank_ : size_;
  int lowest = size_;
  MPI_Allreduce(&told, &lowest, 1, MPI_INT, MPI_MIN, comm_);
  if (lowest == size_) return;
  std::string text = fault.value_or("");
  auto length = static_cast<int64_t>(text.size());
  MPI_Bcast(&length, 1, MPI_INT64_T, lowest, comm_);
  text.resize(static_cast<size_t>(length));
  MPI_Bcast(text.data(), static_cast<int>(length), MPI_CHAR, lowest, comm_);
  const bool all_say_so = all(fault == text);
  throw particles::Error(all_say_so ? text : "rank " + std::to_string(lowest) + ": " + text);
}

}  // namespace dem::ranks
