! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The C interface of libhgrid as Fortran sees it: types, constants and calls of the C headers,
!> nothing else.
!>
!> Programs use module hgrid; this one serves those who need a call as C has it, such as the
!> allocator hooks. Members stand in the order of the C structs; the test struct_layout compares
!> sizes and offsets.
module hgrid_c
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_int32_t, c_int64_t, &
        c_null_funptr, c_null_ptr, c_ptr, c_size_t
    implicit none
    private

    public :: hg_allocator, hg_grid_def, hg_grid_stats, hg_level, hg_level_cost, hg_pair
    public :: c_hg_build, c_hg_clear, c_hg_create, c_hg_destroy, c_hg_get_stats, c_hg_grid_def_init
    public :: c_hg_history_carry, c_hg_history_clear, c_hg_history_create, c_hg_history_destroy
    public :: c_hg_history_pairs, c_hg_history_restore, c_hg_history_update
    public :: c_hg_insert, c_hg_last_error, c_hg_move, c_hg_query_level_costs, c_hg_query_levels
    public :: c_hg_query_neighbors, c_hg_query_pairs, c_hg_query_sphere, c_hg_remove
    public :: c_hg_set_allocator, c_hg_status_string, c_hg_version, c_hg_visit_pairs

    !> Status codes.
    integer(c_int32_t), parameter, public :: HG_OK = 0
    integer(c_int32_t), parameter, public :: HG_ERR_NULL = 1
    integer(c_int32_t), parameter, public :: HG_ERR_ARGUMENT = 2
    integer(c_int32_t), parameter, public :: HG_ERR_MEMORY = 3
    integer(c_int32_t), parameter, public :: HG_ERR_CAPACITY = 4
    integer(c_int32_t), parameter, public :: HG_ERR_STATE = 5
    integer(c_int32_t), parameter, public :: HG_ERR_NOT_FOUND = 6
    integer(c_int32_t), parameter, public :: HG_ERR_LIMIT = 7
    integer(c_int32_t), parameter, public :: HG_ERR_INTERNAL = 8

    !> hg_grid_def%interaction: |xi - xj| < ri + rj + margin, or < max(ri, rj) + margin.
    integer(c_int32_t), parameter, public :: HG_CONTACT = 0
    integer(c_int32_t), parameter, public :: HG_MAX_RANGE = 1

    !> hg_grid_def%accuracy: decided as real arithmetic does, as plain doubles do, or never missing
    !> a pair.
    integer(c_int32_t), parameter, public :: HG_EXACT = 0
    integer(c_int32_t), parameter, public :: HG_DOUBLE = 1
    integer(c_int32_t), parameter, public :: HG_FLOAT = 2

    !> hg_grid_def%pair_order: as found (fastest), or ascending by both ids.
    integer(c_int32_t), parameter, public :: HG_ORDER_GRID = 0
    integer(c_int32_t), parameter, public :: HG_ORDER_ID = 1

    !> hg_grid_def%level_rule: chosen for this library, as the paper does, or given by the user.
    integer(c_int32_t), parameter, public :: HG_LEVELS_AUTO = 0
    integer(c_int32_t), parameter, public :: HG_LEVELS_PAPER = 1
    integer(c_int32_t), parameter, public :: HG_LEVELS_USER = 2

    !> Neighbour lists: every pair in the row of its smaller id, or in both rows.
    integer(c_int32_t), parameter, public :: HG_HALF = 0
    integer(c_int32_t), parameter, public :: HG_FULL = 1

    !> The most levels that a grid can have.
    integer(c_int32_t), parameter, public :: HG_MAX_LEVELS = 64

    !> Two particles that interact, by their ids; a < b.
    type, bind(c) :: hg_pair
        integer(c_int32_t) :: a, b
    end type hg_pair

    !> How a grid works. Start from hg_default_grid_def(), then change what you need.
    !> The default of struct_size marks a definition that nobody filled: creating a grid with it is
    !> an error.
    type, bind(c) :: hg_grid_def
        integer(c_int32_t) :: struct_size = 0
        integer(c_int32_t) :: dimension = 0
        integer(c_int32_t) :: thread_count = 0
        integer(c_int32_t) :: index_base = 0
        integer(c_int32_t) :: interaction = 0
        integer(c_int32_t) :: accuracy = 0
        integer(c_int32_t) :: pair_order = 0
        integer(c_int32_t) :: level_rule = 0
        integer(c_int32_t) :: level_count = 0
        integer(c_int32_t) :: reserved0 = 0
        type(c_ptr) :: cell_sizes = c_null_ptr
        real(c_double) :: margin = 0.0_c_double
        real(c_double) :: skin = 0.0_c_double
        integer(c_int32_t) :: periodic(3) = 0
        integer(c_int32_t) :: reserved1 = 0
        real(c_double) :: box_min(3) = 0.0_c_double
        real(c_double) :: box_max(3) = 0.0_c_double
        real(c_double) :: cell_overhead = 0.0_c_double
        real(c_double) :: level_price = 0.0_c_double
        real(c_double) :: row_price = 0.0_c_double
    end type hg_grid_def

    !> One level of the grid as it stands.
    type, bind(c) :: hg_level
        real(c_double) :: cell_size
        real(c_double) :: largest_radius
        real(c_double) :: occupancy
        integer(c_int64_t) :: particle_count
    end type hg_level

    !> What the level rule expects of level_count levels; reachable is 0 or 1.
    type, bind(c) :: hg_level_cost
        integer(c_int32_t) :: level_count
        integer(c_int32_t) :: reachable
        real(c_double) :: occupancy
        real(c_double) :: cost
    end type hg_level_cost

    !> Counters of a grid: as built, and of its last search or filtering of stored candidates.
    type, bind(c) :: hg_grid_stats
        integer(c_int64_t) :: particle_count = 0
        integer(c_int64_t) :: level_count = 0
        integer(c_int64_t) :: row_count = 0
        integer(c_int64_t) :: cell_count = 0
        integer(c_int64_t) :: candidate_count = 0
        integer(c_int64_t) :: undecided_count = 0
        integer(c_int64_t) :: exact_count = 0
        integer(c_int64_t) :: pair_count = 0
        integer(c_int64_t) :: build_count = 0
        integer(c_int64_t) :: search_count = 0
        integer(c_int64_t) :: byte_count = 0
        integer(c_int64_t) :: filter_count = 0
        integer(c_int64_t) :: stored_count = 0
    end type hg_grid_stats

    !> Where grids take their memory from: C functions as described in hgrid/base.h.
    type, bind(c) :: hg_allocator
        type(c_ptr) :: context = c_null_ptr
        type(c_funptr) :: allocate = c_null_funptr
        type(c_funptr) :: reallocate = c_null_funptr
        type(c_funptr) :: release = c_null_funptr
    end type hg_allocator

    interface
        function c_hg_status_string(status) bind(c, name='hg_status_string') result(text)
            import :: c_int32_t, c_ptr
            !> A status code
            integer(c_int32_t), value :: status
            type(c_ptr) :: text
        end function c_hg_status_string

        function c_hg_last_error() bind(c, name='hg_last_error') result(text)
            import :: c_ptr
            type(c_ptr) :: text
        end function c_hg_last_error

        subroutine c_hg_version(major, minor, patch) bind(c, name='hg_version')
            import :: c_int
            !> Raised by an incompatible release
            integer(c_int), intent(out) :: major
            !> Raised by a release with new features
            integer(c_int), intent(out) :: minor
            !> Raised by a release that only corrects
            integer(c_int), intent(out) :: patch
        end subroutine c_hg_version

        function c_hg_set_allocator(allocator) bind(c, name='hg_set_allocator') result(status)
            import :: c_int32_t, hg_allocator
            !> Absent restores malloc
            type(hg_allocator), intent(in), optional :: allocator
            integer(c_int32_t) :: status
        end function c_hg_set_allocator

        function c_hg_grid_def_init(def, struct_size) bind(c, name='hg_grid_def_init') &
            result(status)
            import :: c_int32_t, c_size_t, hg_grid_def
            !> Filled with the defaults
            type(hg_grid_def), intent(out) :: def
            !> c_sizeof(def)
            integer(c_size_t), value :: struct_size
            integer(c_int32_t) :: status
        end function c_hg_grid_def_init

        function c_hg_create(def, grid) bind(c, name='hg_create') result(status)
            import :: c_int32_t, c_ptr, hg_grid_def
            !> Absent means the defaults
            type(hg_grid_def), intent(in), optional :: def
            !> The new grid; null on failure
            type(c_ptr), intent(out) :: grid
            integer(c_int32_t) :: status
        end function c_hg_create

        subroutine c_hg_destroy(grid) bind(c, name='hg_destroy')
            import :: c_ptr
            !> Null is fine
            type(c_ptr), value :: grid
        end subroutine c_hg_destroy

        function c_hg_insert(grid, count, centers, radii) bind(c, name='hg_insert') result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            !> The grid
            type(c_ptr), value :: grid
            !> Number of particles
            integer(c_size_t), value :: count
            !> (dimension, count)
            real(c_double), intent(in) :: centers(*)
            !> (count)
            real(c_double), intent(in) :: radii(*)
            integer(c_int32_t) :: status
        end function c_hg_insert

        function c_hg_move(grid, count, centers, radii) bind(c, name='hg_move') result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            !> The grid
            type(c_ptr), value :: grid
            !> Number of live particles
            integer(c_size_t), value :: count
            !> (dimension, count)
            real(c_double), intent(in) :: centers(*)
            !> (count); absent leaves the radii as they are
            real(c_double), intent(in), optional :: radii(*)
            integer(c_int32_t) :: status
        end function c_hg_move

        function c_hg_remove(grid, count, ids) bind(c, name='hg_remove') result(status)
            import :: c_int32_t, c_ptr, c_size_t
            !> The grid
            type(c_ptr), value :: grid
            !> Number of ids
            integer(c_size_t), value :: count
            !> The particles to remove
            integer(c_int32_t), intent(in) :: ids(*)
            integer(c_int32_t) :: status
        end function c_hg_remove

        function c_hg_clear(grid) bind(c, name='hg_clear') result(status)
            import :: c_int32_t, c_ptr
            !> The grid
            type(c_ptr), value :: grid
            integer(c_int32_t) :: status
        end function c_hg_clear

        function c_hg_build(grid) bind(c, name='hg_build') result(status)
            import :: c_int32_t, c_ptr
            !> The grid
            type(c_ptr), value :: grid
            integer(c_int32_t) :: status
        end function c_hg_build

        function c_hg_query_pairs(grid, pairs, count) bind(c, name='hg_query_pairs') result(status)
            import :: c_int32_t, c_ptr, c_size_t
            !> The grid
            type(c_ptr), value :: grid
            !> hg_pair[count], borrowed
            type(c_ptr), intent(out) :: pairs
            !> Number of pairs
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_query_pairs

        function c_hg_visit_pairs(grid, visit, context) bind(c, name='hg_visit_pairs') &
            result(status)
            import :: c_funptr, c_int32_t, c_ptr
            !> The grid
            type(c_ptr), value :: grid
            !> An hg_pair_visitor: int32_t (*)(void *context, const hg_pair *pairs, size_t count)
            type(c_funptr), value :: visit
            !> Handed to the visitor
            type(c_ptr), value :: context
            integer(c_int32_t) :: status
        end function c_hg_visit_pairs

        function c_hg_query_neighbors(grid, list, offsets, neighbors) &
            bind(c, name='hg_query_neighbors') result(status)
            import :: c_int32_t, c_ptr
            !> The grid
            type(c_ptr), value :: grid
            !> HG_HALF or HG_FULL
            integer(c_int32_t), value :: list
            !> int64_t[N + 1], borrowed
            type(c_ptr), intent(out) :: offsets
            !> int32_t[offsets[N]], borrowed
            type(c_ptr), intent(out) :: neighbors
            integer(c_int32_t) :: status
        end function c_hg_query_neighbors

        function c_hg_query_sphere(grid, center, radius, ids, count) &
            bind(c, name='hg_query_sphere') result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            !> The grid
            type(c_ptr), value :: grid
            !> (dimension)
            real(c_double), intent(in) :: center(*)
            !> Radius of the sphere
            real(c_double), value :: radius
            !> int32_t[count], borrowed
            type(c_ptr), intent(out) :: ids
            !> Number of ids
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_query_sphere

        function c_hg_query_levels(grid, levels, count) bind(c, name='hg_query_levels') &
            result(status)
            import :: c_int32_t, c_ptr, c_size_t
            !> The grid
            type(c_ptr), value :: grid
            !> hg_level[count], borrowed
            type(c_ptr), intent(out) :: levels
            !> Number of levels
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_query_levels

        function c_hg_query_level_costs(grid, costs, count) &
            bind(c, name='hg_query_level_costs') result(status)
            import :: c_int32_t, c_ptr, c_size_t
            !> The grid
            type(c_ptr), value :: grid
            !> hg_level_cost[count], borrowed
            type(c_ptr), intent(out) :: costs
            !> Number of entries
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_query_level_costs

        function c_hg_get_stats(grid, stats, struct_size) bind(c, name='hg_get_stats') &
            result(status)
            import :: c_int32_t, c_ptr, c_size_t, hg_grid_stats
            !> The grid
            type(c_ptr), value :: grid
            !> The counters
            type(hg_grid_stats), intent(inout) :: stats
            !> c_sizeof(stats)
            integer(c_size_t), value :: struct_size
            integer(c_int32_t) :: status
        end function c_hg_get_stats

        function c_hg_history_create(history) bind(c, name='hg_history_create') result(status)
            import :: c_int32_t, c_ptr
            !> The new history, null on failure
            type(c_ptr), intent(out) :: history
            integer(c_int32_t) :: status
        end function c_hg_history_create

        subroutine c_hg_history_destroy(history) bind(c, name='hg_history_destroy')
            import :: c_ptr
            !> The history; null is fine
            type(c_ptr), value :: history
        end subroutine c_hg_history_destroy

        function c_hg_history_update(history, count, pairs, previous) &
            bind(c, name='hg_history_update') result(status)
            import :: c_int32_t, c_ptr, c_size_t
            !> The history
            type(c_ptr), value :: history
            !> Number of pairs
            integer(c_size_t), value :: count
            !> hg_pair[count]
            type(c_ptr), value :: pairs
            !> int64_t[count], borrowed: places from 0, -1 for pairs that are new
            type(c_ptr), intent(out) :: previous
            integer(c_int32_t) :: status
        end function c_hg_history_update

        function c_hg_history_carry(history, item_size, old_items, new_items) &
            bind(c, name='hg_history_carry') result(status)
            import :: c_int32_t, c_ptr, c_size_t
            !> The history
            type(c_ptr), value :: history
            !> Bytes for one contact
            integer(c_size_t), value :: item_size
            !> One item for each pair of the list before
            type(c_ptr), value :: old_items
            !> One item for each pair of the last list
            type(c_ptr), value :: new_items
            integer(c_int32_t) :: status
        end function c_hg_history_carry

        function c_hg_history_pairs(history, pairs, count) bind(c, name='hg_history_pairs') &
            result(status)
            import :: c_int32_t, c_ptr, c_size_t
            !> The history
            type(c_ptr), value :: history
            !> hg_pair[count], borrowed
            type(c_ptr), intent(out) :: pairs
            !> Number of pairs
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_history_pairs

        function c_hg_history_restore(history, count, pairs) bind(c, name='hg_history_restore') &
            result(status)
            import :: c_int32_t, c_ptr, c_size_t
            !> The history
            type(c_ptr), value :: history
            !> Number of pairs
            integer(c_size_t), value :: count
            !> hg_pair[count]
            type(c_ptr), value :: pairs
            integer(c_int32_t) :: status
        end function c_hg_history_restore

        function c_hg_history_clear(history) bind(c, name='hg_history_clear') result(status)
            import :: c_int32_t, c_ptr
            !> The history
            type(c_ptr), value :: history
            integer(c_int32_t) :: status
        end function c_hg_history_clear
    end interface

end module hgrid_c
