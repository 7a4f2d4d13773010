! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Compares sizes, offsets and constants of module hgrid_c with those of the C headers, name by name.
program struct_layout
    use, intrinsic :: iso_c_binding, only: c_char, c_int64_t, c_intptr_t, c_loc, c_null_char, &
        c_ptr, c_sizeof
    use, intrinsic :: iso_fortran_env, only: error_unit
    use hgrid_c
    implicit none

    interface
        function layout_length() bind(c) result(length)
            import :: c_int64_t
            integer(c_int64_t) :: length
        end function layout_length

        function layout_number(name) bind(c) result(number)
            import :: c_char, c_int64_t
            !> Null-terminated
            character(kind=c_char), intent(in) :: name(*)
            integer(c_int64_t) :: number
        end function layout_number
    end interface

    integer :: compared = 0, failures = 0

    call compare_allocator()
    call compare_pair()
    call compare_grid_def()
    call compare_level()
    call compare_level_cost()
    call compare_grid_stats()
    call compare_array()
    call compare_contact_batch()
    call compare_contact_key()
    call compare_constants()
    if (compared /= layout_length()) then
        write (error_unit, '(a, i0, a, i0)') 'compared ', compared, ' numbers, the C side has ', layout_length()
        failures = failures + 1
    end if
    if (failures > 0) error stop 'the Fortran module does not fit the C headers'

