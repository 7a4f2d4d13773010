! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Contact history: data of contacts that follow them from one list of pairs to the next.
module hgrid_history
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_float, &
        c_int32_t, c_int64_t, c_loc, c_ptr, c_size_t, c_sizeof
    use hgrid_history_c, only: c_hg_history_carry, c_hg_history_clear, c_hg_history_create, &
        c_hg_history_destroy, c_hg_history_ended, c_hg_history_ended_keys, c_hg_history_keys, &
        c_hg_history_pairs, c_hg_history_restore, c_hg_history_restore_keys, c_hg_history_update, &
        c_hg_history_update_keys
    use hgrid_error, only: hg_error, number_text, raise, refuse_copies, settle, settle_on, &
        shape_text
    use hgrid_owner, only: disown, hg_owner, own, owned
    use hgrid_types, only: HG_ERR_ARGUMENT, HG_OK
    implicit none
    private

    public :: hg_history

    !> The list of pairs of the last step, and how a new one follows from it. It frees itself when
    !> it goes out of scope.
    type :: hg_history
        private
        ! First, so that its place is that of the whole.
        integer(c_size_t) :: former_count = 0
        integer(c_size_t) :: count = 0
        type(hg_owner), allocatable :: owner
    contains
        private
        procedure :: carry_real64, carry_real64_rows, carry_real32, carry_real32_rows
        procedure :: carry_int32, carry_int32_rows
        procedure, pass(self) :: refuse_copy
        procedure :: update_pairs, update_keys, restore_pairs, restore_keys
        procedure :: ended_pairs, ended_keys
        procedure, public :: create
        procedure, public :: destroy
        !> update(pairs, previous): int32 pairs (2, count), or int64 keys (3, count): a, b, sub-key
        generic, public :: update => update_pairs, update_keys
        !> carry(old, new): data of the list before in the order of the last one, zero where a
        !> contact is new; real64, real32 or int32, (count) or (rows, count)
        generic, public :: carry => carry_real64, carry_real64_rows, carry_real32, &
            carry_real32_rows, carry_int32, carry_int32_rows
        !> ended(pairs, places): what the last update no longer found, pairs or keys as they were
        generic, public :: ended => ended_pairs, ended_keys
        procedure, public :: pairs => remembered_pairs
        procedure, public :: keys => remembered_keys
        !> restore(pairs): pairs or keys, as update takes them
        generic, public :: restore => restore_pairs, restore_keys
        procedure, public :: clear
        generic, public :: assignment(=) => refuse_copy
    end type hg_history

    ! What pointers show when the list is empty: a Fortran result must be associated.
    integer(c_int32_t), target :: no_pairs(2, 0)
    integer(c_int64_t), target :: no_keys(3, 0)

