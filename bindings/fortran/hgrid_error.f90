! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> How failures reach the caller: in the optional argument err, or, without it, by stopping the
!> program.
module hgrid_error
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int32_t, c_ptr, &
        c_size_t
    use, intrinsic :: iso_fortran_env, only: error_unit
    use hgrid_types, only: c_hg_last_error, c_hg_status_string, HG_ERR_NULL, HG_ERR_STATE, HG_OK
    implicit none
    private

    public :: hg_error, hg_status_string, number_text, raise, refuse_copies, settle, settle_on
    public :: shape_text

    !> What the optional last argument of each call returns: HG_OK and an empty message, or what
    !> went wrong.
    type :: hg_error
        integer(c_int32_t) :: code = HG_OK
        character(len=:), allocatable :: message
    end type hg_error

    interface
        pure function c_strlen(text) bind(c, name='strlen') result(length)
            import :: c_ptr, c_size_t
            !> A string that ends with a null character
            type(c_ptr), intent(in), value :: text
            integer(c_size_t) :: length
        end function c_strlen
    end interface

contains

    !> Ends a call of the C interface: `caller` names the call in the message.
    subroutine settle(status, caller, err)
        !> What the C call returned
        integer(c_int32_t), intent(in) :: status
        !> Name of the Fortran call
        character(len=*), intent(in) :: caller
        type(hg_error), intent(out), optional :: err

        if (status /= HG_OK) then
            call raise(status, &
                caller//': '//fortran_subscripts(fortran_text(c_hg_last_error())), err)
        else if (present(err)) then
            err%message = ''
        end if
    end subroutine settle

    !> Ends a call on a C object, which may never have been created.
    subroutine settle_on(what, handle, status, caller, err)
        !> The object: grid or history
        character(len=*), intent(in) :: what
        type(c_ptr), intent(in) :: handle
        !> What the C call returned
        integer(c_int32_t), intent(in) :: status
        !> Name of the Fortran call
        character(len=*), intent(in) :: caller
        type(hg_error), intent(out), optional :: err

        if (c_associated(handle)) then
            call settle(status, caller, err)
        else
            call raise(HG_ERR_NULL, &
                caller//': the '//what//' was not created, call create first (one that is '// &
                'local to a procedure ends with it, unless it is declared with save)', err)
        end if
    end subroutine settle_on

    !> Two copies would own the same memory.
    subroutine refuse_copies(what)
        !> The objects: grid or history
        character(len=*), intent(in) :: what

        call raise(HG_ERR_STATE, &
            'an hg_'//what//' cannot be copied: pass it as an argument instead')
    end subroutine refuse_copies

    !> Reports a failure.
    subroutine raise(code, message, err)
        !> One of HG_ERR_*
        integer(c_int32_t), intent(in) :: code
        !> What went wrong, with the offending value
        character(len=*), intent(in) :: message
        !> Absent: the program stops
        type(hg_error), intent(out), optional :: err

        if (present(err)) then
            err%code = code
            err%message = message
        else
            write (error_unit, '(4a)') 'libhgrid: ', hg_status_string(code), ': ', message
            flush (error_unit)
            error stop 1
        end if
    end subroutine raise

    !> The name of a status code, such as "HG_ERR_ARGUMENT".
    function hg_status_string(code) result(text)
        !> A status code
        integer(c_int32_t), intent(in) :: code
        character(len=:), allocatable :: text

        text = fortran_text(c_hg_status_string(code))
    end function hg_status_string

    !> A shape as it stands in a declaration, such as "(3,10)".
    function shape_text(extents) result(text)
        !> shape(array)
        integer, intent(in) :: extents(:)
        character(len=:), allocatable :: text

        integer :: i

        text = '('//number_text(extents(1))
        do i = 2, size(extents)
            text = text//','//number_text(extents(i))
        end do
        text = text//')'
    end function shape_text

    function number_text(number) result(text)
        !> Any number
        integer, intent(in) :: number
        character(len=:), allocatable :: text

        character(len=20) :: digits

        write (digits, '(i0)') number
        text = trim(digits)
    end function number_text

    !> Turns the C subscripts of a message into those of the Fortran arrays: radii[4] is radii(5),
    !> and centers[4][0] is centers(1,5).
    function fortran_subscripts(message) result(text)
        !> From the C library
        character(len=*), intent(in) :: message
        character(len=:), allocatable :: text

        character(len=:), allocatable :: subscripts
        integer :: here, length, number

        text = ''
        here = 1
        do while (here <= len(message))
            subscripts = ''
            do
                call read_subscript(message(here:), number, length)
                if (length == 0) exit
                subscripts = number_text(number + 1)//','//subscripts
                here = here + length
            end do
            if (subscripts /= '') then
                text = text//'('//subscripts(:len(subscripts) - 1)//')'
            else
                text = text//message(here:here)
                here = here + 1
            end if
        end do
    end function fortran_subscripts

    !> Reads a C subscript such as "[12]"; an interval such as "[0, 3]" is none.
    subroutine read_subscript(text, number, length)
        !> Begins with the subscript, if there is one
        character(len=*), intent(in) :: text
        !> Its value
        integer, intent(out) :: number
        !> Its length with the brackets; 0 if there is none
        integer, intent(out) :: length

        integer :: last, stat

        length = 0
        number = 0
        if (index(text, '[') /= 1) return
        last = verify(text(2:), '0123456789')
        if (last < 2) return
        if (text(last + 1:last + 1) /= ']') return
        read (text(2:last), *, iostat=stat) number
        if (stat == 0) length = last + 1
    end subroutine read_subscript

    !> A copy of a C string.
    function fortran_text(string) result(text)
        !> Ends with a null character
        type(c_ptr), intent(in) :: string
        character(len=:), allocatable :: text

        character(kind=c_char), pointer :: letters(:)
        integer(c_size_t) :: i, length

        length = c_strlen(string)
        call c_f_pointer(string, letters, [length])
        allocate (character(len=length) :: text)
        do i = 1, length
            text(i:i) = letters(i)
        end do
    end function fortran_text

end module hgrid_error
