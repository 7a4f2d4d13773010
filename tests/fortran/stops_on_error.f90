! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Fails on purpose without err, in the way that its argument names; error_stop.cmake expects the
!> program to end there.
program stops_on_error
    use, intrinsic :: iso_c_binding, only: c_double
    use hgrid, only: hg_default_grid_def, hg_grid, hg_grid_def, hg_history
    implicit none

    character(len=16) :: way
    type(hg_grid) :: grid, other
    type(hg_grid) :: several(2), others(2)
    type(hg_grid_def) :: def
    type(hg_history) :: history, second
    type :: domain
        type(hg_grid) :: grids(2)
    end type domain
    type(domain) :: here, there
    type(hg_grid), allocatable :: none
    type(hg_history), allocatable :: no_history

    call get_command_argument(1, way)
    select case (way)
    case ('library')
        call grid%create()
        call grid%insert(reshape([real(c_double) :: 1, 2, 3], [3, 1]), [-0.25_c_double])
    case ('shape')
        call grid%create()
        call grid%insert(reshape([real(c_double) :: 1, 2], [2, 1]), [1.0_c_double])
    case ('not_created')
        call grid%clear()
    case ('create')
        def = hg_default_grid_def()
        def%thread_count = -3
        call grid%create(def)
    case ('copy')
        call grid%create()
        other = grid
    case ('copy_array')
        call several(2)%create()
        others = several
    case ('copy_history')
        call history%create()
        second = history
    case ('copy_domain')
        call here%grids(2)%create()
        there = here
        ! gfortran 12 copies components without their own assignment: then nothing is owned.
        call here%grids(2)%clear()
        call there%grids(2)%clear()
    case ('copy_result')
        grid = made()
    case ('copy_to_none')
        none = made()
    case ('history_to_none')
        call history%create()
        no_history = history
    case ('lost')
        call use_local(1)
        call use_local(2)
    case ('copy_empty')
        ! Nothing is owned, nothing can be freed twice: this one works.
        other = grid
        others = several
        there = here
    end select
    print '(a)', 'reached the end'

contains

    function made() result(grid)
        type(hg_grid) :: grid

        call grid%create()
    end function made

    !> Creates its grid in the first call alone.
    subroutine use_local(number)
        !> Of the call
        integer, intent(in) :: number

        type(hg_grid) :: grid

        if (number == 1) call grid%create()
        call grid%clear()
    end subroutine use_local

end program stops_on_error
