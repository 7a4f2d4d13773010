// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What every test over ranks needs: MPI for as long as main runs, checks that all ranks make, the object as a variable.
#pragma once

#include <hgrid/mpi.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace hgtest::mpi {

class Ranks {
 public:
  Ranks(int *argc, char ***argv) {
    MPI_Init(argc, argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  ~Ranks() { MPI_Finalize(); }
  Ranks(const Ranks &) = delete;
  Ranks &operator=(const Ranks &) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_first() const { return rank_ == 0; }

 private:
  int rank_ = 0, size_ = 1;
};

inline int64_t sum_of(int64_t mine) {
  int64_t all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  return all;
}

// Counts what went wrong; the program ends with it.
class Checks {
 public:
  void that(bool holds, const char *what) {
    if (holds) return;
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (failed_++ < 20) std::fprintf(stderr, "rank %d: not so: %s\n", rank, what);
  }
  void status(hg_status got, hg_status expected, const char *what) {
    if (got == expected) return;
    const std::string text = std::string(what) + ": " + hg_status_string(got) + " in place of " +
                             hg_status_string(expected) + ", " + hg_last_error();
    that(false, text.c_str());
  }
  // The exit status, the same on all ranks.
  int conclude() const { return sum_of(failed_) == 0 ? 0 : 1; }

 private:
  int64_t failed_ = 0;
};

inline void need(hg_status status) {
  if (status != HG_OK) throw std::runtime_error(std::string(hg_status_string(status)) + ": " + hg_last_error());
}

// The exit status of `body`, which gets the ranks. What it throws ends all ranks.
template <class Body>
int on_ranks(int argc, char **argv, Body &&body) noexcept {
  const Ranks ranks(&argc, &argv);
  try {
    return body(ranks);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "rank %d: %s\n", ranks.rank(), error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  return 1;
}

class World {
 public:
  explicit World(const hg_grid_def &grid_def, MPI_Comm comm = MPI_COMM_WORLD, const hg_mpi_def *def = nullptr) {
    need(hg_mpi_create(comm, &grid_def, def, &mpi_));
  }
  ~World() { hg_mpi_destroy(mpi_); }
  World(const World &) = delete;
  World &operator=(const World &) = delete;
  hg_mpi *get() const { return mpi_; }

  hg_mpi_stats stats() const {
    hg_mpi_stats stats{};
    need(hg_mpi_get_stats(mpi_, &stats, sizeof stats));
    return stats;
  }
  // Of owned particles, then ghosts.
  std::vector<int64_t> all_gids() const {
    size_t owned = 0, ghosts = 0;
    const int64_t *own = nullptr, *other = nullptr;
    need(hg_mpi_owned(mpi_, &owned, &own, nullptr, nullptr));
    need(hg_mpi_ghosts(mpi_, &ghosts, &other, nullptr, nullptr, nullptr));
    std::vector<int64_t> gids(own, own + owned);
    gids.insert(gids.end(), other, other + ghosts);
    return gids;
  }

 private:
  hg_mpi *mpi_ = nullptr;
};

}  // namespace hgtest::mpi
