! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Visitors that the visit test passes to a grid.
module test_visitors
    use, intrinsic :: iso_c_binding, only: c_int32_t
    use hgrid, only: hg_error, hg_grid, hg_pair_visitor
    implicit none
    private

    public :: collector, count_partners, degree, meddler

    !> How many partners count_partners has seen of each particle
    integer(c_int32_t) :: degree(400) = 0

    !> Keeps the pairs of each batch, and ends the visit after a number of batches.
    type, extends(hg_pair_visitor) :: collector
        integer :: batches = 0
        integer :: last_batch = huge(0)
        integer(c_int32_t) :: pairs(2, 100000) = 0
        integer :: count = 0
    contains
        procedure :: visit => collect
    end type collector

    !> Calls back into the grid that it visits, and keeps what each call answers.
    type, extends(hg_pair_visitor) :: meddler
        type(hg_grid), pointer :: grid => null()
        type(hg_error) :: clearing, creating, destroying, querying, visiting
    contains
        procedure :: visit => meddle
    end type meddler

contains

    function collect(self, pairs) result(answer)
        !> The visitor
        class(collector), intent(inout) :: self
        !> (2, n)
        integer(c_int32_t), intent(in) :: pairs(:, :)
        integer(c_int32_t) :: answer

        self%batches = self%batches + 1
        self%pairs(:, self%count + 1:self%count + size(pairs, 2)) = pairs
        self%count = self%count + size(pairs, 2)
        answer = merge(1, 0, self%batches == self%last_batch)
    end function collect

    function meddle(self, pairs) result(answer)
        !> The visitor
        class(meddler), intent(inout) :: self
        !> (2, n)
        integer(c_int32_t), intent(in) :: pairs(:, :)
        integer(c_int32_t) :: answer

        integer(c_int32_t), pointer :: again(:, :)

        call self%grid%clear(self%clearing)
        call self%grid%create(self%creating)
        call self%grid%destroy(self%destroying)
        call self%grid%query_pairs(again, self%querying)
        call self%grid%visit_pairs(self, self%visiting)
        answer = size(pairs, 2)
    end function meddle

    function count_partners(pairs) result(answer)
        !> (2, n)
        integer(c_int32_t), intent(in) :: pairs(:, :)
        integer(c_int32_t) :: answer

        integer :: k

        do k = 1, size(pairs, 2)
            degree(pairs(:, k)) = degree(pairs(:, k)) + 1
        end do
        answer = 0
    end function count_partners

end module test_visitors

!> Visiting pairs in batches: with an object, with a function, ended early, and with forbidden
!> calls.
program test_visit
    use, intrinsic :: iso_c_binding, only: c_int32_t
    use hgrid, only: HG_ERR_STATE, HG_ORDER_ID, hg_default_grid_def, hg_error, hg_grid, &
        hg_grid_def
    use brute_force, only: contact_matrix, difference, length_of, rule, scene, scene_name
    use checks, only: check, check_fails, check_works, finish_checks
    use test_visitors, only: collector, count_partners, degree, meddler
    implicit none

    type(scene) :: particles
    logical, allocatable, save :: matrix(:, :)

    call particles%fill(seed=11, dimension=3, n=400, edge=2**20, r_max=2**20, grain=1)
    matrix = contact_matrix(particles, rule())
    call test_object()
    call test_function()
    call test_early_end()
    call test_order()
    call test_forbidden_calls()
    call finish_checks()

contains

    subroutine make_grid(grid)
        !> Becomes a grid with the particles
        type(hg_grid), intent(inout) :: grid

        call grid%create()
        call grid%insert(length_of(particles%x), length_of(particles%r))
    end subroutine make_grid

    subroutine test_object()
        type(hg_grid) :: grid
        type(collector), allocatable :: visitor
        type(hg_error) :: err
        character(len=:), allocatable :: text

        allocate (visitor)
        call make_grid(grid)
        call grid%visit_pairs(visitor, err)
        call check_works(err, 'visit_pairs')
        text = difference(visitor%pairs(:, :visitor%count), matrix)
        call check(text == '', 'visited: '//text//'; '//scene_name(particles))
        call grid%clear()
        visitor%batches = 0
        call grid%visit_pairs(visitor)
        call check(visitor%batches == 0, 'no batch without particles')
    end subroutine test_object

    !> A function reaches its data by use association.
    subroutine test_function()
        type(hg_grid) :: grid

        call make_grid(grid)
        degree = 0
        call grid%visit_pairs(count_partners)
        call check(all(degree == count(matrix, 1) + count(matrix, 2)), 'partners of each particle')
    end subroutine test_function

    !> The grid must work as before once a visit was ended.
    subroutine test_early_end()
        type(hg_grid) :: grid
        type(collector), allocatable :: visitor
        type(hg_error) :: err
        integer(c_int32_t), pointer :: pairs(:, :)
        integer :: all_batches

        allocate (visitor)
        call make_grid(grid)
        call grid%visit_pairs(visitor)
        all_batches = visitor%batches
        call check(all_batches > 1, 'the scene has more than one batch')
        visitor%batches = 0
        visitor%count = 0
        visitor%last_batch = 1
        call grid%visit_pairs(visitor, err)
        call check_works(err, 'a visit that was ended')
        call check(visitor%batches == 1, 'no batch after the one that ended the visit')
        call check(visitor%count > 0 .and. visitor%count < count(matrix), 'only some pairs')
        call grid%query_pairs(pairs)
        call check(difference(pairs, matrix) == '', 'all pairs after a visit that was ended')
    end subroutine test_early_end

    subroutine test_order()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(collector), allocatable :: visitor
        integer(c_int32_t), pointer :: pairs(:, :)

        allocate (visitor)
        def = hg_default_grid_def()
        def%pair_order = HG_ORDER_ID
        call grid%create(def)
        call grid%insert(length_of(particles%x), length_of(particles%r))
        call grid%visit_pairs(visitor)
        call grid%query_pairs(pairs)
        call check(visitor%count == size(pairs, 2), 'as many pairs visited as queried')
        if (visitor%count /= size(pairs, 2)) return
        call check(all(visitor%pairs(:, :visitor%count) == pairs), 'visited in the order of ids')
    end subroutine test_order

    subroutine test_forbidden_calls()
        type(hg_grid), target :: grid
        type(meddler) :: visitor
        type(hg_error) :: err
        integer(c_int32_t), pointer :: pairs(:, :)

        call make_grid(grid)
        visitor%grid => grid
        call grid%visit_pairs(visitor, err)
        call check_works(err, 'visit_pairs')
        call check_fails(visitor%clearing, HG_ERR_STATE, 'clear', 'clear while visiting')
        call check_fails(visitor%creating, HG_ERR_STATE, 'create', 'create while visiting')
        call check_fails(visitor%destroying, HG_ERR_STATE, 'destroy', 'destroy while visiting')
        call check_fails(visitor%querying, HG_ERR_STATE, 'query_pairs', 'query while visiting')
        call check_fails(visitor%visiting, HG_ERR_STATE, 'visit_pairs', 'visit while visiting')
        call grid%query_pairs(pairs)
        call check(difference(pairs, matrix) == '', 'all pairs after forbidden calls')
    end subroutine test_forbidden_calls

end program test_visit
