! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Grids and histories as programs keep them: in arrays, in components, in arrays in components, in
!> types that extend them. Wherever they stand, all that they hold is freed, once.
module keepers
    use hgrid, only: hg_grid, hg_history
    implicit none
    private

    public :: counted_domain, domain, finished, named_grid, plan, world

    !> What gfortran 12 cannot finalise if the type itself has a final procedure.
    type :: domain
        integer :: number = 0
        type(hg_grid) :: grids(2)
        type(hg_history) :: histories(2)
        real, allocatable :: forces(:)
    end type domain

    type :: world
        type(domain) :: domains(2)
        type(hg_grid) :: grid
    end type world

    type, extends(hg_grid) :: named_grid
        character(len=:), allocatable :: name
    end type named_grid

    type :: plan
        class(hg_grid), allocatable :: grid
        type(named_grid) :: named(2)
        type(domain), allocatable :: domains(:)
        type(hg_history), pointer :: history => null()
    end type plan

    !> A type of the user with an end of its own.
    type :: counted_domain
        type(hg_grid) :: grid
        type(hg_history) :: history
    contains
        final :: count_end
    end type counted_domain

    integer :: finished = 0

contains

    subroutine count_end(self)
        type(counted_domain), intent(inout) :: self

        call self%history%destroy()
        finished = finished + 1
    end subroutine count_end

end module keepers

program test_components
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
    use counted_memory, only: bytes_held, start_counting
    use hgrid, only: HG_ERR_NULL, HG_OK, hg_error, hg_grid, hg_history
    use keepers, only: counted_domain, domain, finished, named_grid, plan, world
    use checks, only: check, check_fails, finish_checks
    implicit none

    integer(c_int32_t) :: status

    call start_counting(status)
    call check(status == HG_OK, 'setting the allocator')
    call local()
    call expect_all_freed('a local object')
    call empty()
    call expect_all_freed('objects of which nothing was created')
    call half_filled()
    call expect_all_freed('objects of which some were created')
    call allocated_object()
    call expect_all_freed('an allocated object')
    call allocated_array()
    call expect_all_freed('an allocated array of objects')
    call nested()
    call expect_all_freed('objects in objects')
    call block_end()
    call expect_all_freed('the end of a block')
    call polymorphic()
    call expect_all_freed('polymorphic components and pointers')
    call own_end()
    call expect_all_freed('objects with an end of their own')
    call check(finished == 1, 'the end that belongs to the user')
    call handed_out()
    call expect_all_freed('an argument with intent(out)')
    call moved()
    call expect_all_freed('move_alloc')
    call histories()
    call expect_all_freed('arrays of histories')
    call sourced()
    call expect_all_freed('a copy by allocate with source')
    call finish_checks()

