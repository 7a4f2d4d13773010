! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Objects of C that end with the Fortran variable that holds them, wherever it stands.
!>
!> A variable holds its C object through an allocatable component, an hg_owner, as no other form
!> survives gfortran 12: that compiler finalises allocatable components rightly, but hands wrong
!> addresses to the final procedure of a type whose variables are components in arrays.
module hgrid_owner
    use, intrinsic :: iso_c_binding, only: c_associated, c_loc, c_null_ptr, c_ptr
    implicit none
    private

    public :: disown, hg_owner, own, owned

    !> Destroys its C object when it is deallocated. Only the owner at `here` does: others are bare
    !> copies of it, as allocate (b, source=a) makes them.
    type :: hg_owner
        private
        type(c_ptr) :: object = c_null_ptr
        type(c_ptr) :: here = c_null_ptr
        procedure(destroy_object), pointer, nopass :: destroy => null()
    contains
        final :: finish
    end type hg_owner

    abstract interface
        subroutine destroy_object(object) bind(c)
            import :: c_ptr
            !> The C object
            type(c_ptr), value :: object
        end subroutine destroy_object
    end interface

contains

    !> Destroys the former object, if any, and owns a new one from now on.
    subroutine own(owner, object, destroy)
        type(hg_owner), allocatable, intent(inout) :: owner
        !> The C object
        type(c_ptr), intent(in) :: object
        !> The C call that ends it
        procedure(destroy_object) :: destroy

        call disown(owner)
        allocate (owner)
        owner%object = object
        owner%here = place_of(owner)
        owner%destroy => destroy
    end subroutine own

    !> Destroys the object, if any.
    subroutine disown(owner)
        type(hg_owner), allocatable, intent(inout) :: owner

        if (allocated(owner)) deallocate (owner)
    end subroutine disown

    !> The C object; null if there is none or it belongs to another variable.
    function owned(owner) result(object)
        type(hg_owner), allocatable, intent(in) :: owner
        type(c_ptr) :: object

        object = c_null_ptr
        if (.not. allocated(owner)) return
        if (c_associated(owner%here, place_of(owner))) object = owner%object
    end function owned

    impure elemental subroutine finish(self)
        type(hg_owner), intent(inout) :: self

        if (c_associated(self%here, place_of(self))) call self%destroy(self%object)
        self%here = c_null_ptr
    end subroutine finish

    !> Where an owner stands in memory.
    function place_of(owner) result(place)
        type(hg_owner), intent(in), target :: owner
        type(c_ptr) :: place

        place = c_loc(owner)
    end function place_of

end module hgrid_owner
