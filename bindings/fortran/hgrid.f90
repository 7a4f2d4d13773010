! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> What Fortran programs use: the grid as a type with its calls.
!>
!> Each call takes an optional last argument err; without it a failure prints its message and stops
!> the program. Ids start at 1 unless the definition says otherwise. Pointers that queries return
!> show memory of the grid, without a copy: read them before the next call that changes the grid or
!> asks for the same kind of result.
module hgrid
    use, intrinsic :: iso_c_binding, only: c_double, c_float, c_int, c_int32_t, c_int64_t
    use hgrid_error, only: hg_error, hg_status_string
    use hgrid_handle, only: hg_default_grid_def
    use hgrid_history, only: hg_history
    use hgrid_queries, only: hg_grid
    use hgrid_types, only: c_hg_version, hg_grid_def, hg_grid_stats, hg_level, hg_level_cost, &
        HG_ALL_IMAGES, HG_CONTACT, HG_DOUBLE, HG_ERR_ARGUMENT, HG_ERR_CAPACITY, HG_ERR_INTERNAL, &
        HG_ERR_LIMIT, HG_ERR_MEMORY, HG_ERR_MPI, HG_ERR_NOT_FOUND, HG_ERR_NULL, HG_ERR_REMOTE, &
        HG_ERR_STATE, HG_EXACT, HG_FLOAT, HG_FULL, HG_HALF, HG_LEVELS_AUTO, HG_LEVELS_PAPER, HG_LEVELS_USER, &
        HG_MAX_BATCH, HG_MAX_GROUPS, HG_MAX_LEVELS, HG_MAX_RANGE, HG_NEAREST_IMAGE, HG_OK, &
        HG_ORDER_GRID, HG_ORDER_ID, HG_VERSION_MAJOR, HG_VERSION_MINOR, HG_VERSION_PATCH
    use hgrid_visit, only: hg_contact_visitor, hg_pair_procedure, hg_pair_visitor
    implicit none
    private

    public :: hg_contact_visitor, hg_default_grid_def, hg_error, hg_grid, hg_grid_def
    public :: hg_grid_stats, hg_history, hg_level, hg_level_cost, hg_pair_procedure
    public :: hg_pair_visitor, hg_status_string, hg_version
    public :: HG_OK, HG_ERR_NULL, HG_ERR_ARGUMENT, HG_ERR_MEMORY, HG_ERR_CAPACITY, HG_ERR_STATE
    public :: HG_ERR_NOT_FOUND, HG_ERR_LIMIT, HG_ERR_INTERNAL, HG_ERR_MPI, HG_ERR_REMOTE
    public :: HG_CONTACT, HG_MAX_RANGE, HG_EXACT, HG_DOUBLE, HG_FLOAT, HG_ORDER_GRID, HG_ORDER_ID
    public :: HG_LEVELS_AUTO, HG_LEVELS_PAPER, HG_LEVELS_USER, HG_HALF, HG_FULL, HG_MAX_LEVELS
    public :: HG_NEAREST_IMAGE, HG_ALL_IMAGES, HG_MAX_BATCH, HG_MAX_GROUPS
    public :: HG_VERSION_MAJOR, HG_VERSION_MINOR, HG_VERSION_PATCH
    ! Kinds that declarations of arguments need, so that `use hgrid` is enough.
    public :: c_double, c_float, c_int32_t, c_int64_t

contains

    !> The version of the library that is loaded.
    subroutine hg_version(major, minor, patch)
        !> Raised by an incompatible release
        integer, intent(out) :: major
        !> Raised by a release with new features
        integer, intent(out) :: minor
        !> Raised by a release that only corrects
        integer, intent(out) :: patch

        integer(c_int) :: numbers(3)

        call c_hg_version(numbers(1), numbers(2), numbers(3))
        major = numbers(1)
        minor = numbers(2)
        patch = numbers(3)
    end subroutine hg_version

end module hgrid
