! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Contact history: data of contacts that follow them from one list of pairs to the next.
module hgrid_history
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_float, &
        c_int32_t, c_int64_t, c_loc, c_ptr, c_size_t, c_sizeof
    use hgrid_error, only: hg_error, number_text, raise, refuse_copies, settle, settle_on, &
        shape_text
    use hgrid_owner, only: disown, hg_owner, own, owned
    use hgrid_types, only: HG_ERR_ARGUMENT, HG_OK
    implicit none
    private

    public :: c_hg_history_carry, c_hg_history_clear, c_hg_history_create, c_hg_history_destroy
    public :: c_hg_history_pairs, c_hg_history_restore, c_hg_history_update
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
        procedure, public :: create
        procedure, public :: destroy
        procedure, public :: update
        !> carry(old, new): data of the list before in the order of the last one, zero where a
        !> contact is new; real64, real32 or int32, (count) or (rows, count)
        generic, public :: carry => carry_real64, carry_real64_rows, carry_real32, &
            carry_real32_rows, carry_int32, carry_int32_rows
        procedure, public :: pairs => remembered_pairs
        procedure, public :: restore
        procedure, public :: clear
        generic, public :: assignment(=) => refuse_copy
    end type hg_history

    interface
        function c_hg_history_create(history) bind(c, name='hg_history_create') result(status)
            import
            !> The new history, null on failure
            type(c_ptr), intent(out) :: history
            integer(c_int32_t) :: status
        end function c_hg_history_create

        subroutine c_hg_history_destroy(history) bind(c, name='hg_history_destroy')
            import
            !> The history; null is fine
            type(c_ptr), value :: history
        end subroutine c_hg_history_destroy

        function c_hg_history_update(history, count, pairs, previous) &
            bind(c, name='hg_history_update') result(status)
            import
            type(c_ptr), value :: history
            integer(c_size_t), value :: count
            !> hg_pair[count]
            type(c_ptr), value :: pairs
            !> int64_t[count], borrowed: places from 0, -1 for pairs that are new
            type(c_ptr), intent(out) :: previous
            integer(c_int32_t) :: status
        end function c_hg_history_update

        function c_hg_history_carry(history, item_size, old_items, new_items) &
            bind(c, name='hg_history_carry') result(status)
            import
            type(c_ptr), value :: history
            !> Bytes for one contact
            integer(c_size_t), value :: item_size
            !> One item for each pair of the list before
            type(c_ptr), value :: old_items
            !> One item for each pair of the last list
            type(c_ptr), value :: new_items
            integer(c_int32_t) :: status
        end function c_hg_history_carry

        function c_hg_history_pairs(history, pairs, count) bind(c, name='hg_history_pairs') &
            result(status)
            import
            type(c_ptr), value :: history
            !> hg_pair[count], borrowed
            type(c_ptr), intent(out) :: pairs
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_history_pairs

        function c_hg_history_restore(history, count, pairs) bind(c, name='hg_history_restore') &
            result(status)
            import
            type(c_ptr), value :: history
            integer(c_size_t), value :: count
            !> hg_pair[count]
            type(c_ptr), value :: pairs
            integer(c_int32_t) :: status
        end function c_hg_history_restore

        function c_hg_history_clear(history) bind(c, name='hg_history_clear') result(status)
            import
            type(c_ptr), value :: history
            integer(c_int32_t) :: status
        end function c_hg_history_clear
    end interface

    ! What pointers show when the list is empty: a Fortran result must be associated.
    integer(c_int32_t), target :: no_pairs(2, 0)

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
    subroutine update(self, pairs, previous, err)
        class(hg_history), intent(inout) :: self
        !> (2, count), in any order, none twice
        integer(c_int32_t), intent(in), contiguous, target :: pairs(:, :)
        !> (count): place of each pair in the former list, from 1; 0 if it was not there
        integer(c_int64_t), intent(inout), allocatable :: previous(:)
        type(hg_error), intent(out), optional :: err

        integer(c_int64_t), pointer :: places(:)
        integer(c_size_t) :: count
        integer(c_int32_t) :: status
        type(c_ptr) :: memory

        if (misfit(self, pairs, 'update', err)) return
        count = size(pairs, 2, c_size_t)
        status = c_hg_history_update(owned(self%owner), count, c_loc(pairs), memory)
        if (status == HG_OK) then
            if (allocated(previous)) then
                if (size(previous, kind=c_size_t) /= count) deallocate (previous)
            end if
            if (.not. allocated(previous)) allocate (previous(count))
            if (count > 0) then
                call c_f_pointer(memory, places, [count])
                previous = places + 1
            end if
            self%former_count = self%count
            self%count = count
        end if
        call conclude(self, status, 'update', err)
    end subroutine update

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
        if (status == HG_OK) then
            pairs => no_pairs
            if (count > 0) call c_f_pointer(memory, pairs, [2_c_size_t, count])
        end if
        call conclude(self, status, 'pairs', err)
    end subroutine remembered_pairs

    !> Remembers a list without matching it, for example that of a checkpoint.
    subroutine restore(self, pairs, err)
        class(hg_history), intent(inout) :: self
        !> (2, count), in any order, none twice
        integer(c_int32_t), intent(in), contiguous, target :: pairs(:, :)
        type(hg_error), intent(out), optional :: err

        integer(c_int32_t) :: status

        if (misfit(self, pairs, 'restore', err)) return
        status = c_hg_history_restore(owned(self%owner), size(pairs, 2, c_size_t), c_loc(pairs))
        if (status == HG_OK) self%count = size(pairs, 2, c_size_t)
        call conclude(self, status, 'restore', err)
    end subroutine restore

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
                    ' pairs', err)
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

    !> Whether pairs has another shape than (2, count); then the failure has been reported.
    function misfit(self, pairs, caller, err) result(wrong)
        class(hg_history), intent(in) :: self
        !> What was given
        integer(c_int32_t), intent(in) :: pairs(:, :)
        !> Name of the Fortran call
        character(len=*), intent(in) :: caller
        type(hg_error), intent(out), optional :: err
        logical :: wrong

        wrong = c_associated(owned(self%owner)) .and. size(pairs, 1) /= 2
        if (wrong) then
            call raise(HG_ERR_ARGUMENT, caller//': pairs'//shape_text(shape(pairs))// &
                ' has other than 2 rows', err)
        end if
    end function misfit

end module hgrid_history
