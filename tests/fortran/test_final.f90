! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Who frees a grid: its end of scope, destroy, or the next create; and what a lack of memory does.
program test_final
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    use counted_memory, only: bytes_held, calls_made, refuse_memory, start_counting
    use hgrid, only: HG_ERR_MEMORY, HG_OK, hg_error, hg_grid, hg_grid_stats
    use checks, only: check, check_fails, check_works, finish_checks
    implicit none

    integer(c_int32_t) :: status

    call start_counting(status)
    call check(status == HG_OK, 'setting the allocator')
    call scope_end()
    call expect_all_freed('end of scope')
    call array_end()
    call expect_all_freed('end of scope of an array')
    call component_end()
    call expect_all_freed('deallocation of an object with a grid')
    call destroyed()
    call expect_all_freed('destroy')
    call created_again()
    call expect_all_freed('create again')
    call no_memory()
    call expect_all_freed('lack of memory')
    call finish_checks()

contains

    subroutine fill(grid)
        !> Becomes a grid that holds memory
        type(hg_grid), intent(inout) :: grid

        integer(c_int32_t), pointer :: pairs(:, :)

        call grid%create()
        call grid%insert(reshape([real(c_double) :: 0, 0, 0, 1, 0, 0], [3, 2]), &
            [real(c_double) :: 1, 1])
        call grid%query_pairs(pairs)
        call check(bytes_held() > 0, 'a grid takes its memory from the allocator')
    end subroutine fill

    subroutine expect_all_freed(what)
        !> What must have freed it
        character(len=*), intent(in) :: what

        call check(bytes_held() == 0, what//' frees everything')
    end subroutine expect_all_freed

    subroutine scope_end()
        type(hg_grid) :: grid

        call fill(grid)
    end subroutine scope_end

    subroutine array_end()
        type(hg_grid) :: grids(3)
        integer :: i

        do i = 1, size(grids)
            call fill(grids(i))
        end do
    end subroutine array_end

    subroutine component_end()
        type :: simulation
            type(hg_grid) :: grid
        end type simulation
        type(simulation), allocatable :: run

        allocate (run)
        call fill(run%grid)
        deallocate (run)
    end subroutine component_end

    subroutine destroyed()
        type(hg_grid), save :: grid

        call fill(grid)
        call grid%destroy()
    end subroutine destroyed

    subroutine created_again()
        type(hg_grid) :: grid
        integer :: i

        do i = 1, 3
            call fill(grid)
        end do
    end subroutine created_again

    !> Nothing changes, and the grid goes on once there is memory again.
    subroutine no_memory()
        type(hg_grid) :: grid, unborn
        type(hg_error) :: err
        type(hg_grid_stats) :: stats
        real(c_double), allocatable :: x(:, :), r(:)

        allocate (x(3, 10000), r(10000), source=0.0_c_double)
        call grid%create()
        call grid%insert(x(:, :2), r(:2))
        call refuse_memory(.true.)
        call unborn%create(err)
        call check_fails(err, HG_ERR_MEMORY, 'create', 'create without memory')
        call grid%insert(x, r, err)
        call check_fails(err, HG_ERR_MEMORY, 'insert', 'insert without memory')
        call refuse_memory(.false.)
        call grid%get_stats(stats)
        call check(stats%particle_count == 2, 'a failed insert changes nothing')
        call grid%insert(x, r, err)
        call check_works(err, 'insert once there is memory')
        call check(calls_made() > 0, 'the allocator is called')
    end subroutine no_memory

end program test_final
