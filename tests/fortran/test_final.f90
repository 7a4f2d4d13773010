! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> A memory source that counts what grids hold and can refuse to give more.
module counted_memory
    use, intrinsic :: iso_c_binding, only: c_associated, c_funloc, c_int32_t, c_int64_t, &
        c_null_ptr, c_ptr, c_size_t
    use hgrid_c, only: c_hg_set_allocator, hg_allocator
    implicit none
    private

    public :: bytes_held, calls_made, refuse_memory, start_counting

    integer(c_int64_t) :: held = 0
    integer :: calls = 0
    logical :: refusing = .false.

    interface
        function c_malloc(size) bind(c, name='malloc') result(memory)
            import :: c_ptr, c_size_t
            !> Bytes
            integer(c_size_t), value :: size
            type(c_ptr) :: memory
        end function c_malloc

        function c_realloc(memory, size) bind(c, name='realloc') result(larger)
            import :: c_ptr, c_size_t
            !> Null or from malloc
            type(c_ptr), value :: memory
            !> Bytes
            integer(c_size_t), value :: size
            type(c_ptr) :: larger
        end function c_realloc

        subroutine c_free(memory) bind(c, name='free')
            import :: c_ptr
            !> Null or from malloc
            type(c_ptr), value :: memory
        end subroutine c_free
    end interface

contains

    subroutine start_counting(status)
        !> HG_OK
        integer(c_int32_t), intent(out) :: status

        status = c_hg_set_allocator(hg_allocator(c_null_ptr, c_funloc(take), c_funloc(resize), &
            c_funloc(give_back)))
    end subroutine start_counting

    subroutine refuse_memory(refuse)
        !> From now on
        logical, intent(in) :: refuse

        refusing = refuse
    end subroutine refuse_memory

    function bytes_held() result(bytes)
        integer(c_int64_t) :: bytes

        bytes = held
    end function bytes_held

    function calls_made() result(number)
        integer :: number

        number = calls
    end function calls_made

    function take(context, size) bind(c, name='') result(memory)
        !> Not used
        type(c_ptr), value :: context
        !> Bytes
        integer(c_size_t), value :: size
        type(c_ptr) :: memory

        memory = c_null_ptr
        calls = calls + 1
        if (refusing .or. c_associated(context)) return
        memory = c_malloc(size)
        if (c_associated(memory)) held = held + size
    end function take

    function resize(context, memory, old_size, new_size) bind(c, name='') result(larger)
        !> Not used
        type(c_ptr), value :: context
        !> Memory that was taken
        type(c_ptr), value :: memory
        !> Bytes
        integer(c_size_t), value :: old_size
        !> Bytes
        integer(c_size_t), value :: new_size
        type(c_ptr) :: larger

        larger = c_null_ptr
        calls = calls + 1
        if (refusing .or. c_associated(context)) return
        larger = c_realloc(memory, new_size)
        if (c_associated(larger)) held = held + new_size - old_size
    end function resize

    subroutine give_back(context, memory, size) bind(c, name='')
        !> Not used
        type(c_ptr), value :: context
        !> Memory that was taken
        type(c_ptr), value :: memory
        !> Bytes
        integer(c_size_t), value :: size

        if (.not. c_associated(memory) .or. c_associated(context)) return
        held = held - size
        call c_free(memory)
    end subroutine give_back

end module counted_memory

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
