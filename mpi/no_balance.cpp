// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Built in place of zoltan_balance.cpp where there is no Zoltan: owners are the caller's choice then.
#include "mpi/world.hpp"

namespace hgrid::mpi {

std::vector<int32_t> choose_owners(MPI_Comm, const hg_mpi_def &, const Cell &, const Particles &,
                                   const std::vector<double> &) {
  fail(HG_ERR_STATE, "hg_mpi_balance: this libhgrid_mpi was built without Zoltan; give particles to ranks yourself");
}

}  // namespace hgrid::mpi
