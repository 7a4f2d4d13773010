! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The calls that change which particles a grid holds, where they are, and the box around them.
module hgrid_particles
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_float, c_int32_t, c_ptr, &
        c_size_t
    use hgrid_error, only: hg_error, number_text, raise, shape_text
    use hgrid_handle, only: conclude, dimension_of, handle_of, hg_handle
    use hgrid_types, only: HG_ERR_ARGUMENT, HG_ERR_MEMORY
    implicit none
    private

    public :: c_hg_build, c_hg_clear, c_hg_insert, c_hg_move, c_hg_remove, c_hg_set_box
    public :: hg_particles

    !> A grid that is filled and made ready.
    type, extends(hg_handle) :: hg_particles
    contains
        private
        procedure :: insert_real64, insert_real32
        procedure :: move_real64, move_radii_real64, move_real32, move_radii_real32
        !> insert(x, r): x(dimension, n), r(n), real32 or real64
        generic, public :: insert => insert_real64, insert_real32
        !> move(x), move(x, r): all live particles, by ascending id
        generic, public :: move => move_real64, move_radii_real64, move_real32, move_radii_real32
        procedure :: set_box_real64, set_tilted_box_real64, set_box_real32, set_tilted_box_real32
        !> set_box(box_min, box_max), set_box(box_min, box_max, tilt): three values each, also in 2D
        generic, public :: set_box => set_box_real64, set_tilted_box_real64, set_box_real32, &
            set_tilted_box_real32
        procedure, public :: remove
        procedure, public :: clear
        procedure, public :: build
    end type hg_particles

    interface
        function c_hg_insert(grid, count, centers, radii) bind(c, name='hg_insert') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> (dimension, count)
            real(c_double), intent(in) :: centers(*)
            !> (count)
            real(c_double), intent(in) :: radii(*)
            integer(c_int32_t) :: status
        end function c_hg_insert

        function c_hg_move(grid, count, centers, radii) bind(c, name='hg_move') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> (dimension, count)
            real(c_double), intent(in) :: centers(*)
            !> (count); absent leaves the radii as they are
            real(c_double), intent(in), optional :: radii(*)
            integer(c_int32_t) :: status
        end function c_hg_move

        function c_hg_remove(grid, count, ids) bind(c, name='hg_remove') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> The particles to remove
            integer(c_int32_t), intent(in) :: ids(*)
            integer(c_int32_t) :: status
        end function c_hg_remove

        function c_hg_clear(grid) bind(c, name='hg_clear') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_int32_t) :: status
        end function c_hg_clear

        function c_hg_set_box(grid, box_min, box_max, tilt) bind(c, name='hg_set_box') &
            result(status)
            import
            type(c_ptr), value :: grid
            !> Lower corner; open axes are not read
            real(c_double), intent(in) :: box_min(3)
            !> Upper corner
            real(c_double), intent(in) :: box_max(3)
            !> xy, xz, yz; absent means none
            real(c_double), intent(in), optional :: tilt(3)
            integer(c_int32_t) :: status
        end function c_hg_set_box

        function c_hg_build(grid) bind(c, name='hg_build') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_int32_t) :: status
        end function c_hg_build
    end interface

