! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> A memory source that counts what grids hold and can refuse to give more.
module counted_memory
    use, intrinsic :: iso_c_binding, only: c_associated, c_funloc, c_int32_t, c_int64_t, &
        c_null_ptr, c_ptr, c_size_t
    use hgrid_c, only: c_hg_set_allocator, hg_allocator
    implicit none
    private

    public :: bytes_held, calls_made, refuse_memory, start_counting

    integer(c_int64_t) :: held = 0
    integer :: calls = 0
    logical :: refusing = .false.

    interface
        function c_malloc(size) bind(c, name='malloc') result(memory)
            import :: c_ptr, c_size_t
            !> Bytes
            integer(c_size_t), value :: size
            type(c_ptr) :: memory
        end function c_malloc

        function c_realloc(memory, size) bind(c, name='realloc') result(larger)
            import :: c_ptr, c_size_t
            !> Null or from malloc
            type(c_ptr), value :: memory
            !> Bytes
            integer(c_size_t), value :: size
            type(c_ptr) :: larger
        end function c_realloc

        subroutine c_free(memory) bind(c, name='free')
            import :: c_ptr
            !> Null or from malloc
            type(c_ptr), value :: memory
        end subroutine c_free
    end interface

contains

    subroutine start_counting(status)
        !> HG_OK
        integer(c_int32_t), intent(out) :: status

        status = c_hg_set_allocator(hg_allocator(c_null_ptr, c_funloc(take), c_funloc(resize), &
            c_funloc(give_back)))
    end subroutine start_counting

    subroutine refuse_memory(refuse)
        !> From now on
        logical, intent(in) :: refuse

        refusing = refuse
    end subroutine refuse_memory

    function bytes_held() result(bytes)
        integer(c_int64_t) :: bytes

        bytes = held
    end function bytes_held

    function calls_made() result(number)
        integer :: number

        number = calls
    end function calls_made

    function take(context, size) bind(c, name='') result(memory)
        !> Not used
        type(c_ptr), value :: context
        !> Bytes
        integer(c_size_t), value :: size
        type(c_ptr) :: memory

        memory = c_null_ptr
        calls = calls + 1
        if (refusing .or. c_associated(context)) return
        memory = c_malloc(size)
        if (c_associated(memory)) held = held + size
    end function take

    function resize(context, memory, old_size, new_size) bind(c, name='') result(larger)
        !> Not used
        type(c_ptr), value :: context
        !> Memory that was taken
        type(c_ptr), value :: memory
        !> Bytes
        integer(c_size_t), value :: old_size
        !> Bytes
        integer(c_size_t), value :: new_size
        type(c_ptr) :: larger

        larger = c_null_ptr
        calls = calls + 1
        if (refusing .or. c_associated(context)) return
        larger = c_realloc(memory, new_size)
        if (c_associated(larger)) held = held + new_size - old_size
    end function resize

    subroutine give_back(context, memory, size) bind(c, name='')
        !> Not used
        type(c_ptr), value :: context
        !> Memory that was taken
        type(c_ptr), value :: memory
        !> Bytes
        integer(c_size_t), value :: size

        if (.not. c_associated(memory) .or. c_associated(context)) return
        held = held - size
        call c_free(memory)
    end subroutine give_back

end module counted_memory
