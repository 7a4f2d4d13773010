// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Processor time of a rank, and how much of it passes inside MPI: where ranks share cores, one that waits turns in
// circles, and only the rest is work.
#pragma once

namespace bench {

struct RankTime {
  double processor = 0, in_mpi = 0;  // seconds

  double work() const { return processor - in_mpi; }
};

// Since the program began. The calls of MPI that libhgrid_mpi makes are watched through MPI's profiling interface.
RankTime rank_time();

}  // namespace bench