contains

    !> A history that remembers an empty list; a former one is destroyed.
    subroutine create(self, err)
        class(hg_history), intent(inout) :: self
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: created
        integer(c_int32_t) :: status

        status = c_hg_history_create(created)
        if (status == HG_OK) then
            call self%destroy()
            call own(self%owner, created, c_hg_history_destroy)
        end if
        call settle(status, 'create', err)
    end subroutine create

    !> Frees the history; one that was never created is fine.
    subroutine destroy(self)
        class(hg_history), intent(inout) :: self

        call disown(self%owner)
        self%former_count = 0
        self%count = 0
    end subroutine destroy

    !> Matches a list of pairs to the one before, and remembers it instead.
    subroutine update_pairs(self, pairs, previous, err)
        class(hg_history), intent(inout) :: self
        !> (2, count), in any order, none twice
        integer(c_int32_t), intent(in), contiguous, target :: pairs(:, :)
        !> (count): place of each pair in the former list, from 1; 0 if it was not there
        integer(c_int64_t), intent(inout), allocatable :: previous(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        integer(c_int32_t) :: status

        if (misfit(self, 'update: pairs', shape(pairs), 2, err)) return
        status = c_hg_history_update(owned(self%owner), size(pairs, 2, c_size_t), &
            c_loc(pairs), memory)
        if (status == HG_OK) call matched(self, size(pairs, 2, c_size_t), memory, previous)
        call conclude(self, status, 'update', err)
    end subroutine update_pairs

    !> The same for a list of keys.
    subroutine update_keys(self, keys, previous, err)
        class(hg_history), intent(inout) :: self
        !> (3, count): two ids and a sub-key for each contact, in any order, none twice
        integer(c_int64_t), intent(in), contiguous, target :: keys(:, :)
        !> (count): as for pairs
        integer(c_int64_t), intent(inout), allocatable :: previous(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        integer(c_int32_t) :: status

        if (misfit(self, 'update: keys', shape(keys), 3, err)) return
        status = c_hg_history_update_keys(owned(self%owner), size(keys, 2, c_size_t), &
            c_loc(keys), memory)
        if (status == HG_OK) call matched(self, size(keys, 2, c_size_t), memory, previous)
        call conclude(self, status, 'update', err)
    end subroutine update_keys

    !> Takes over what a match has found.
    subroutine matched(self, count, memory, previous)
        class(hg_history), intent(inout) :: self
        !> Contacts of the new list
        integer(c_size_t), intent(in) :: count
        !> Their places, from 0
        type(c_ptr), intent(in) :: memory
        !> (count): their places, from 1
        integer(c_int64_t), intent(inout), allocatable :: previous(:)

        call copy_places(memory, count, previous)
        self%former_count = self%count
        self%count = count
    end subroutine matched

    !> The contacts of the list before that the last update no longer found.
    subroutine ended_pairs(self, pairs, places, err)
        class(hg_history), intent(in) :: self
        !> (2, count); memory of the history, to be read before it changes
        integer(c_int32_t), pointer, intent(out) :: pairs(:, :)
        !> (count): their places in the list before, from 1, ascending
        integer(c_int64_t), intent(inout), allocatable :: places(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory, place_memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (pairs)
        status = c_hg_history_ended(owned(self%owner), memory, place_memory, count)
        if (status == HG_OK) then
            call show_pairs(memory, count, pairs)
            call copy_places(place_memory, count, places)
        end if
        call conclude(self, status, 'ended', err)
    end subroutine ended_pairs

    !> The same if the list before was one of keys.
    subroutine ended_keys(self, keys, places, err)
        class(hg_history), intent(in) :: self
        !> (3, count); memory of the history, to be read before it changes
        integer(c_int64_t), pointer, intent(out) :: keys(:, :)
        !> (count): as for pairs
        integer(c_int64_t), intent(inout), allocatable :: places(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory, place_memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (keys)
        status = c_hg_history_ended_keys(owned(self%owner), memory, place_memory, count)
        if (status == HG_OK) then
            call show_keys(memory, count, keys)
            call copy_places(place_memory, count, places)
        end if
        call conclude(self, status, 'ended', err)
    end subroutine ended_keys

    !> Places of C, as those of Fortran arrays.
    subroutine copy_places(memory, count, places)
        !> int64_t[count], from 0
        type(c_ptr), intent(in) :: memory
        integer(c_size_t), intent(in) :: count
        !> (count), from 1
        integer(c_int64_t), intent(inout), allocatable :: places(:)

        integer(c_int64_t), pointer :: from_zero(:)

        if (allocated(places)) then
            if (size(places, kind=c_size_t) /= count) deallocate (places)
        end if
        if (.not. allocated(places)) allocate (places(count))
        if (count == 0) return
        call c_f_pointer(memory, from_zero, [count])
        places = from_zero + 1
    end subroutine copy_places

    !> A list of pairs that the C history lends.
    subroutine show_pairs(memory, count, pairs)
        !> hg_pair[count]
        type(c_ptr), intent(in) :: memory
        integer(c_size_t), intent(in) :: count
        !> (2, count)
        integer(c_int32_t), pointer, intent(out) :: pairs(:, :)

        pairs => no_pairs
        if (count > 0) call c_f_pointer(memory, pairs, [2_c_size_t, count])
    end subroutine show_pairs

    !> A list of keys that the C history lends.
    subroutine show_keys(memory, count, keys)
        !> hg_contact_key[count]
        type(c_ptr), intent(in) :: memory
        integer(c_size_t), intent(in) :: count
        !> (3, count)
        integer(c_int64_t), pointer, intent(out) :: keys(:, :)

        keys => no_keys
        if (count > 0) call c_f_pointer(memory, keys, [3_c_size_t, count])
    end subroutine show_keys

    !> The remembered list, for example for a checkpoint.
    subroutine remembered_pairs(self, pairs, err)
        class(hg_history), intent(in) :: self
        !> (2, count); memory of the history, to be read before it changes
        integer(c_int32_t), pointer, intent(out) :: pairs(:, :)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (pairs)
        status = c_hg_history_pairs(owned(self%owner), memory, count)
        if (status == HG_OK) call show_pairs(memory, count, pairs)
        call conclude(self, status, 'pairs', err)
    end subroutine remembered_pairs

    !> The remembered list if it is one of keys.
    subroutine remembered_keys(self, keys, err)
        class(hg_history), intent(in) :: self
        !> (3, count); memory of the history, to be read before it changes
        integer(c_int64_t), pointer, intent(out) :: keys(:, :)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (keys)
        status = c_hg_history_keys(owned(self%owner), memory, count)
        if (status == HG_OK) call show_keys(memory, count, keys)
        call conclude(self, status, 'keys', err)
    end subroutine remembered_keys

    !> Remembers a list without matching it, for example that of a checkpoint.
    subroutine restore_pairs(self, pairs, err)
        class(hg_history), intent(inout) :: self
        !> (2, count), in any order, none twice
        integer(c_int32_t), intent(in), contiguous, target :: pairs(:, :)
        type(hg_error), intent(out), optional :: err

        integer(c_int32_t) :: status

        if (misfit(self, 'restore: pairs', shape(pairs), 2, err)) return
        status = c_hg_history_restore(owned(self%owner), size(pairs, 2, c_size_t), c_loc(pairs))
        if (status == HG_OK) self%count = size(pairs, 2, c_size_t)
        call conclude(self, status, 'restore', err)
    end subroutine restore_pairs

    !> The same for a list of keys.
    subroutine restore_keys(self, keys, err)
        class(hg_history), intent(inout) :: self
        !> (3, count), in any order, none twice
        integer(c_int64_t), intent(in), contiguous, target :: keys(:, :)
        type(hg_error), intent(out), optional :: err

        integer(c_int32_t) :: status

        if (misfit(self, 'restore: keys', shape(keys), 3, err)) return
        status = c_hg_history_restore_keys(owned(self%owner), size(keys, 2, c_size_t), c_loc(keys))
        if (status == HG_OK) self%count = size(keys, 2, c_size_t)
        call conclude(self, status, 'restore', err)
    end subroutine restore_keys

    !> Remembers an empty list.
    subroutine clear(self, err)
        class(hg_history), intent(inout) :: self
        type(hg_error), intent(out), optional :: err

        integer(c_int32_t) :: status

        status = c_hg_history_clear(owned(self%owner))
        if (status == HG_OK) self%count = 0
        call conclude(self, status, 'clear', err)
    end subroutine clear

    subroutine carry_real64(self, old, new, err)
        class(hg_history), intent(in) :: self
        real(c_double), intent(in), contiguous, target :: old(:)
        real(c_double), intent(out), contiguous, target :: new(:)
        type(hg_error), intent(out), optional :: err

        call carry_memory(self, c_sizeof(0.0_c_double), c_loc(old), shape(old, c_size_t), &
            c_loc(new), shape(new, c_size_t), err)
    end subroutine carry_real64

    subroutine carry_real64_rows(self, old, new, err)
        class(hg_history), intent(in) :: self
        real(c_double), intent(in), contiguous, target :: old(:, :)
        real(c_double), intent(out), contiguous, target :: new(:, :)
        type(hg_error), intent(out), optional :: err

        call carry_memory(self, c_sizeof(0.0_c_double), c_loc(old), shape(old, c_size_t), &
            c_loc(new), shape(new, c_size_t), err)
    end subroutine carry_real64_rows

    subroutine carry_real32(self, old, new, err)
        class(hg_history), intent(in) :: self
        real(c_float), intent(in), contiguous, target :: old(:)
        real(c_float), intent(out), contiguous, target :: new(:)
        type(hg_error), intent(out), optional :: err

        call carry_memory(self, c_sizeof(0.0_c_float), c_loc(old), shape(old, c_size_t), &
            c_loc(new), shape(new, c_size_t), err)
    end subroutine carry_real32

    subroutine carry_real32_rows(self, old, new, err)
        class(hg_history), intent(in) :: self
        real(c_float), intent(in), contiguous, target :: old(:, :)
        real(c_float), intent(out), contiguous, target :: new(:, :)
        type(hg_error), intent(out), optional :: err

        call carry_memory(self, c_sizeof(0.0_c_float), c_loc(old), shape(old, c_size_t), &
            c_loc(new), shape(new, c_size_t), err)
    end subroutine carry_real32_rows

    subroutine carry_int32(self, old, new, err)
        class(hg_history), intent(in) :: self
        integer(c_int32_t), intent(in), contiguous, target :: old(:)
        integer(c_int32_t), intent(out), contiguous, target :: new(:)
        type(hg_error), intent(out), optional :: err

        call carry_memory(self, c_sizeof(0_c_int32_t), c_loc(old), shape(old, c_size_t), &
            c_loc(new), shape(new, c_size_t), err)
    end subroutine carry_int32

    subroutine carry_int32_rows(self, old, new, err)
        class(hg_history), intent(in) :: self
        integer(c_int32_t), intent(in), contiguous, target :: old(:, :)
        integer(c_int32_t), intent(out), contiguous, target :: new(:, :)
        type(hg_error), intent(out), optional :: err

        call carry_memory(self, c_sizeof(0_c_int32_t), c_loc(old), shape(old, c_size_t), &
            c_loc(new), shape(new, c_size_t), err)
    end subroutine carry_int32_rows

    !> What all kinds of carry have in common.
    subroutine carry_memory(self, number_size, old, old_shape, new, new_shape, err)
        class(hg_history), intent(in) :: self
        !> Bytes of one number
        integer(c_size_t), intent(in) :: number_size
        !> Address of the old numbers
        type(c_ptr), intent(in) :: old
        !> (count) or (rows, count)
        integer(c_size_t), intent(in) :: old_shape(:)
        !> Address of the new numbers
        type(c_ptr), intent(in) :: new
        !> As old_shape
        integer(c_size_t), intent(in) :: new_shape(:)
        type(hg_error), intent(out), optional :: err

        character(len=:), allocatable :: shapes
        integer(c_size_t) :: item_size
        integer :: rank

        rank = size(old_shape)
        item_size = number_size
        if (rank == 2) item_size = number_size*old_shape(1)
        if (c_associated(owned(self%owner))) then
            shapes = 'carry: old'//shape_text(int(old_shape))//' and new'// &
                shape_text(int(new_shape))
            if (any(old_shape(:rank - 1) /= new_shape(:rank - 1))) then
                call raise(HG_ERR_ARGUMENT, shapes//' differ in the number of rows', err)
                return
            end if
            if (old_shape(rank) /= self%former_count .or. new_shape(rank) /= self%count) then
                call raise(HG_ERR_ARGUMENT, shapes//' do not fit lists of '// &
                    number_text(int(self%former_count))//' and '//number_text(int(self%count))// &
                    ' contacts', err)
                return
            end if
        end if
        call conclude(self, c_hg_history_carry(owned(self%owner), item_size, old, new), 'carry', &
            err)
    end subroutine carry_memory

    !> Only objects that were never created may be assigned. A left side that is allocatable and not
    !> allocated stands nowhere, and must not be looked into.
    impure elemental subroutine refuse_copy(left, self)
        class(hg_history), intent(inout), target :: left
        class(hg_history), intent(in) :: self

        if (c_associated(c_loc(left%former_count))) then
            if (.not. (c_associated(owned(left%owner)) .or. c_associated(owned(self%owner)))) return
        end if
        call refuse_copies('history')
    end subroutine refuse_copy

    !> Ends a call on the C history.
    subroutine conclude(self, status, caller, err)
        class(hg_history), intent(in) :: self
        !> What the C call returned
        integer(c_int32_t), intent(in) :: status
        !> Name of the Fortran call
        character(len=*), intent(in) :: caller
        type(hg_error), intent(out), optional :: err

        call settle_on('history', owned(self%owner), status, caller, err)
    end subroutine conclude

    !> Whether a list has another number of rows; then the failure has been reported.
    function misfit(self, what, extents, rows, err) result(wrong)
        class(hg_history), intent(in) :: self
        !> Name of the Fortran call and of its argument
        character(len=*), intent(in) :: what
        !> Shape of that argument
        integer, intent(in) :: extents(2)
        !> What it must have
        integer, intent(in) :: rows
        type(hg_error), intent(out), optional :: err
        logical :: wrong

        wrong = c_associated(owned(self%owner)) .and. extents(1) /= rows
        if (wrong) then
            call raise(HG_ERR_ARGUMENT, what//shape_text(extents)//' has other than '// &
                number_text(rows)//' rows', err)
        end if
    end function misfit

end module hgrid_history
