! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The C grid that a Fortran grid stands for: its making, its end, and how calls on it end.
module hgrid_handle
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_int32_t, c_loc, &
        c_ptr, c_size_t, c_sizeof
    use hgrid_error, only: hg_error, number_text, raise, refuse_copies, settle, settle_on
    use hgrid_owner, only: disown, hg_owner, own, owned
    use hgrid_types, only: c_hg_grid_def_init, c_hg_version, hg_grid_def, hg_grid_stats, &
        HG_ERR_ARGUMENT, HG_ERR_STATE, HG_LEVELS_USER, HG_OK, HG_VERSION_MAJOR, HG_VERSION_MINOR
    implicit none
    private

    public :: c_hg_create, c_hg_destroy, c_hg_get_stats
    public :: conclude, dimension_of, handle_of, hg_default_grid_def, hg_handle

    !> Owns the C grid and frees it when it goes out of scope.
    type :: hg_handle
        private
        ! First, so that its place is that of the whole.
        integer :: dimension = 0
        type(hg_owner), allocatable :: owner
    contains
        private
        procedure :: create_default, create_def, create_sizes
        procedure, pass(self) :: refuse_copy
        !> create(), create(def), create(def, cell_sizes): an empty grid; a former one is destroyed
        generic, public :: create => create_default, create_def, create_sizes
        procedure, public :: destroy
        generic, public :: assignment(=) => refuse_copy
    end type hg_handle

    interface
        function c_hg_create(def, grid) bind(c, name='hg_create') result(status)
            import
            !> Absent means the defaults
            type(hg_grid_def), intent(in), optional :: def
            !> The new grid; null on failure
            type(c_ptr), intent(out) :: grid
            integer(c_int32_t) :: status
        end function c_hg_create

        subroutine c_hg_destroy(grid) bind(c, name='hg_destroy')
            import
            !> Null is fine
            type(c_ptr), value :: grid
        end subroutine c_hg_destroy

        function c_hg_get_stats(grid, stats, struct_size) bind(c, name='hg_get_stats') &
            result(status)
            import
            type(c_ptr), value :: grid
            !> The counters
            type(hg_grid_stats), intent(inout) :: stats
            integer(c_size_t), value :: struct_size
            integer(c_int32_t) :: status
        end function c_hg_get_stats
    end interface

contains

    !> The defaults of the library, but ids that start at 1.
    function hg_default_grid_def() result(def)
        type(hg_grid_def) :: def

        call settle(c_hg_grid_def_init(def, c_sizeof(def)), 'hg_default_grid_def')
        def%index_base = 1
    end function hg_default_grid_def

    subroutine create_default(self, err)
        class(hg_handle), intent(inout) :: self
        type(hg_error), intent(out), optional :: err

        call self%create_def(hg_default_grid_def(), err)
    end subroutine create_default

    !> The new grid is made before the former one is destroyed: a failure leaves the former one as
    !> it was.
    subroutine create_def(self, def, err)
        class(hg_handle), intent(inout) :: self
        !> How it works
        type(hg_grid_def), intent(in) :: def
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: created
        integer(c_int32_t) :: status
        integer(c_int) :: loaded(3)

        call c_hg_version(loaded(1), loaded(2), loaded(3))
        ! Structs of another version may have other members; from 1.0 on they only grow.
        if (loaded(1) /= HG_VERSION_MAJOR .or. loaded(2) < HG_VERSION_MINOR .or. &
            (HG_VERSION_MAJOR == 0 .and. loaded(2) /= HG_VERSION_MINOR)) then
            call raise(HG_ERR_STATE, 'create: module hgrid has version '// &
                version_text(HG_VERSION_MAJOR, HG_VERSION_MINOR)//', the library that is loaded '// &
                version_text(loaded(1), loaded(2)), err)
            return
        end if
        status = c_hg_create(def, created)
        if (status == HG_OK) then
            status = release(self)
            if (status == HG_OK) then
                call own(self%owner, created, c_hg_destroy)
                self%dimension = def%dimension
            else
                call c_hg_destroy(created)
            end if
        end if
        call settle(status, 'create', err)
    end subroutine create_def

    function version_text(major, minor) result(text)
        !> Of the version
        integer(c_int), intent(in) :: major, minor
        character(len=:), allocatable :: text

        text = number_text(int(major))//'.'//number_text(int(minor))
    end function version_text

    !> As create(def), with the levels of HG_LEVELS_USER whatever def says of them.
    subroutine create_sizes(self, def, cell_sizes, err)
        class(hg_handle), intent(inout) :: self
        !> How it works
        type(hg_grid_def), intent(in) :: def
        !> Cell edges, ascending, the last at least the largest diameter plus margin; copied
        real(c_double), intent(in), contiguous, target :: cell_sizes(:)
        type(hg_error), intent(out), optional :: err

        type(hg_grid_def) :: with_sizes

        if (size(cell_sizes) == 0) then
            call raise(HG_ERR_ARGUMENT, 'create: cell_sizes is empty', err)
            return
        end if
        with_sizes = def
        with_sizes%level_rule = HG_LEVELS_USER
        with_sizes%level_count = size(cell_sizes, kind=c_int32_t)
        with_sizes%cell_sizes = c_loc(cell_sizes)
        call self%create_def(with_sizes, err)
    end subroutine create_sizes

    !> Frees the grid and all it lent; a grid that was never created is fine.
    subroutine destroy(self, err)
        class(hg_handle), intent(inout) :: self
        type(hg_error), intent(out), optional :: err

        call settle(release(self), 'destroy', err)
    end subroutine destroy

    !> Destroys the C grid unless one of its visitors is at work. hg_destroy cannot tell, reading
    !> the counters can.
    function release(self) result(status)
        class(hg_handle), intent(inout) :: self
        integer(c_int32_t) :: status

        type(hg_grid_stats) :: stats

        status = HG_OK
        if (c_associated(handle_of(self))) then
            status = c_hg_get_stats(handle_of(self), stats, c_sizeof(stats))
        end if
        if (status == HG_OK) call disown(self%owner)
    end function release

    !> Only objects that were never created may be assigned. A left side that is allocatable and not
    !> allocated stands nowhere, and must not be looked into.
    impure elemental subroutine refuse_copy(left, self)
        class(hg_handle), intent(inout), target :: left
        class(hg_handle), intent(in) :: self

        if (c_associated(c_loc(left%dimension))) then
            if (.not. (c_associated(handle_of(left)) .or. c_associated(handle_of(self)))) return
        end if
        call refuse_copies('grid')
    end subroutine refuse_copy

    !> The C grid; null before create, and in a copy of the object, to which it does not belong.
    function handle_of(self) result(handle)
        class(hg_handle), intent(in) :: self
        type(c_ptr) :: handle

        handle = owned(self%owner)
    end function handle_of

    !> 2 or 3; 0 before create.
    pure function dimension_of(self) result(dimension)
        class(hg_handle), intent(in) :: self
        integer :: dimension

        dimension = self%dimension
    end function dimension_of

    !> Ends a call on the C grid.
    subroutine conclude(self, status, caller, err)
        class(hg_handle), intent(in) :: self
        !> What the C call returned
        integer(c_int32_t), intent(in) :: status
        !> Name of the Fortran call
        character(len=*), intent(in) :: caller
        type(hg_error), intent(out), optional :: err

        call settle_on('grid', handle_of(self), status, caller, err)
    end subroutine conclude

end module hgrid_handle
