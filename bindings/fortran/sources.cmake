# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
# The modules, each after those that it uses.
set(HGRID_FORTRAN_SOURCES
    hgrid_types.f90
    hgrid_error.f90
    hgrid_owner.f90
    hgrid_handle.f90
    hgrid_particles.f90
    hgrid_groups.f90
    hgrid_sets.f90
    hgrid_bulk.f90
    hgrid_visit.f90
    hgrid_queries.f90
    hgrid_history_c.f90
    hgrid_history.f90
    hgrid.f90
    hgrid_c.f90)
