! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Grids that are given all their particles in each step, from whatever arrays a program keeps.
!>
!> Arrays are told to C by address, stride and kind, so that no section is copied here; only what
!> lies as C has it, x(dimension, n) of real64, is passed as it is.
module hgrid_sets
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_float, c_int32_t, &
        c_int64_t, c_intptr_t, c_loc, c_ptr, c_size_t
    use hgrid_error, only: hg_error, number_text, raise, shape_text
    use hgrid_handle, only: conclude, dimension_of, handle_of
    use hgrid_groups, only: hg_groups
    use hgrid_types, only: hg_array, HG_ERR_ARGUMENT, HG_REAL32, HG_REAL64
    implicit none
    private

    public :: c_hg_insert_arrays, c_hg_move_arrays, c_hg_set, c_hg_set_arrays
    public :: hg_sets

    !> A grid whose particles may be replaced as a whole. The names of its procedures end with the
    !> kinds of the centres and of the radii.
    type, extends(hg_groups) :: hg_sets
    contains
        private
        procedure :: set_rows_64_64, set_rows_32_32, set_rows_64_32, set_rows_32_64
        procedure :: set_flat_64_64, set_flat_32_32, set_flat_64_32, set_flat_32_64
        procedure :: set_plane_64_64, set_plane_32_32, set_plane_64_32, set_plane_32_64
        procedure :: set_space_64_64, set_space_32_32, set_space_64_32, set_space_32_64
        !> set(x, r): x(dimension, n) or x(dimension*n), r(n); set(x, y, z, r), in 2D set(x, y, r): n
        !> each. Then the grid holds these particles, with ids from index_base. real32 or real64.
        generic, public :: set => set_rows_64_64, set_rows_32_32, set_rows_64_32, &
            set_rows_32_64, set_flat_64_64, set_flat_32_32, &
            set_flat_64_32, set_flat_32_64, set_plane_64_64, &
            set_plane_32_32, set_plane_64_32, set_plane_32_64, &
            set_space_64_64, set_space_32_32, set_space_64_32, &
            set_space_32_64
    end type hg_sets

    !> How C finds the numbers of an array.
    interface column
        module procedure column_real64, column_real32
    end interface column

    !> The same of the centres: x(dimension, n), or x(dimension*n) and the dimension.
    interface columns
        module procedure columns_rows_real64, columns_rows_real32, columns_flat_real64, &
            columns_flat_real32
    end interface columns

    interface
        function c_hg_set(grid, count, centers, radii) bind(c, name='hg_set') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> (dimension, count)
            real(c_double), intent(in) :: centers(*)
            !> (count)
            real(c_double), intent(in) :: radii(*)
            integer(c_int32_t) :: status
        end function c_hg_set

        function c_hg_set_arrays(grid, count, centers, radius) bind(c, name='hg_set_arrays') &
            result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> (dimension)
            type(hg_array), intent(in) :: centers(*)
            type(hg_array), intent(in) :: radius
            integer(c_int32_t) :: status
        end function c_hg_set_arrays

        function c_hg_insert_arrays(grid, count, centers, radius) &
            bind(c, name='hg_insert_arrays') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> (dimension)
            type(hg_array), intent(in) :: centers(*)
            type(hg_array), intent(in) :: radius
            integer(c_int32_t) :: status
        end function c_hg_insert_arrays

        function c_hg_move_arrays(grid, count, centers, radius) bind(c, name='hg_move_arrays') &
            result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> (dimension)
            type(hg_array), intent(in) :: centers(*)
            !> Absent leaves the radii as they are
            type(hg_array), intent(in), optional :: radius
            integer(c_int32_t) :: status
        end function c_hg_move_arrays
    end interface

