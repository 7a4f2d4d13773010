! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Counts failed checks, names each one, and ends the program accordingly.
module checks
    use, intrinsic :: iso_fortran_env, only: error_unit
    use hgrid, only: HG_OK, c_int32_t, hg_error, hg_status_string
    implicit none
    private

    public :: check, check_fails, check_works, finish_checks

    integer :: failures = 0

contains

    subroutine check(holds, what)
        !> What was checked
        logical, intent(in) :: holds
        !> Named if it does not hold
        character(len=*), intent(in) :: what

        if (holds) return
        failures = failures + 1
        write (error_unit, '(2a)') 'failed: ', what
    end subroutine check

    subroutine check_works(err, what)
        !> Returned by a call
        type(hg_error), intent(in) :: err
        !> The call
        character(len=*), intent(in) :: what

        if (.not. allocated(err%message)) then
            call check(.false., what//': no message')
        else
            call check(err%code == HG_OK .and. err%message == '', what//': '//err%message)
        end if
    end subroutine check_works

    !> The call must have failed with this code and a message that holds this text.
    subroutine check_fails(err, code, text, what)
        !> Returned by a call
        type(hg_error), intent(in) :: err
        !> Expected code
        integer(c_int32_t), intent(in) :: code
        !> Part of the expected message
        character(len=*), intent(in) :: text
        !> The call
        character(len=*), intent(in) :: what

        if (.not. allocated(err%message)) then
            call check(.false., what//': no message')
            return
        end if
        call check(err%code == code, what//': wants '//hg_status_string(code)//', gets '// &
            hg_status_string(err%code))
        call check(index(err%message, text) > 0, what//': message "'//err%message// &
            '" lacks "'//text//'"')
    end subroutine check_fails

    subroutine finish_checks()
        if (failures == 0) return
        write (error_unit, '(i0,a)') failures, ' checks failed'
        error stop 1
    end subroutine finish_checks

end module checks
