! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Visitors: how batches of pairs travel from the C library to a procedure or an object of the user.
module hgrid_visit
    use, intrinsic :: iso_c_binding, only: c_f_pointer, c_funloc, c_funptr, c_int32_t, c_loc, &
        c_ptr, c_size_t
    implicit none
    private

    public :: c_hg_visit_pairs
    public :: hg_pair_procedure, hg_pair_visitor, visit_with_object, visit_with_procedure

    !> Extend this type with the data that a visit needs and gathers.
    type, abstract :: hg_pair_visitor
    contains
        procedure(visit_batch), deferred :: visit
    end type hg_pair_visitor

    abstract interface
        !> Takes one batch of pairs; returns 0 to go on, anything else to end the visit.
        function visit_batch(self, pairs) result(answer)
            import :: c_int32_t, hg_pair_visitor
            class(hg_pair_visitor), intent(inout) :: self
            !> (2, n), ids; valid during the call only
            integer(c_int32_t), intent(in) :: pairs(:, :)
            integer(c_int32_t) :: answer
        end function visit_batch

        !> The same without an object, for procedures that reach their data by host or use
        !> association.
        function hg_pair_procedure(pairs) result(answer)
            import :: c_int32_t
            !> (2, n), ids; valid during the call only
            integer(c_int32_t), intent(in) :: pairs(:, :)
            integer(c_int32_t) :: answer
        end function hg_pair_procedure
    end interface

    interface
        function c_hg_visit_pairs(grid, visit, context) bind(c, name='hg_visit_pairs') &
            result(status)
            import
            type(c_ptr), value :: grid
            !> An hg_pair_visitor: int32_t (*)(void *context, const hg_pair *pairs, size_t count)
            type(c_funptr), value :: visit
            !> Handed to the visitor
            type(c_ptr), value :: context
            integer(c_int32_t) :: status
        end function c_hg_visit_pairs
    end interface

    ! The C library carries one plain address; polymorphic and procedure pointers are wider, so a
    ! frame holds them.
    type :: object_frame
        class(hg_pair_visitor), pointer :: visitor => null()
    end type object_frame

    type :: procedure_frame
        procedure(hg_pair_procedure), pointer, nopass :: visit => null()
    end type procedure_frame

contains

    function visit_with_object(grid, visitor) result(status)
        type(c_ptr), intent(in) :: grid
        !> Receives the batches
        class(hg_pair_visitor), intent(inout), target :: visitor
        integer(c_int32_t) :: status

        type(object_frame), target :: frame

        frame%visitor => visitor
        status = c_hg_visit_pairs(grid, c_funloc(forward_to_object), c_loc(frame))
    end function visit_with_object

    function visit_with_procedure(grid, visit) result(status)
        type(c_ptr), intent(in) :: grid
        !> Receives the batches
        procedure(hg_pair_procedure) :: visit
        integer(c_int32_t) :: status

        type(procedure_frame), target :: frame

        frame%visit => visit
        status = c_hg_visit_pairs(grid, c_funloc(forward_to_procedure), c_loc(frame))
    end function visit_with_procedure

    ! The empty name keeps the symbol out of the C name space.
    function forward_to_object(context, pairs, count) bind(c, name='') result(answer)
        !> An object_frame
        type(c_ptr), value :: context
        !> hg_pair[count]
        type(c_ptr), value :: pairs
        integer(c_size_t), value :: count
        integer(c_int32_t) :: answer

        type(object_frame), pointer :: frame
        integer(c_int32_t), pointer :: batch(:, :)

        call c_f_pointer(context, frame)
        call c_f_pointer(pairs, batch, [2_c_size_t, count])
        answer = frame%visitor%visit(batch)
    end function forward_to_object

    function forward_to_procedure(context, pairs, count) bind(c, name='') result(answer)
        !> A procedure_frame
        type(c_ptr), value :: context
        !> hg_pair[count]
        type(c_ptr), value :: pairs
        integer(c_size_t), value :: count
        integer(c_int32_t) :: answer

        type(procedure_frame), pointer :: frame
        integer(c_int32_t), pointer :: batch(:, :)

        call c_f_pointer(context, frame)
        call c_f_pointer(pairs, batch, [2_c_size_t, count])
        answer = frame%visit(batch)
    end function forward_to_procedure

end module hgrid_visit
