! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The C interface of libhgrid as Fortran sees it: types and constants, and each call hg_NAME as
!> c_hg_NAME.
!>
!> Programs use module hgrid; this one serves those who need a call as C has it, such as the
!> allocator hooks. Most calls are declared in the module that stands on them.
module hgrid_c
    use hgrid_bulk
    use hgrid_groups
    use hgrid_handle, only: c_hg_create, c_hg_destroy, c_hg_get_stats
    use hgrid_history_c
    use hgrid_particles
    use hgrid_queries
    use hgrid_sets
    use hgrid_types
    use hgrid_visit
    implicit none
    public
end module hgrid_c
