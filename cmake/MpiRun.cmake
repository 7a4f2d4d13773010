# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# How tests start programs on ranks of this machine: ${hgrid_mpirun} <ranks> <program>. Needs find_package(MPI).
set(hgrid_mpirun ${MPIEXEC_EXECUTABLE})
execute_process(COMMAND ${MPIEXEC_EXECUTABLE} --version OUTPUT_VARIABLE mpirun_version ERROR_QUIET)
if(mpirun_version MATCHES "Open")
  # More ranks than cores, also in a container.
  list(APPEND hgrid_mpirun --oversubscribe --allow-run-as-root --bind-to none)
endif()
list(APPEND hgrid_mpirun ${MPIEXEC_NUMPROC_FLAG})