contains

    subroutine insert_real64(self, x, r, err)
        class(hg_particles), intent(inout) :: self
        !> Centres (dimension, n)
        real(c_double), intent(in), contiguous :: x(:, :)
        !> Radii (n), >= 0
        real(c_double), intent(in), contiguous :: r(:)
        type(hg_error), intent(out), optional :: err

        if (misfit(self, 'insert', shape(x), size(r), err)) return
        call conclude(self, c_hg_insert(handle_of(self), size(r, kind=c_size_t), x, r), &
            'insert', err)
    end subroutine insert_real64

    subroutine insert_real32(self, x, r, err)
        class(hg_particles), intent(inout) :: self
        !> Centres (dimension, n)
        real(c_float), intent(in) :: x(:, :)
        !> Radii (n), >= 0
        real(c_float), intent(in) :: r(:)
        type(hg_error), intent(out), optional :: err

        real(c_double), allocatable :: x64(:, :), r64(:)

        if (widened('insert', x, r, x64, r64, err)) call self%insert_real64(x64, r64, err)
    end subroutine insert_real32

    subroutine move_real64(self, x, err)
        class(hg_particles), intent(inout) :: self
        !> Centres (dimension, n) of all live particles, by ascending id
        real(c_double), intent(in), contiguous :: x(:, :)
        type(hg_error), intent(out), optional :: err

        if (misfit(self, 'move', shape(x), size(x, 2), err)) return
        call conclude(self, c_hg_move(handle_of(self), size(x, 2, kind=c_size_t), x), 'move', err)
    end subroutine move_real64

    subroutine move_radii_real64(self, x, r, err)
        class(hg_particles), intent(inout) :: self
        !> Centres (dimension, n) of all live particles, by ascending id
        real(c_double), intent(in), contiguous :: x(:, :)
        !> Radii (n), >= 0
        real(c_double), intent(in), contiguous :: r(:)
        type(hg_error), intent(out), optional :: err

        if (misfit(self, 'move', shape(x), size(r), err)) return
        call conclude(self, c_hg_move(handle_of(self), size(r, kind=c_size_t), x, r), 'move', err)
    end subroutine move_radii_real64

    subroutine move_real32(self, x, err)
        class(hg_particles), intent(inout) :: self
        !> Centres (dimension, n) of all live particles, by ascending id
        real(c_float), intent(in) :: x(:, :)
        type(hg_error), intent(out), optional :: err

        real(c_double), allocatable :: x64(:, :)
        integer :: stat

        allocate (x64(size(x, 1), size(x, 2)), stat=stat)
        if (stat /= 0) then
            call raise(HG_ERR_MEMORY, 'move: no memory for x as real64', err)
            return
        end if
        x64 = real(x, c_double)
        call self%move_real64(x64, err)
    end subroutine move_real32

    subroutine move_radii_real32(self, x, r, err)
        class(hg_particles), intent(inout) :: self
        !> Centres (dimension, n) of all live particles, by ascending id
        real(c_float), intent(in) :: x(:, :)
        !> Radii (n), >= 0
        real(c_float), intent(in) :: r(:)
        type(hg_error), intent(out), optional :: err

        real(c_double), allocatable :: x64(:, :), r64(:)

        if (widened('move', x, r, x64, r64, err)) call self%move_radii_real64(x64, r64, err)
    end subroutine move_radii_real32

    subroutine set_box_real64(self, box_min, box_max, err)
        class(hg_particles), intent(inout) :: self
        !> Lower and upper corner (3)
        real(c_double), intent(in), contiguous :: box_min(:), box_max(:)
        type(hg_error), intent(out), optional :: err

        call set_any_box(self, box_min, box_max, err=err)
    end subroutine set_box_real64

    subroutine set_tilted_box_real64(self, box_min, box_max, tilt, err)
        class(hg_particles), intent(inout) :: self
        !> Lower and upper corner (3)
        real(c_double), intent(in), contiguous :: box_min(:), box_max(:)
        !> xy, xz, yz
        real(c_double), intent(in), contiguous :: tilt(:)
        type(hg_error), intent(out), optional :: err

        call set_any_box(self, box_min, box_max, tilt, err)
    end subroutine set_tilted_box_real64

    subroutine set_box_real32(self, box_min, box_max, err)
        class(hg_particles), intent(inout) :: self
        !> Lower and upper corner (3)
        real(c_float), intent(in) :: box_min(:), box_max(:)
        type(hg_error), intent(out), optional :: err

        call set_any_box(self, real(box_min, c_double), real(box_max, c_double), err=err)
    end subroutine set_box_real32

    subroutine set_tilted_box_real32(self, box_min, box_max, tilt, err)
        class(hg_particles), intent(inout) :: self
        !> Lower and upper corner (3)
        real(c_float), intent(in) :: box_min(:), box_max(:)
        !> xy, xz, yz
        real(c_float), intent(in) :: tilt(:)
        type(hg_error), intent(out), optional :: err

        call set_any_box(self, real(box_min, c_double), real(box_max, c_double), &
            real(tilt, c_double), err)
    end subroutine set_tilted_box_real32

    !> Gives a periodic grid a new box; particles stay where they are.
    subroutine set_any_box(self, box_min, box_max, tilt, err)
        class(hg_particles), intent(in) :: self
        !> Lower and upper corner (3); values of open axes do not count
        real(c_double), intent(in), contiguous :: box_min(:), box_max(:)
        !> xy, xz, yz; absent means none
        real(c_double), intent(in), contiguous, optional :: tilt(:)
        type(hg_error), intent(out), optional :: err

        integer :: tilts

        tilts = 3
        if (present(tilt)) tilts = size(tilt)
        if (any([size(box_min), size(box_max), tilts] /= 3)) then
            call raise(HG_ERR_ARGUMENT, 'set_box: box_min'//shape_text(shape(box_min))// &
                ', box_max'//shape_text(shape(box_max))//' and tilt'//shape_text([tilts])// &
                ' must hold three values each, also in two dimensions', err)
            return
        end if
        call conclude(self, c_hg_set_box(handle_of(self), box_min, box_max, tilt), 'set_box', err)
    end subroutine set_any_box

    !> Removes particles; their ids are not given out again before clear.
    subroutine remove(self, ids, err)
        class(hg_particles), intent(inout) :: self
        !> The particles to remove, each once
        integer(c_int32_t), intent(in), contiguous :: ids(:)
        type(hg_error), intent(out), optional :: err

        call conclude(self, c_hg_remove(handle_of(self), size(ids, kind=c_size_t), ids), &
            'remove', err)
    end subroutine remove

    !> Removes all particles; ids start anew.
    subroutine clear(self, err)
        class(hg_particles), intent(inout) :: self
        type(hg_error), intent(out), optional :: err

        call conclude(self, c_hg_clear(handle_of(self)), 'clear', err)
    end subroutine clear

    !> Makes the grid ready, so that several threads may query it; queries call it when they
    !> must.
    subroutine build(self, err)
        class(hg_particles), intent(inout) :: self
        type(hg_error), intent(out), optional :: err

        call conclude(self, c_hg_build(handle_of(self)), 'build', err)
    end subroutine build

    !> Whether x and r do not fit together or the grid; then the failure has been reported. Without
    !> a grid there is nothing to compare with.
    function misfit(self, caller, x_shape, r_count, err) result(wrong)
        class(hg_particles), intent(in) :: self
        !> Name of the Fortran call
        character(len=*), intent(in) :: caller
        !> shape(x)
        integer, intent(in) :: x_shape(2)
        !> size(r)
        integer, intent(in) :: r_count
        type(hg_error), intent(out), optional :: err
        logical :: wrong

        character(len=:), allocatable :: fault

        fault = ''
        wrong = .false.
        if (.not. c_associated(handle_of(self))) return
        if (x_shape(1) /= dimension_of(self)) then
            fault = 'x'//shape_text(x_shape)//' does not fit a grid of dimension '// &
                number_text(dimension_of(self))//', whose centres are x('// &
                number_text(dimension_of(self))//',n)'
        else if (x_shape(2) /= r_count) then
            fault = 'x'//shape_text(x_shape)//' and r'//shape_text([r_count])// &
                ' differ in the number of particles'
        end if
        wrong = len(fault) > 0
        if (wrong) call raise(HG_ERR_ARGUMENT, caller//': '//fault, err)
    end function misfit

    !> Makes real64 of real32. False: there was no memory for it, and the failure has been reported.
    function widened(caller, x, r, x64, r64, err) result(done)
        !> Name of the Fortran call
        character(len=*), intent(in) :: caller
        real(c_float), intent(in) :: x(:, :), r(:)
        real(c_double), intent(out), allocatable :: x64(:, :), r64(:)
        type(hg_error), intent(out), optional :: err
        logical :: done

        integer :: stat

        allocate (x64(size(x, 1), size(x, 2)), r64(size(r)), stat=stat)
        done = stat == 0
        if (done) then
            x64 = real(x, c_double)
            r64 = real(r, c_double)
        else
            call raise(HG_ERR_MEMORY, caller//': no memory for x and r as real64', err)
        end if
    end function widened

end module hgrid_particles
