// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What keeps ranks together: a part of a collective call that may fail by itself (arguments, memory) is followed by an
// exchange of how it went, so that no rank waits for one that has given up. Between two such parts only MPI is called.
#pragma once

#include "mpi/failure.hpp"

#include <array>
#include <new>

namespace hgrid::mpi {

// How a part went on this rank.
struct Outcome {
  hg_status status = HG_OK;
  char text[256] = "";
};

// Throws on all ranks if a part failed on any. The numbers become the least of all ranks, each.
using Numbers = std::array<int64_t, 2>;
void agree(MPI_Comm comm, const Outcome &mine, Numbers *numbers = nullptr);

int rank_in(MPI_Comm comm);

template <class Body>
Outcome outcome_of(Body &&body) {
  Outcome mine;
  const auto failed = [&](hg_status status, const char *text) {
    mine.status = status;
    std::snprintf(mine.text, sizeof mine.text, "%s", text);
  };
  try {
    body();
  } catch (const Failure &failure) {
    failed(failure.status(), failure.what());
  } catch (const std::bad_alloc &) {
    failed(HG_ERR_MEMORY, "no memory");
  } catch (const std::exception &error) {
    failed(HG_ERR_INTERNAL, error.what());
  }
  return mine;
}

// Runs `body`, which calls no MPI, on all ranks; throws on all if it did on any.
template <class Body>
void together(MPI_Comm comm, Body &&body) {
  agree(comm, outcome_of(body));
}

// The same of a call in which a number must be the same on all ranks.
template <class Body>
void together_of(MPI_Comm comm, int64_t number, const char *name, Body &&body) {
  // The complement of the least complement is the largest.
  Numbers least{number, ~number};
  agree(comm, outcome_of(body), &least);
  if (least[0] != ~least[1]) fail(HG_ERR_ARGUMENT, "rank %d: %s is not the same on all ranks", rank_in(comm), name);
}

// The same; what `body` makes of the numbers become the largest of all ranks.
template <class Body>
void together_most(MPI_Comm comm, Numbers &numbers, Body &&body) {
  const Outcome mine = outcome_of(body);
  Numbers least{~numbers[0], ~numbers[1]};
  agree(comm, mine, &least);
  numbers = {~least[0], ~least[1]};
}

}  // namespace hgrid::mpi