contains

    subroutine expect_all_freed(what)
        !> What must have freed it
        character(len=*), intent(in) :: what

        call check(bytes_held() == 0, what//' frees everything')
    end subroutine expect_all_freed

    !> Makes a grid that works.
    subroutine fill_grid(grid)
        class(hg_grid), intent(inout) :: grid

        integer(c_int32_t), pointer :: pairs(:, :)

        call grid%create()
        call grid%insert(reshape([real(c_double) :: 0, 0, 0, 1, 0, 0], [3, 2]), &
            [real(c_double) :: 1, 1])
        call grid%query_pairs(pairs)
        call check(size(pairs, 2) == 1, 'a grid in an object finds its pair')
    end subroutine fill_grid

    !> Makes a history that works.
    subroutine fill_history(history)
        type(hg_history), intent(inout) :: history

        integer(c_int64_t), allocatable :: previous(:)

        call history%create()
        call history%update(reshape([1, 2, 2, 3], [2, 2]), previous)
        call history%update(reshape([2, 3], [2, 1]), previous)
        call check(all(previous == [2]), 'a history in an object matches its pairs')
    end subroutine fill_history

    subroutine fill(self)
        !> Whose grids and histories are all made
        type(domain), intent(inout) :: self

        integer :: i

        do i = 1, 2
            call fill_grid(self%grids(i))
            call fill_history(self%histories(i))
        end do
        self%forces = [1.0, 2.0]
    end subroutine fill

    subroutine local()
        type(domain) :: here

        call fill(here)
        call check(bytes_held() > 0, 'objects take their memory from the allocator')
    end subroutine local

    subroutine empty()
        type(domain) :: here, several(3)
        type(world) :: all_of_it

        call check(size(several) + size(all_of_it%domains) + here%number == 5, 'nothing is made')
    end subroutine empty

    subroutine half_filled()
        type(domain) :: several(3)

        call fill_grid(several(2)%grids(2))
        call fill_history(several(3)%histories(1))
    end subroutine half_filled

    subroutine allocated_object()
        type(domain), allocatable :: there

        allocate (there)
        call fill(there)
        deallocate (there)
        call expect_all_freed('deallocate')
        allocate (there)
        call fill(there)
    end subroutine allocated_object

    subroutine allocated_array()
        type(domain), allocatable :: several(:, :)
        integer :: i, k

        allocate (several(2, 3))
        do k = 1, 3
            do i = 1, 2
                call fill(several(i, k))
            end do
        end do
    end subroutine allocated_array

    subroutine nested()
        type(world) :: one, several(2)

        call fill(one%domains(1))
        call fill(one%domains(2))
        call fill_grid(one%grid)
        call fill(several(1)%domains(2))
        call fill_grid(several(2)%grid)
    end subroutine nested

    subroutine block_end()
        block
            type(domain) :: here

            call fill(here)
        end block
        call expect_all_freed('a block within a procedure')
    end subroutine block_end

    subroutine polymorphic()
        type(plan) :: whole
        class(hg_grid), allocatable :: any_grid
        type(named_grid) :: named(2)

        allocate (named_grid :: whole%grid)
        call fill_grid(whole%grid)
        call fill_grid(whole%named(2))
        allocate (whole%domains(2))
        call fill(whole%domains(1))
        allocate (whole%history)
        call fill_history(whole%history)
        deallocate (whole%history)
        allocate (named_grid :: any_grid)
        call fill_grid(any_grid)
        named(1)%name = 'first'
        call fill_grid(named(1))
        call fill_grid(named(2))
    end subroutine polymorphic

    subroutine own_end()
        type(counted_domain) :: here

        call fill_grid(here%grid)
        call fill_history(here%history)
    end subroutine own_end

    !> What a grid held before it becomes an intent(out) argument is freed on the way in.
    subroutine handed_out()
        type(hg_grid) :: grid
        type(domain) :: here
        integer :: i

        do i = 1, 2
            call make_anew(grid)
            call make_domain_anew(here)
        end do
    end subroutine handed_out

    subroutine make_anew(grid)
        type(hg_grid), intent(out) :: grid

        call fill_grid(grid)
    end subroutine make_anew

    subroutine make_domain_anew(self)
        type(domain), intent(out) :: self

        call fill(self)
    end subroutine make_domain_anew

    subroutine moved()
        type(hg_grid), allocatable :: from, to
        integer(c_int32_t), pointer :: pairs(:, :)

        allocate (from)
        call fill_grid(from)
        call move_alloc(from, to)
        call to%query_pairs(pairs)
        call check(size(pairs, 2) == 1, 'a grid that was moved')
    end subroutine moved

    subroutine histories()
        type(hg_history) :: fixed(2)
        type(hg_history), allocatable :: several(:)
        integer :: i

        allocate (several(3))
        do i = 1, 2
            call fill_history(fixed(i))
            call fill_history(several(i + 1))
        end do
    end subroutine histories

    !> A copy owns nothing: calls on it fail, and it frees nothing.
    subroutine sourced()
        type(hg_grid) :: grid
        type(hg_grid), allocatable :: copy
        type(hg_history) :: history
        type(hg_history), allocatable :: same
        type(hg_error) :: err
        integer(c_int32_t), pointer :: pairs(:, :)

        call fill_grid(grid)
        allocate (copy, source=grid)
        call copy%query_pairs(pairs, err)
        call check_fails(err, HG_ERR_NULL, 'not created', 'a copied grid')
        call copy%create()
        call copy%query_pairs(pairs)
        call check(size(pairs) == 0, 'a copy made anew')
        deallocate (copy)
        call grid%query_pairs(pairs)
        call check(size(pairs, 2) == 1, 'a grid that was copied')
        call fill_history(history)
        allocate (same, source=history)
        call same%pairs(pairs, err)
        call check_fails(err, HG_ERR_NULL, 'not created', 'a copied history')
        deallocate (same)
        call history%pairs(pairs)
        call check(size(pairs, 2) == 1, 'a history that was copied')
    end subroutine sourced

end program test_components
