! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> What Fortran programs use: the grid as a type with its calls.
!>
!> Each call takes an optional last argument err; without it a failure prints its message and stops
!> the program. Ids start at 1 unless the definition says otherwise. Pointers that queries return
!> show memory of the grid, without a copy: read them before the next call that changes the grid or
!> asks for the same kind of result.
module hgrid
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_float, c_int, c_int32_t, &
        c_int64_t, c_loc, c_null_ptr, c_ptr, c_sizeof
    use hgrid_c, only: c_hg_create, c_hg_destroy, c_hg_get_stats, c_hg_grid_def_init, &
        c_hg_version, hg_grid_def, hg_grid_stats, hg_level, hg_level_cost, HG_CONTACT, HG_DOUBLE, &
        HG_ERR_ARGUMENT, HG_ERR_CAPACITY, HG_ERR_INTERNAL, HG_ERR_LIMIT, HG_ERR_MEMORY, &
        HG_ERR_NOT_FOUND, HG_ERR_NULL, HG_ERR_STATE, HG_EXACT, HG_FLOAT, HG_FULL, HG_HALF, &
        HG_LEVELS_AUTO, HG_LEVELS_PAPER, HG_LEVELS_USER, HG_MAX_LEVELS, HG_MAX_RANGE, HG_OK, &
        HG_ORDER_GRID, HG_ORDER_ID
    use hgrid_error, only: hg_error, hg_status_string, number_text, raise, settle, shape_text
    use hgrid_history, only: hg_history
    use hgrid_visit, only: hg_pair_procedure, hg_pair_visitor
    implicit none
    private

    public :: hg_default_grid_def, hg_error, hg_grid, hg_grid_def, hg_grid_stats, hg_history
    public :: hg_level, hg_level_cost, hg_pair_procedure, hg_pair_visitor, hg_status_string, hg_version
    public :: HG_OK, HG_ERR_NULL, HG_ERR_ARGUMENT, HG_ERR_MEMORY, HG_ERR_CAPACITY, HG_ERR_STATE
    public :: HG_ERR_NOT_FOUND, HG_ERR_LIMIT, HG_ERR_INTERNAL
    public :: HG_CONTACT, HG_MAX_RANGE, HG_EXACT, HG_DOUBLE, HG_FLOAT, HG_ORDER_GRID, HG_ORDER_ID
    public :: HG_LEVELS_AUTO, HG_LEVELS_PAPER, HG_LEVELS_USER, HG_HALF, HG_FULL, HG_MAX_LEVELS
    ! Kinds that declarations of arguments need, so that `use hgrid` is enough.
    public :: c_double, c_float, c_int32_t, c_int64_t

    !> A grid: particles, and the search for pairs among them. It frees itself when it goes out of
    !> scope.
    type :: hg_grid
        private
        type(c_ptr) :: handle = c_null_ptr
        integer :: dimension = 0
    contains
        private
        procedure :: create_default, create_def, create_sizes
        procedure :: insert_real64, insert_real32
        procedure :: move_real64, move_radii_real64, move_real32, move_radii_real32
        procedure :: query_sphere_real64, query_sphere_real32
        procedure :: visit_pairs_object, visit_pairs_procedure
        procedure :: conclude, misfit
        procedure, pass(self) :: refuse_copy
        !> create(), create(def), create(def, cell_sizes): an empty grid; a former one is destroyed
        generic, public :: create => create_default, create_def, create_sizes
        procedure, public :: destroy
        !> insert(x, r): x(dimension, n), r(n), real32 or real64
        generic, public :: insert => insert_real64, insert_real32
        !> move(x), move(x, r): all live particles, by ascending id
        generic, public :: move => move_real64, move_radii_real64, move_real32, move_radii_real32
        procedure, public :: remove
        procedure, public :: clear
        procedure, public :: build
        procedure, public :: query_pairs
        !> visit_pairs(visit), visit_pairs(visitor): a function, or an object that extends
        !> hg_pair_visitor
        generic, public :: visit_pairs => visit_pairs_procedure, visit_pairs_object
        procedure, public :: query_neighbors
        !> query_sphere(center, radius, ids): the particles that a sphere overlaps
        generic, public :: query_sphere => query_sphere_real64, query_sphere_real32
        procedure, public :: query_levels
        procedure, public :: query_level_costs
        procedure, public :: get_stats
        generic, public :: assignment(=) => refuse_copy
        final :: finish
    end type hg_grid

    interface
        module subroutine insert_real64(self, x, r, err)
            !> The grid
            class(hg_grid), intent(inout) :: self
            !> Centres (dimension, n)
            real(c_double), intent(in), contiguous :: x(:, :)
            !> Radii (n), >= 0
            real(c_double), intent(in), contiguous :: r(:)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine insert_real64

        module subroutine insert_real32(self, x, r, err)
            !> The grid
            class(hg_grid), intent(inout) :: self
            !> Centres (dimension, n)
            real(c_float), intent(in) :: x(:, :)
            !> Radii (n), >= 0
            real(c_float), intent(in) :: r(:)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine insert_real32

        module subroutine move_real64(self, x, err)
            !> The grid
            class(hg_grid), intent(inout) :: self
            !> Centres (dimension, n) of all live particles, by ascending id
            real(c_double), intent(in), contiguous :: x(:, :)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine move_real64

        module subroutine move_radii_real64(self, x, r, err)
            !> The grid
            class(hg_grid), intent(inout) :: self
            !> Centres (dimension, n) of all live particles, by ascending id
            real(c_double), intent(in), contiguous :: x(:, :)
            !> Radii (n), >= 0
            real(c_double), intent(in), contiguous :: r(:)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine move_radii_real64

        module subroutine move_real32(self, x, err)
            !> The grid
            class(hg_grid), intent(inout) :: self
            !> Centres (dimension, n) of all live particles, by ascending id
            real(c_float), intent(in) :: x(:, :)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine move_real32

        module subroutine move_radii_real32(self, x, r, err)
            !> The grid
            class(hg_grid), intent(inout) :: self
            !> Centres (dimension, n) of all live particles, by ascending id
            real(c_float), intent(in) :: x(:, :)
            !> Radii (n), >= 0
            real(c_float), intent(in) :: r(:)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine move_radii_real32

        !> Removes particles; their ids are not given out again before clear.
        module subroutine remove(self, ids, err)
            !> The grid
            class(hg_grid), intent(inout) :: self
            !> The particles to remove, each once
            integer(c_int32_t), intent(in), contiguous :: ids(:)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine remove

        !> Removes all particles; ids start anew.
        module subroutine clear(self, err)
            !> The grid
            class(hg_grid), intent(inout) :: self
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine clear

        !> Makes the grid ready, so that several threads may query it; queries call it when they
        !> must.
        module subroutine build(self, err)
            !> The grid
            class(hg_grid), intent(inout) :: self
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine build

        !> All pairs, each once, pairs(1, k) < pairs(2, k), in the order of def%pair_order.
        module subroutine query_pairs(self, pairs, err)
            !> The grid
            class(hg_grid), intent(in) :: self
            !> (2, count), ids; memory of the grid
            integer(c_int32_t), pointer, intent(out) :: pairs(:, :)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine query_pairs

        !> Hands all pairs to a function, in batches.
        module subroutine visit_pairs_procedure(self, visit, err)
            !> The grid
            class(hg_grid), intent(in) :: self
            !> Returns 0 to go on, anything else to end the visit; must not call the grid
            procedure(hg_pair_procedure) :: visit
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine visit_pairs_procedure

        !> Hands all pairs to an object, in batches.
        module subroutine visit_pairs_object(self, visitor, err)
            !> The grid
            class(hg_grid), intent(in) :: self
            !> Its procedure visit returns 0 to go on, anything else to end the visit
            class(hg_pair_visitor), intent(inout) :: visitor
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine visit_pairs_object

        !> Neighbour lists in compressed rows: those of the k-th live particle in ascending id are
        !> neighbors(offsets(k) + 1:offsets(k + 1)), ascending.
        module subroutine query_neighbors(self, list, offsets, neighbors, err)
            !> The grid
            class(hg_grid), intent(in) :: self
            !> HG_HALF: only greater ids; HG_FULL: all
            integer(c_int32_t), intent(in) :: list
            !> (n + 1), starts with 0; memory of the grid
            integer(c_int64_t), pointer, intent(out) :: offsets(:)
            !> (offsets(n + 1)), ids; memory of the grid
            integer(c_int32_t), pointer, intent(out) :: neighbors(:)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine query_neighbors

        !> The particles that a sphere overlaps, by the grid's own rule; ids ascending, borrowed
        !> until this thread's next query_sphere.
        module subroutine query_sphere_real64(self, center, radius, ids, err)
            !> The grid
            class(hg_grid), intent(in) :: self
            !> (dimension)
            real(c_double), intent(in), contiguous :: center(:)
            !> >= 0
            real(c_double), intent(in) :: radius
            !> (count); memory of the library
            integer(c_int32_t), pointer, intent(out) :: ids(:)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine query_sphere_real64

        module subroutine query_sphere_real32(self, center, radius, ids, err)
            !> The grid
            class(hg_grid), intent(in) :: self
            !> (dimension)
            real(c_float), intent(in) :: center(:)
            !> >= 0
            real(c_float), intent(in) :: radius
            !> (count); memory of the library
            integer(c_int32_t), pointer, intent(out) :: ids(:)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine query_sphere_real32

        !> The levels as they stand, finest first.
        module subroutine query_levels(self, levels, err)
            !> The grid
            class(hg_grid), intent(in) :: self
            !> (count); memory of the grid
            type(hg_level), pointer, intent(out) :: levels(:)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine query_levels

        !> The predicted cost of each number of levels that the rule looked at.
        module subroutine query_level_costs(self, costs, err)
            !> The grid
            class(hg_grid), intent(in) :: self
            !> (count), empty for HG_LEVELS_USER; memory of the grid
            type(hg_level_cost), pointer, intent(out) :: costs(:)
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine query_level_costs

        !> The counters of the grid as built and of the last search.
        module subroutine get_stats(self, stats, err)
            !> The grid
            class(hg_grid), intent(in) :: self
            !> A copy
            type(hg_grid_stats), intent(out) :: stats
            !> Absent and failing: the program stops
            type(hg_error), intent(out), optional :: err
        end subroutine get_stats
    end interface

