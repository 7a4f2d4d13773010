! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Contact histories: data of every kind follow their contacts, through a grid that moves, a
!> checkpoint, and errors.
program test_history
    use, intrinsic :: iso_c_binding, only: c_double, c_float, c_int32_t, c_int64_t
    use hgrid, only: HG_ERR_ARGUMENT, HG_ERR_NULL, HG_ERR_STATE, hg_error, hg_grid, hg_history
    use brute_force, only: length_of, scene, scene_name
    use checks, only: check, check_fails, check_works, finish_checks
    implicit none

    integer(c_int32_t), parameter :: before(2, 3) = reshape([1, 2, 7, 9, 3, 4], [2, 3])
    integer(c_int32_t), parameter :: after(2, 4) = reshape([3, 4, 9, 7, 1, 2, -5, 6], [2, 4])
    integer(c_int32_t), parameter :: twice(2, 3) = reshape([1, 2, 3, 4, 1, 2], [2, 3])

    call test_places()
    call test_kinds()
    call test_checkpoint()
    call test_keys()
    call test_ended()
    call test_empty()
    call test_grid()
    call test_errors()
    call test_not_created()
    call finish_checks()

contains

    subroutine make(history)
        !> Has seen before, then after
        type(hg_history), intent(inout) :: history

        integer(c_int64_t), allocatable :: previous(:)

        call history%create()
        call history%update(before, previous)
        call check(all(previous == 0) .and. size(previous) == 3, 'the first list is all new')
        call history%update(after, previous)
        call check(size(previous) == 4, 'as many places as pairs')
        call check(all(previous == [integer(c_int64_t) :: 3, 0, 1, 0]), 'places count from 1')
    end subroutine make

    subroutine test_places()
        type(hg_history) :: history
        integer(c_int64_t), allocatable :: previous(:)

        call make(history)
        call make(history)
        call history%update(after(:, 4:1:-1), previous)
        call check(all(previous == [integer(c_int64_t) :: 4, 3, 2, 1]), 'a list turned round')
    end subroutine test_places

    subroutine test_kinds()
        type(hg_history) :: history
        real(c_double) :: new64(4), new64_rows(2, 4)
        real(c_float) :: new32(4), new32_rows(2, 4)
        integer(c_int32_t) :: whole(4), whole_rows(2, 4)
        integer, parameter :: rows(2, 3) = reshape([1, 2, 3, 4, 5, 6], [2, 3])
        integer, parameter :: carried(2, 4) = reshape([5, 6, 0, 0, 1, 2, 0, 0], [2, 4])

        call make(history)
        call history%carry(real(rows(1, :), c_double), new64)
        call check(all(nint(new64) == carried(1, :)), 'real64')
        call history%carry(real(rows, c_double), new64_rows)
        call check(all(nint(new64_rows) == carried), 'rows of real64')
        call history%carry(real(rows(1, :), c_float), new32)
        call check(all(nint(new32) == carried(1, :)), 'real32')
        call history%carry(real(rows, c_float), new32_rows)
        call check(all(nint(new32_rows) == carried), 'rows of real32')
        call history%carry(int(rows(1, :), c_int32_t), whole)
        call check(all(whole == carried(1, :)), 'int32')
        call history%carry(int(rows, c_int32_t), whole_rows)
        call check(all(whole_rows == carried), 'rows of int32')
    end subroutine test_kinds

    subroutine test_checkpoint()
        type(hg_history) :: history, other
        integer(c_int32_t), pointer :: pairs(:, :)
        integer(c_int64_t), allocatable :: previous(:), others(:)

        call make(history)
        call history%pairs(pairs)
        call check(all(shape(pairs) == [2, 4]), 'the remembered list has its shape')
        call check(all(pairs == after), 'the remembered list')
        call other%create()
        call other%restore(pairs)
        call history%update(before, previous)
        call other%update(before, others)
        call check(all(previous == others), 'a checkpoint goes on as the run')
        call other%clear()
        call other%update(before, others)
        call check(all(others == 0), 'all pairs are new after clear')
    end subroutine test_checkpoint

    !> Sub-keys tell contacts of one pair apart; ids may have 64 bits.
    subroutine test_keys()
        type(hg_history) :: history, other
        integer(c_int64_t), parameter :: far = 2_c_int64_t**40
        integer(c_int64_t), parameter :: first(3, 3) = reshape([integer(c_int64_t) :: &
            1, 2, 0, 1, 2, 1, far, 2, 0], [3, 3])
        integer(c_int64_t), pointer :: keys(:, :)
        integer(c_int64_t), allocatable :: previous(:), places(:)
        integer(c_int32_t) :: items(3)
        type(hg_error) :: err

        call history%create()
        call history%update(first, previous)
        call check(all(previous == 0), 'the first keys are all new')
        call history%update(first(:, [3, 1]), previous)
        call check(all(previous == [integer(c_int64_t) :: 3, 1]), 'places of keys')
        call history%carry([7_c_int32_t, 8_c_int32_t, 9_c_int32_t], items(:2))
        call check(all(items(:2) == [9, 7]), 'items of keys')
        call history%keys(keys)
        call check(all(shape(keys) == [3, 2]), 'the remembered keys have their shape')
        call check(all(keys == first(:, [3, 1])), 'the remembered keys')
        call other%create()
        call other%restore(keys)
        call history%ended(keys, places)
        call check(all(shape(keys) == [3, 1]), 'one key has ended')
        call check(all(keys(:, 1) == first(:, 2)) .and. all(places == [2]), 'its place')
        call other%update(before, previous)
        call check(all(previous == [integer(c_int64_t) :: 2, 0, 0]), 'a pair has sub-key 0')
        call other%keys(keys, err)
        call check_fails(err, HG_ERR_STATE, 'given as one of pairs, not of keys', 'keys')
        call check(.not. associated(keys), 'the keys of a failed call')
        call history%update(first(:2, :), previous, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'update: keys(2,3) has other than 3 rows', 'update')
        call history%restore(first(:2, :), err)
        call check_fails(err, HG_ERR_ARGUMENT, 'restore: keys(2,3) has other than 3 rows', 'restore')
        call history%update(first(:, [1, 2, 1]), previous, err)
        call check_fails(err, HG_ERR_ARGUMENT, &
            'keys(3) = (1, 2, 0) is already listed as keys(1)', 'update')
    end subroutine test_keys

    subroutine test_ended()
        type(hg_history) :: history
        integer(c_int32_t), pointer :: pairs(:, :)
        integer(c_int64_t), pointer :: keys(:, :)
        integer(c_int64_t), allocatable :: places(:), previous(:)
        type(hg_error) :: err

        call make(history)
        call history%ended(pairs, places)
        call check(all(shape(pairs) == [2, 1]), 'one pair has ended')
        call check(all(pairs(:, 1) == [7, 9]) .and. all(places == [2]), 'its place')
        call history%ended(keys, places, err)
        call check_fails(err, HG_ERR_STATE, 'given as one of pairs, not of keys', 'ended')
        call check(.not. associated(keys), 'ended contacts of a failed call')
        call history%update(after, previous)
        call history%ended(pairs, places)
        call check(all(shape(pairs) == [2, 0]) .and. size(places) == 0, 'nothing has ended')
        call history%ended(keys, places)
        call check(all(shape(keys) == [3, 0]) .and. size(places) == 0, 'no keys either')
        call history%clear()
        call history%ended(pairs, places, err)
        call check_fails(err, HG_ERR_STATE, 'no list has been matched', 'ended')
    end subroutine test_ended

    subroutine test_empty()
        type(hg_history) :: history
        integer(c_int32_t), pointer :: pairs(:, :)
        integer(c_int64_t), allocatable :: previous(:)
        real(c_double) :: none(2, 0), items(2, 3)

        call history%create()
        call history%pairs(pairs)
        call check(associated(pairs), 'an empty list is associated')
        call check(all(shape(pairs) == [2, 0]), 'an empty list has its shape')
        call history%update(before, previous)
        call history%carry(none, items)
        call check(all(nint(items) == 0), 'nothing to carry from')
        call history%update(pairs, previous)
        call check(size(previous) == 0, 'no places of no pairs')
        call history%carry(items, none)
    end subroutine test_empty

    !> The label of each contact, made of its ids, must still be right after every step.
    subroutine test_grid()
        type(hg_grid) :: grid
        type(hg_history) :: history
        type(scene) :: particles
        integer(c_int32_t), pointer :: pairs(:, :)
        integer(c_int64_t), allocatable :: previous(:)
        real(c_double), allocatable :: x(:, :), old(:), new(:)
        integer :: step, kept

        call particles%fill(seed=29, dimension=3, n=400, edge=2**20, r_max=2**17, grain=2**12)
        x = length_of(particles%x)
        call grid%create()
        call grid%insert(x, length_of(particles%r))
        call history%create()
        allocate (old(0))
        do step = 1, 4
            call grid%query_pairs(pairs)
            call history%update(pairs, previous)
            allocate (new(size(pairs, 2)))
            call history%carry(old, new)
            kept = count(previous > 0)
            call check(count(nint(new) /= 0) == kept, 'new contacts have zeros; '// &
                scene_name(particles))
            where (previous == 0) new = label(pairs(1, :), pairs(2, :))
            call check(all(nint(new - label(pairs(1, :), pairs(2, :))) == 0), &
                'labels follow their contacts; '//scene_name(particles))
            call move_alloc(new, old)
            x(1, ::7) = x(1, ::7) + length_of(2_c_int64_t**14)
            call grid%move(x)
        end do
        call check(kept > 50 .and. kept < size(old), 'some contacts are kept, some are new')
    end subroutine test_grid

    elemental function label(a, b) result(number)
        !> Id of one particle
        integer(c_int32_t), intent(in) :: a
        !> Id of the other
        integer(c_int32_t), intent(in) :: b
        real(c_double) :: number

        number = 1000.0_c_double*a + b
    end function label

    subroutine test_errors()
        type(hg_history) :: history
        type(hg_error) :: err
        integer(c_int64_t), allocatable :: previous(:)
        real(c_double) :: new(4), rows(2, 4)

        call make(history)
        call history%update(twice, previous, err)
        call check_fails(err, HG_ERR_ARGUMENT, &
            'update: pairs(3) = (1, 2) is already listed as pairs(1)', 'update')
        call history%restore(twice, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'pairs(3)', 'restore')
        call history%update(transpose(before), previous, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'pairs(3,2) has other than 2 rows', 'update')
        call history%carry([1.0_c_double], new, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'old(1) and new(4) do not fit lists of 3 and 4', &
            'carry')
        call history%carry(rows(:1, :3), rows, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'old(1,3) and new(2,4) differ', 'carry of rows')
        call history%carry([1, 2, 3]*1.0_c_double, new, err)
        call check_works(err, 'carry after errors')
        call check(all(nint(new) == [3, 0, 1, 0]), 'errors change nothing')
        call history%restore(after, err)
        call check_works(err, 'restore')
        call history%carry([1, 2, 3]*1.0_c_double, new, err)
        call check_fails(err, HG_ERR_STATE, 'no list has been matched', 'carry')
    end subroutine test_errors

    subroutine test_not_created()
        type(hg_history) :: history
        type(hg_error) :: err
        integer(c_int32_t), pointer :: pairs(:, :)
        integer(c_int64_t), allocatable :: previous(:)
        real(c_double) :: new(4)
        character(len=*), parameter :: text = 'the history was not created'

        call history%update(before, previous, err)
        call check_fails(err, HG_ERR_NULL, text, 'update')
        call history%carry([1, 2, 3]*1.0_c_double, new, err)
        call check_fails(err, HG_ERR_NULL, text, 'carry')
        call history%pairs(pairs, err)
        call check_fails(err, HG_ERR_NULL, text, 'pairs')
        call check(.not. associated(pairs), 'the list of a failed call')
        call history%restore(before, err)
        call check_fails(err, HG_ERR_NULL, text, 'restore')
        call history%clear(err)
        call check_fails(err, HG_ERR_NULL, text, 'clear')
        call history%ended(pairs, previous, err)
        call check_fails(err, HG_ERR_NULL, text, 'ended')
        call history%destroy()
    end subroutine test_not_created

end program test_history