contains

    subroutine set_rows_64_64(self, x, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (dimension, n)
        real(c_double), intent(in), contiguous :: x(:, :)
        !> Radii (n), >= 0
        real(c_double), intent(in), contiguous :: r(:)
        type(hg_error), intent(out), optional :: err

        if (misfit(self, shape(x), size(r), err)) return
        call conclude(self, c_hg_set(handle_of(self), size(r, kind=c_size_t), x, r), 'set', err)
    end subroutine set_rows_64_64

    subroutine set_rows_32_32(self, x, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (dimension, n)
        real(c_float), intent(in), target :: x(:, :)
        !> Radii (n), >= 0
        real(c_float), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (misfit(self, shape(x), size(r), err)) return
        call set_columns(self, size(r), columns(x), column(r), err)
    end subroutine set_rows_32_32

    subroutine set_rows_64_32(self, x, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (dimension, n)
        real(c_double), intent(in), target :: x(:, :)
        !> Radii (n), >= 0
        real(c_float), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (misfit(self, shape(x), size(r), err)) return
        call set_columns(self, size(r), columns(x), column(r), err)
    end subroutine set_rows_64_32

    subroutine set_rows_32_64(self, x, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (dimension, n)
        real(c_float), intent(in), target :: x(:, :)
        !> Radii (n), >= 0
        real(c_double), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (misfit(self, shape(x), size(r), err)) return
        call set_columns(self, size(r), columns(x), column(r), err)
    end subroutine set_rows_32_64

    subroutine set_flat_64_64(self, x, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (dimension*n), those of one particle side by side
        real(c_double), intent(in), contiguous :: x(:)
        !> Radii (n), >= 0
        real(c_double), intent(in), contiguous :: r(:)
        type(hg_error), intent(out), optional :: err

        if (misfit(self, shape(x), size(r), err)) return
        call conclude(self, c_hg_set(handle_of(self), size(r, kind=c_size_t), x, r), 'set', err)
    end subroutine set_flat_64_64

    subroutine set_flat_32_32(self, x, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (dimension*n), those of one particle side by side
        real(c_float), intent(in), target :: x(:)
        !> Radii (n), >= 0
        real(c_float), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (misfit(self, shape(x), size(r), err)) return
        call set_columns(self, size(r), columns(x, dimension_of(self)), column(r), err)
    end subroutine set_flat_32_32

    subroutine set_flat_64_32(self, x, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (dimension*n), those of one particle side by side
        real(c_double), intent(in), target :: x(:)
        !> Radii (n), >= 0
        real(c_float), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (misfit(self, shape(x), size(r), err)) return
        call set_columns(self, size(r), columns(x, dimension_of(self)), column(r), err)
    end subroutine set_flat_64_32

    subroutine set_flat_32_64(self, x, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (dimension*n), those of one particle side by side
        real(c_float), intent(in), target :: x(:)
        !> Radii (n), >= 0
        real(c_double), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (misfit(self, shape(x), size(r), err)) return
        call set_columns(self, size(r), columns(x, dimension_of(self)), column(r), err)
    end subroutine set_flat_32_64

    subroutine set_plane_64_64(self, x, y, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (n) of a plane
        real(c_double), intent(in), target :: x(:), y(:)
        !> Radii (n), >= 0
        real(c_double), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (unequal(self, [size(x), size(y), size(r)], err)) return
        call set_columns(self, size(r), [column(x), column(y)], column(r), err)
    end subroutine set_plane_64_64

    subroutine set_plane_32_32(self, x, y, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (n) of a plane
        real(c_float), intent(in), target :: x(:), y(:)
        !> Radii (n), >= 0
        real(c_float), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (unequal(self, [size(x), size(y), size(r)], err)) return
        call set_columns(self, size(r), [column(x), column(y)], column(r), err)
    end subroutine set_plane_32_32

    subroutine set_plane_64_32(self, x, y, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (n) of a plane
        real(c_double), intent(in), target :: x(:), y(:)
        !> Radii (n), >= 0
        real(c_float), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (unequal(self, [size(x), size(y), size(r)], err)) return
        call set_columns(self, size(r), [column(x), column(y)], column(r), err)
    end subroutine set_plane_64_32

    subroutine set_plane_32_64(self, x, y, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (n) of a plane
        real(c_float), intent(in), target :: x(:), y(:)
        !> Radii (n), >= 0
        real(c_double), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (unequal(self, [size(x), size(y), size(r)], err)) return
        call set_columns(self, size(r), [column(x), column(y)], column(r), err)
    end subroutine set_plane_32_64

    subroutine set_space_64_64(self, x, y, z, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (n)
        real(c_double), intent(in), target :: x(:), y(:), z(:)
        !> Radii (n), >= 0
        real(c_double), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (unequal(self, [size(x), size(y), size(z), size(r)], err)) return
        call set_columns(self, size(r), [column(x), column(y), column(z)], column(r), err)
    end subroutine set_space_64_64

    subroutine set_space_32_32(self, x, y, z, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (n)
        real(c_float), intent(in), target :: x(:), y(:), z(:)
        !> Radii (n), >= 0
        real(c_float), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (unequal(self, [size(x), size(y), size(z), size(r)], err)) return
        call set_columns(self, size(r), [column(x), column(y), column(z)], column(r), err)
    end subroutine set_space_32_32

    subroutine set_space_64_32(self, x, y, z, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (n)
        real(c_double), intent(in), target :: x(:), y(:), z(:)
        !> Radii (n), >= 0
        real(c_float), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (unequal(self, [size(x), size(y), size(z), size(r)], err)) return
        call set_columns(self, size(r), [column(x), column(y), column(z)], column(r), err)
    end subroutine set_space_64_32

    subroutine set_space_32_64(self, x, y, z, r, err)
        class(hg_sets), intent(inout) :: self
        !> Centres (n)
        real(c_float), intent(in), target :: x(:), y(:), z(:)
        !> Radii (n), >= 0
        real(c_double), intent(in), target :: r(:)
        type(hg_error), intent(out), optional :: err

        if (unequal(self, [size(x), size(y), size(z), size(r)], err)) return
        call set_columns(self, size(r), [column(x), column(y), column(z)], column(r), err)
    end subroutine set_space_32_64

    subroutine set_columns(self, count, centers, radius, err)
        class(hg_sets), intent(in) :: self
        integer, intent(in) :: count
        !> One of each axis
        type(hg_array), intent(in) :: centers(:)
        type(hg_array), intent(in) :: radius
        type(hg_error), intent(out), optional :: err

        call conclude(self, &
            c_hg_set_arrays(handle_of(self), int(count, c_size_t), centers, radius), 'set', err)
    end subroutine set_columns

    function column_real64(numbers) result(array)
        !> One number of each particle; a target of the caller's
        real(c_double), intent(in), target :: numbers(:)
        type(hg_array) :: array

        array%type = HG_REAL64
        if (size(numbers) > 0) array%data = c_loc(numbers(1))
        if (size(numbers) > 1) array%stride = bytes_between(array%data, c_loc(numbers(2)))
    end function column_real64

    function column_real32(numbers) result(array)
        !> One number of each particle; a target of the caller's
        real(c_float), intent(in), target :: numbers(:)
        type(hg_array) :: array

        array%type = HG_REAL32
        if (size(numbers) > 0) array%data = c_loc(numbers(1))
        if (size(numbers) > 1) array%stride = bytes_between(array%data, c_loc(numbers(2)))
    end function column_real32

    function columns_rows_real64(x) result(centers)
        !> (dimension, n); a target of the caller's
        real(c_double), intent(in), target :: x(:, :)
        type(hg_array) :: centers(size(x, 1))

        integer :: axis

        do axis = 1, size(centers)
            centers(axis) = column(x(axis, :))
        end do
    end function columns_rows_real64

    function columns_rows_real32(x) result(centers)
        !> (dimension, n); a target of the caller's
        real(c_float), intent(in), target :: x(:, :)
        type(hg_array) :: centers(size(x, 1))

        integer :: axis

        do axis = 1, size(centers)
            centers(axis) = column(x(axis, :))
        end do
    end function columns_rows_real32

    function columns_flat_real64(x, dimension) result(centers)
        !> (dimension*n); a target of the caller's
        real(c_double), intent(in), target :: x(:)
        integer, intent(in) :: dimension
        type(hg_array) :: centers(dimension)

        integer :: axis

        do axis = 1, min(dimension, size(x))
            centers(axis) = column(x(axis::dimension))
        end do
    end function columns_flat_real64

    function columns_flat_real32(x, dimension) result(centers)
        !> (dimension*n); a target of the caller's
        real(c_float), intent(in), target :: x(:)
        integer, intent(in) :: dimension
        type(hg_array) :: centers(dimension)

        integer :: axis

        do axis = 1, min(dimension, size(x))
            centers(axis) = column(x(axis::dimension))
        end do
    end function columns_flat_real32

    function bytes_between(from, to) result(bytes)
        !> Addresses in one array
        type(c_ptr), intent(in) :: from, to
        integer(c_int64_t) :: bytes

        bytes = transfer(to, 0_c_intptr_t) - transfer(from, 0_c_intptr_t)
    end function bytes_between

    !> Whether x, of one or two ranks, and r do not fit together or the grid; then the failure has
    !> been reported. Without a grid there is nothing to compare with.
    function misfit(self, x_shape, r_count, err) result(wrong)
        class(hg_sets), intent(in) :: self
        !> shape(x)
        integer, intent(in) :: x_shape(:)
        !> size(r)
        integer, intent(in) :: r_count
        type(hg_error), intent(out), optional :: err
        logical :: wrong

        character(len=:), allocatable :: d

        wrong = .false.
        if (.not. c_associated(handle_of(self))) return
        wrong = product(int(x_shape, c_int64_t)) /= int(dimension_of(self), c_int64_t)*r_count
        if (size(x_shape) == 2) wrong = wrong .or. x_shape(1) /= dimension_of(self)
        if (.not. wrong) return
        d = number_text(dimension_of(self))
        call raise(HG_ERR_ARGUMENT, 'set: x'//shape_text(x_shape)//' and r'// &
            shape_text([r_count])//' do not fit a grid of dimension '//d//', which takes x('//d// &
            ',n) or x('//d//'*n) and r(n)', err)
    end function misfit

    !> The same of arrays of each axis and of the radii.
    function unequal(self, counts, err) result(wrong)
        class(hg_sets), intent(in) :: self
        !> Sizes of the arrays
        integer, intent(in) :: counts(:)
        type(hg_error), intent(out), optional :: err
        logical :: wrong

        wrong = .false.
        if (.not. c_associated(handle_of(self))) return
        wrong = any(counts /= counts(1)) .or. size(counts) /= dimension_of(self) + 1
        if (.not. wrong) return
        call raise(HG_ERR_ARGUMENT, 'set: arrays of sizes '//shape_text(counts)// &
            ' are not one for each of '//number_text(dimension_of(self))// &
            ' dimensions and one of radii, all equally long', err)
    end function unequal

end module hgrid_sets