contains

    !> Where a member stands in its struct.
    function offset(member, whole) result(bytes)
        !> Address of the member
        type(c_ptr), intent(in) :: member
        !> Address of the struct
        type(c_ptr), intent(in) :: whole
        integer(c_int64_t) :: bytes

        bytes = transfer(member, 0_c_intptr_t) - transfer(whole, 0_c_intptr_t)
    end function offset

    !> Counts and reports a number that differs from C's.
    subroutine compare(name, number)
        !> Its name in the list of the C side
        character(*), intent(in) :: name
        !> What it is in Fortran
        integer(c_int64_t), intent(in) :: number
        integer(c_int64_t) :: expected

        compared = compared + 1
        expected = layout_number(name//c_null_char)
        if (number /= expected) then
            write (error_unit, '(2a, i0, a, i0)') name, ': Fortran ', number, ', C ', expected
            failures = failures + 1
        end if
    end subroutine compare

    subroutine compare_allocator()
        type(hg_allocator), target :: it

        call compare('hg_allocator', int(c_sizeof(it), c_int64_t))
        call compare('hg_allocator%context', offset(c_loc(it%context), c_loc(it)))
        call compare('hg_allocator%allocate', offset(c_loc(it%allocate), c_loc(it)))
        call compare('hg_allocator%reallocate', offset(c_loc(it%reallocate), c_loc(it)))
        call compare('hg_allocator%release', offset(c_loc(it%release), c_loc(it)))
    end subroutine compare_allocator

    subroutine compare_pair()
        type(hg_pair), target :: it

        call compare('hg_pair', int(c_sizeof(it), c_int64_t))
        call compare('hg_pair%a', offset(c_loc(it%a), c_loc(it)))
        call compare('hg_pair%b', offset(c_loc(it%b), c_loc(it)))
    end subroutine compare_pair

    subroutine compare_grid_def()
        type(hg_grid_def), target :: it

        call compare('hg_grid_def', int(c_sizeof(it), c_int64_t))
        call compare('hg_grid_def%struct_size', offset(c_loc(it%struct_size), c_loc(it)))
        call compare('hg_grid_def%dimension', offset(c_loc(it%dimension), c_loc(it)))
        call compare('hg_grid_def%thread_count', offset(c_loc(it%thread_count), c_loc(it)))
        call compare('hg_grid_def%index_base', offset(c_loc(it%index_base), c_loc(it)))
        call compare('hg_grid_def%interaction', offset(c_loc(it%interaction), c_loc(it)))
        call compare('hg_grid_def%accuracy', offset(c_loc(it%accuracy), c_loc(it)))
        call compare('hg_grid_def%pair_order', offset(c_loc(it%pair_order), c_loc(it)))
        call compare('hg_grid_def%level_rule', offset(c_loc(it%level_rule), c_loc(it)))
        call compare('hg_grid_def%level_count', offset(c_loc(it%level_count), c_loc(it)))
        call compare('hg_grid_def%reserved0', offset(c_loc(it%reserved0), c_loc(it)))
        call compare('hg_grid_def%cell_sizes', offset(c_loc(it%cell_sizes), c_loc(it)))
        call compare('hg_grid_def%margin', offset(c_loc(it%margin), c_loc(it)))
        call compare('hg_grid_def%skin', offset(c_loc(it%skin), c_loc(it)))
        call compare('hg_grid_def%periodic', offset(c_loc(it%periodic), c_loc(it)))
        call compare('hg_grid_def%reserved1', offset(c_loc(it%reserved1), c_loc(it)))
        call compare('hg_grid_def%box_min', offset(c_loc(it%box_min), c_loc(it)))
        call compare('hg_grid_def%box_max', offset(c_loc(it%box_max), c_loc(it)))
        call compare('hg_grid_def%cell_overhead', offset(c_loc(it%cell_overhead), c_loc(it)))
        call compare('hg_grid_def%level_price', offset(c_loc(it%level_price), c_loc(it)))
        call compare('hg_grid_def%row_price', offset(c_loc(it%row_price), c_loc(it)))
        call compare('hg_grid_def%tilt', offset(c_loc(it%tilt), c_loc(it)))
        call compare('hg_grid_def%touching', offset(c_loc(it%touching), c_loc(it)))
        call compare('hg_grid_def%images', offset(c_loc(it%images), c_loc(it)))
    end subroutine compare_grid_def

    subroutine compare_level()
        type(hg_level), target :: it

        call compare('hg_level', int(c_sizeof(it), c_int64_t))
        call compare('hg_level%cell_size', offset(c_loc(it%cell_size), c_loc(it)))
        call compare('hg_level%largest_radius', offset(c_loc(it%largest_radius), c_loc(it)))
        call compare('hg_level%occupancy', offset(c_loc(it%occupancy), c_loc(it)))
        call compare('hg_level%particle_count', offset(c_loc(it%particle_count), c_loc(it)))
    end subroutine compare_level

    subroutine compare_level_cost()
        type(hg_level_cost), target :: it

        call compare('hg_level_cost', int(c_sizeof(it), c_int64_t))
        call compare('hg_level_cost%level_count', offset(c_loc(it%level_count), c_loc(it)))
        call compare('hg_level_cost%reachable', offset(c_loc(it%reachable), c_loc(it)))
        call compare('hg_level_cost%occupancy', offset(c_loc(it%occupancy), c_loc(it)))
        call compare('hg_level_cost%cost', offset(c_loc(it%cost), c_loc(it)))
    end subroutine compare_level_cost

    subroutine compare_grid_stats()
        type(hg_grid_stats), target :: it

        call compare('hg_grid_stats', int(c_sizeof(it), c_int64_t))
        call compare('hg_grid_stats%particle_count', offset(c_loc(it%particle_count), c_loc(it)))
        call compare('hg_grid_stats%level_count', offset(c_loc(it%level_count), c_loc(it)))
        call compare('hg_grid_stats%row_count', offset(c_loc(it%row_count), c_loc(it)))
        call compare('hg_grid_stats%cell_count', offset(c_loc(it%cell_count), c_loc(it)))
        call compare('hg_grid_stats%candidate_count', offset(c_loc(it%candidate_count), c_loc(it)))
        call compare('hg_grid_stats%undecided_count', offset(c_loc(it%undecided_count), c_loc(it)))
        call compare('hg_grid_stats%exact_count', offset(c_loc(it%exact_count), c_loc(it)))
        call compare('hg_grid_stats%pair_count', offset(c_loc(it%pair_count), c_loc(it)))
        call compare('hg_grid_stats%build_count', offset(c_loc(it%build_count), c_loc(it)))
        call compare('hg_grid_stats%search_count', offset(c_loc(it%search_count), c_loc(it)))
        call compare('hg_grid_stats%byte_count', offset(c_loc(it%byte_count), c_loc(it)))
        call compare('hg_grid_stats%filter_count', offset(c_loc(it%filter_count), c_loc(it)))
        call compare('hg_grid_stats%stored_count', offset(c_loc(it%stored_count), c_loc(it)))
    end subroutine compare_grid_stats

    subroutine compare_array()
        type(hg_array), target :: it

        call compare('hg_array', int(c_sizeof(it), c_int64_t))
        call compare('hg_array%data', offset(c_loc(it%data), c_loc(it)))
        call compare('hg_array%stride', offset(c_loc(it%stride), c_loc(it)))
        call compare('hg_array%type', offset(c_loc(it%type), c_loc(it)))
        call compare('hg_array%reserved', offset(c_loc(it%reserved), c_loc(it)))
    end subroutine compare_array

    subroutine compare_contact_batch()
        type(hg_contact_batch), target :: it

        call compare('hg_contact_batch', int(c_sizeof(it), c_int64_t))
        call compare('hg_contact_batch%count', offset(c_loc(it%count), c_loc(it)))
        call compare('hg_contact_batch%a', offset(c_loc(it%a), c_loc(it)))
        call compare('hg_contact_batch%b', offset(c_loc(it%b), c_loc(it)))
        call compare('hg_contact_batch%dx', offset(c_loc(it%dx), c_loc(it)))
        call compare('hg_contact_batch%dy', offset(c_loc(it%dy), c_loc(it)))
        call compare('hg_contact_batch%dz', offset(c_loc(it%dz), c_loc(it)))
        call compare('hg_contact_batch%reach', offset(c_loc(it%reach), c_loc(it)))
    end subroutine compare_contact_batch

    subroutine compare_contact_key()
        type(hg_contact_key), target :: it

        call compare('hg_contact_key', int(c_sizeof(it), c_int64_t))
        call compare('hg_contact_key%a', offset(c_loc(it%a), c_loc(it)))
        call compare('hg_contact_key%b', offset(c_loc(it%b), c_loc(it)))
        call compare('hg_contact_key%sub', offset(c_loc(it%sub), c_loc(it)))
    end subroutine compare_contact_key

    subroutine compare_constants()
        call compare('HG_OK', int(HG_OK, c_int64_t))
        call compare('HG_ERR_NULL', int(HG_ERR_NULL, c_int64_t))
        call compare('HG_ERR_ARGUMENT', int(HG_ERR_ARGUMENT, c_int64_t))
        call compare('HG_ERR_MEMORY', int(HG_ERR_MEMORY, c_int64_t))
        call compare('HG_ERR_CAPACITY', int(HG_ERR_CAPACITY, c_int64_t))
        call compare('HG_ERR_STATE', int(HG_ERR_STATE, c_int64_t))
        call compare('HG_ERR_NOT_FOUND', int(HG_ERR_NOT_FOUND, c_int64_t))
        call compare('HG_ERR_LIMIT', int(HG_ERR_LIMIT, c_int64_t))
        call compare('HG_ERR_INTERNAL', int(HG_ERR_INTERNAL, c_int64_t))
        call compare('HG_ERR_MPI', int(HG_ERR_MPI, c_int64_t))
        call compare('HG_ERR_REMOTE', int(HG_ERR_REMOTE, c_int64_t))
        call compare('HG_CONTACT', int(HG_CONTACT, c_int64_t))
        call compare('HG_MAX_RANGE', int(HG_MAX_RANGE, c_int64_t))
        call compare('HG_EXACT', int(HG_EXACT, c_int64_t))
        call compare('HG_DOUBLE', int(HG_DOUBLE, c_int64_t))
        call compare('HG_FLOAT', int(HG_FLOAT, c_int64_t))
        call compare('HG_ORDER_GRID', int(HG_ORDER_GRID, c_int64_t))
        call compare('HG_ORDER_ID', int(HG_ORDER_ID, c_int64_t))
        call compare('HG_LEVELS_AUTO', int(HG_LEVELS_AUTO, c_int64_t))
        call compare('HG_LEVELS_PAPER', int(HG_LEVELS_PAPER, c_int64_t))
        call compare('HG_LEVELS_USER', int(HG_LEVELS_USER, c_int64_t))
        call compare('HG_NEAREST_IMAGE', int(HG_NEAREST_IMAGE, c_int64_t))
        call compare('HG_ALL_IMAGES', int(HG_ALL_IMAGES, c_int64_t))
        call compare('HG_HALF', int(HG_HALF, c_int64_t))
        call compare('HG_FULL', int(HG_FULL, c_int64_t))
        call compare('HG_MAX_LEVELS', int(HG_MAX_LEVELS, c_int64_t))
        call compare('HG_REAL64', int(HG_REAL64, c_int64_t))
        call compare('HG_REAL32', int(HG_REAL32, c_int64_t))
        call compare('HG_MAX_GROUPS', int(HG_MAX_GROUPS, c_int64_t))
        call compare('HG_MAX_BATCH', int(HG_MAX_BATCH, c_int64_t))
    end subroutine compare_constants

end program struct_layout
