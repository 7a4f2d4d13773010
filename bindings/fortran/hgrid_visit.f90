! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Visitors: how batches of pairs or contacts travel from the C library to a procedure or an object
!> of the user.
module hgrid_visit
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_funloc, &
        c_funptr, c_int32_t, c_loc, c_ptr, c_size_t
    use hgrid_types, only: hg_contact_batch, HG_MAX_BATCH
    implicit none
    private

    public :: c_hg_visit_contacts, c_hg_visit_pairs
    public :: hg_contact_visitor, hg_pair_procedure, hg_pair_visitor
    public :: visit_contacts_with_object, visit_with_object, visit_with_procedure

    !> Extend this type with the data that a visit needs and gathers.
    type, abstract :: hg_pair_visitor
    contains
        procedure(visit_batch), deferred :: visit
    end type hg_pair_visitor

    !> The same for contacts: pairs with their geometry.
    type, abstract :: hg_contact_visitor
    contains
        procedure(visit_contact_batch), deferred :: visit
    end type hg_contact_visitor

    abstract interface
        !> Takes one batch of contacts; returns 0 to go on, anything else to end the visit. All
        !> arguments are valid during the call only.
        function visit_contact_batch(self, i, j, d, reach) result(answer)
            import :: c_double, c_int32_t, hg_contact_visitor
            class(hg_contact_visitor), intent(inout) :: self
            !> (n), ids
            integer(c_int32_t), intent(in) :: i(:), j(:)
            !> (dimension, n), from i to the image of j that it meets
            real(c_double), intent(in) :: d(:, :)
            !> (n), how far the two reach together
            real(c_double), intent(in) :: reach(:)
            integer(c_int32_t) :: answer
        end function visit_contact_batch

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

        function c_hg_visit_contacts(grid, visit, context) bind(c, name='hg_visit_contacts') &
            result(status)
            import
            type(c_ptr), value :: grid
            !> An hg_contact_visitor of C: int32_t (*)(void *context, const hg_contact_batch *batch)
            type(c_funptr), value :: visit
            !> Handed to the visitor
            type(c_ptr), value :: context
            integer(c_int32_t) :: status
        end function c_hg_visit_contacts
    end interface

    ! The C library carries one plain address; polymorphic and procedure pointers are wider, so a
    ! frame holds them.
    type :: object_frame
        class(hg_pair_visitor), pointer :: visitor => null()
    end type object_frame

    type :: contact_frame
        class(hg_contact_visitor), pointer :: visitor => null()
    end type contact_frame

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

    function visit_contacts_with_object(grid, visitor) result(status)
        type(c_ptr), intent(in) :: grid
        !> Receives the batches
        class(hg_contact_visitor), intent(inout), target :: visitor
        integer(c_int32_t) :: status

        type(contact_frame), target :: frame

        frame%visitor => visitor
        status = c_hg_visit_contacts(grid, c_funloc(forward_contacts), c_loc(frame))
    end function visit_contacts_with_object

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

    function forward_contacts(context, batch) bind(c, name='') result(answer)
        !> A contact_frame
        type(c_ptr), value :: context
        !> The contacts, as C has them
        type(hg_contact_batch), intent(in) :: batch
        integer(c_int32_t) :: answer

        type(contact_frame), pointer :: frame
        integer(c_int32_t), pointer :: i(:), j(:)
        real(c_double), pointer :: component(:), reach(:)
        real(c_double) :: in_space(3, HG_MAX_BATCH), in_plane(2, HG_MAX_BATCH)
        integer :: n

        n = int(batch%count)
        call c_f_pointer(context, frame)
        call c_f_pointer(batch%a, i, [n])
        call c_f_pointer(batch%b, j, [n])
        call c_f_pointer(batch%reach, reach, [n])
        call c_f_pointer(batch%dx, component, [n])
        if (c_associated(batch%dz)) then
            in_space(1, :n) = component
            call c_f_pointer(batch%dy, component, [n])
            in_space(2, :n) = component
            call c_f_pointer(batch%dz, component, [n])
            in_space(3, :n) = component
            answer = frame%visitor%visit(i, j, in_space(:, :n), reach)
        else
            in_plane(1, :n) = component
            call c_f_pointer(batch%dy, component, [n])
            in_plane(2, :n) = component
            answer = frame%visitor%visit(i, j, in_plane(:, :n), reach)
        end if
    end function forward_contacts

end module hgrid_visit
