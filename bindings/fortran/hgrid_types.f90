! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The headers base.h and types.h as Fortran sees them: constants, structs, and the calls that
!> concern no grid.
!>
!> Members stand in the order of the C structs; the test struct_layout compares sizes and offsets.
module hgrid_types
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_int32_t, c_int64_t, &
        c_null_funptr, c_null_ptr, c_ptr, c_size_t
    implicit none
    private

    public :: hg_allocator, hg_array, hg_contact_batch, hg_grid_def, hg_grid_stats, hg_level
    public :: hg_level_cost, hg_pair
    public :: c_hg_grid_def_init, c_hg_last_error, c_hg_set_allocator, c_hg_status_string
    public :: c_hg_version

    !> The version of this module; hg_version tells that of the library that is loaded.
    integer(c_int), parameter, public :: HG_VERSION_MAJOR = 1
    integer(c_int), parameter, public :: HG_VERSION_MINOR = 0
    integer(c_int), parameter, public :: HG_VERSION_PATCH = 0

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
    integer(c_int32_t), parameter, public :: HG_ERR_MPI = 9
    integer(c_int32_t), parameter, public :: HG_ERR_REMOTE = 10

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

    !> hg_grid_def%images: two particles are a pair once at most, by their nearest images, or once for
    !> each image in reach, also of a particle with itself.
    integer(c_int32_t), parameter, public :: HG_NEAREST_IMAGE = 0
    integer(c_int32_t), parameter, public :: HG_ALL_IMAGES = 1

    !> Neighbour lists: every pair in the row of its smaller id, or in both rows.
    integer(c_int32_t), parameter, public :: HG_HALF = 0
    integer(c_int32_t), parameter, public :: HG_FULL = 1

    !> The most levels that a grid can have.
    integer(c_int32_t), parameter, public :: HG_MAX_LEVELS = 64
    integer(c_int32_t), parameter, public :: HG_MAX_GROUPS = 64

    !> hg_array%type: the numbers of an array.
    integer(c_int32_t), parameter, public :: HG_REAL64 = 0
    integer(c_int32_t), parameter, public :: HG_REAL32 = 1

    !> The most contacts in a batch.
    integer(c_int32_t), parameter, public :: HG_MAX_BATCH = 1024

    !> Two particles that interact, by their ids; a < b, or with HG_ALL_IMAGES a <= b.
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
        real(c_double) :: tilt(3) = 0.0_c_double
        integer(c_int32_t) :: touching = 0
        integer(c_int32_t) :: images = HG_NEAREST_IMAGE
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

    !> One number of each particle, wherever it lies: stride bytes from one to the next.
    type, bind(c) :: hg_array
        type(c_ptr) :: data = c_null_ptr
        integer(c_int64_t) :: stride = 0
        integer(c_int32_t) :: type = HG_REAL64
        integer(c_int32_t) :: reserved = 0
    end type hg_array

    !> Contacts with their geometry: arrays of count numbers each; dz is null in 2D.
    type, bind(c) :: hg_contact_batch
        integer(c_size_t) :: count = 0
        type(c_ptr) :: a = c_null_ptr
        type(c_ptr) :: b = c_null_ptr
        type(c_ptr) :: dx = c_null_ptr
        type(c_ptr) :: dy = c_null_ptr
        type(c_ptr) :: dz = c_null_ptr
        type(c_ptr) :: reach = c_null_ptr
    end type hg_contact_batch

    !> Where grids take their memory from: C functions as described in hgrid/base.h.
    type, bind(c) :: hg_allocator
        type(c_ptr) :: context = c_null_ptr
        type(c_funptr) :: allocate = c_null_funptr
        type(c_funptr) :: reallocate = c_null_funptr
        type(c_funptr) :: release = c_null_funptr
    end type hg_allocator

    interface
        function c_hg_status_string(status) bind(c, name='hg_status_string') result(text)
            import
            !> A status code
            integer(c_int32_t), value :: status
            type(c_ptr) :: text
        end function c_hg_status_string

        function c_hg_last_error() bind(c, name='hg_last_error') result(text)
            import
            type(c_ptr) :: text
        end function c_hg_last_error

        subroutine c_hg_version(major, minor, patch) bind(c, name='hg_version')
            import
            !> Raised by an incompatible release
            integer(c_int), intent(out) :: major
            !> Raised by a release with new features
            integer(c_int), intent(out) :: minor
            !> Raised by a release that only corrects
            integer(c_int), intent(out) :: patch
        end subroutine c_hg_version

        function c_hg_set_allocator(allocator) bind(c, name='hg_set_allocator') result(status)
            import
            !> Absent restores malloc
            type(hg_allocator), intent(in), optional :: allocator
            integer(c_int32_t) :: status
        end function c_hg_set_allocator

        function c_hg_grid_def_init(def, struct_size) bind(c, name='hg_grid_def_init') &
            result(status)
            import
            !> Filled with the defaults
            type(hg_grid_def), intent(out) :: def
            integer(c_size_t), value :: struct_size
            integer(c_int32_t) :: status
        end function c_hg_grid_def_init
    end interface

end module hgrid_types