contains

    !> The defaults of the library, but ids that start at 1.
    function hg_default_grid_def() result(def)
        type(hg_grid_def) :: def

        call settle(c_hg_grid_def_init(def, c_sizeof(def)), 'hg_default_grid_def')
        def%index_base = 1
    end function hg_default_grid_def

    !> The version of the library that is loaded.
    subroutine hg_version(major, minor, patch)
        !> Raised by an incompatible release
        integer, intent(out) :: major
        !> Raised by a release with new features
        integer, intent(out) :: minor
        !> Raised by a release that only corrects
        integer, intent(out) :: patch

        integer(c_int) :: numbers(3)

        call c_hg_version(numbers(1), numbers(2), numbers(3))
        major = numbers(1)
        minor = numbers(2)
        patch = numbers(3)
    end subroutine hg_version

    subroutine create_default(self, err)
        !> The grid
        class(hg_grid), intent(inout) :: self
        !> Absent and failing: the program stops
        type(hg_error), intent(out), optional :: err

        call self%create_def(hg_default_grid_def(), err)
    end subroutine create_default

    !> The new grid is made before the former one is destroyed: a failure leaves the former one as
    !> it was.
    subroutine create_def(self, def, err)
        !> The grid
        class(hg_grid), intent(inout) :: self
        !> How it works
        type(hg_grid_def), intent(in) :: def
        !> Absent and failing: the program stops
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: created
        integer(c_int32_t) :: status

        status = c_hg_create(def, created)
        if (status == HG_OK) then
            status = release(self%handle)
            if (status == HG_OK) then
                self%handle = created
                self%dimension = def%dimension
            else
                call c_hg_destroy(created)
            end if
        end if
        call settle(status, 'create', err)
    end subroutine create_def

    !> As create(def), with the levels of HG_LEVELS_USER whatever def says of them.
    subroutine create_sizes(self, def, cell_sizes, err)
        !> The grid
        class(hg_grid), intent(inout) :: self
        !> How it works
        type(hg_grid_def), intent(in) :: def
        !> Cell edges, ascending, the last at least the largest diameter plus margin; copied
        real(c_double), intent(in), contiguous, target :: cell_sizes(:)
        !> Absent and failing: the program stops
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
        !> The grid
        class(hg_grid), intent(inout) :: self
        !> Absent and failing: the program stops
        type(hg_error), intent(out), optional :: err

        integer(c_int32_t) :: status

        status = release(self%handle)
        if (status == HG_OK) self%handle = c_null_ptr
        call settle(status, 'destroy', err)
    end subroutine destroy

    !> Destroys a C grid unless one of its visitors is at work. hg_destroy cannot tell, reading the
    !> counters can.
    function release(handle) result(status)
        !> The C grid; null is fine
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t) :: status

        type(hg_grid_stats) :: stats

        status = HG_OK
        if (.not. c_associated(handle)) return
        status = c_hg_get_stats(handle, stats, c_sizeof(stats))
        if (status == HG_OK) call c_hg_destroy(handle)
    end function release

    impure elemental subroutine finish(self)
        !> The grid
        type(hg_grid), intent(inout) :: self

        call c_hg_destroy(self%handle)
        self%handle = c_null_ptr
    end subroutine finish

    !> Two copies would free the same memory twice; only grids that were never created may be
    !> assigned.
    impure elemental subroutine refuse_copy(left, self)
        !> Left side of the assignment
        class(hg_grid), intent(inout) :: left
        !> Right side of the assignment
        class(hg_grid), intent(in) :: self

        if (c_associated(left%handle) .or. c_associated(self%handle)) then
            call raise(HG_ERR_STATE, 'an hg_grid cannot be copied: pass it as an argument instead')
        end if
    end subroutine refuse_copy

    !> Ends a call on the C grid.
    subroutine conclude(self, status, caller, err)
        !> The grid
        class(hg_grid), intent(in) :: self
        !> What the C call returned
        integer(c_int32_t), intent(in) :: status
        !> Name of the Fortran call
        character(len=*), intent(in) :: caller
        !> Absent and failing: the program stops
        type(hg_error), intent(out), optional :: err

        if (c_associated(self%handle)) then
            call settle(status, caller, err)
        else
            call raise(HG_ERR_NULL, caller//': the grid was not created, call create first', err)
        end if
    end subroutine conclude

    !> Why x and r do not fit together or the grid; empty if they do, or if there is no grid to
    !> compare with.
    function misfit(self, x_shape, r_count) result(fault)
        !> The grid
        class(hg_grid), intent(in) :: self
        !> shape(x)
        integer, intent(in) :: x_shape(2)
        !> size(r)
        integer, intent(in) :: r_count
        character(len=:), allocatable :: fault

        fault = ''
        if (.not. c_associated(self%handle)) return
        if (x_shape(1) /= self%dimension) then
            fault = 'x'//shape_text(x_shape)//' does not fit a grid of dimension '// &
                number_text(self%dimension)//', whose centres are x('// &
                number_text(self%dimension)//',n)'
        else if (x_shape(2) /= r_count) then
            fault = 'x'//shape_text(x_shape)//' and r'//shape_text([r_count])// &
                ' differ in the number of particles'
        end if
    end function misfit

end module hgrid
