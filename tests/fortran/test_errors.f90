! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> A visitor for a visit that must not happen.
module unwanted_visit
    use, intrinsic :: iso_c_binding, only: c_int32_t
    use checks, only: check
    implicit none
    private

    public :: take_none

contains

    function take_none(pairs) result(answer)
        !> (2, n)
        integer(c_int32_t), intent(in) :: pairs(:, :)
        integer(c_int32_t) :: answer

        call check(size(pairs) < 0, 'a visit that must not happen')
        answer = 0
    end function take_none

end module unwanted_visit

!> Every error that a Fortran program can meet arrives in err, with a message, and changes nothing.
program test_errors
    use, intrinsic :: iso_c_binding, only: c_double, c_float, c_int32_t, c_int64_t
    use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
    use hgrid
    use checks, only: check, check_fails, check_works, finish_checks
    use unwanted_visit, only: take_none
    implicit none

    real(c_double), parameter :: x(3, 2) = reshape([real(c_double) :: 0, 0, 0, 1, 0, 0], [3, 2])
    real(c_double), parameter :: r(2) = [real(c_double) :: 1, 1]

    call test_never_created()
    call test_shapes()
    call test_values()
    call test_ids()
    call test_limit()
    call finish_checks()

contains

    subroutine test_never_created()
        type(hg_grid) :: grid
        type(hg_error) :: err
        type(hg_grid_stats) :: stats
        type(hg_level), pointer :: levels(:)
        type(hg_level_cost), pointer :: costs(:)
        integer(c_int32_t), pointer :: pairs(:, :), ids(:)
        integer(c_int64_t), pointer :: offsets(:)
        integer :: point(3), list(1), count
        character(len=*), parameter :: text = 'not created'

        call grid%insert(x, r, err)
        call check_fails(err, HG_ERR_NULL, 'insert: the grid was not created', 'insert')
        call grid%move(x, err)
        call check_fails(err, HG_ERR_NULL, text, 'move(x)')
        call grid%move(x, r, err)
        call check_fails(err, HG_ERR_NULL, text, 'move(x, r)')
        call grid%remove([1], err)
        call check_fails(err, HG_ERR_NULL, text, 'remove')
        call grid%clear(err)
        call check_fails(err, HG_ERR_NULL, text, 'clear')
        call grid%build(err)
        call check_fails(err, HG_ERR_NULL, text, 'build')
        call grid%query_pairs(pairs, err)
        call check_fails(err, HG_ERR_NULL, text, 'query_pairs')
        call check(.not. associated(pairs), 'pairs of a failed query')
        call grid%visit_pairs(take_none, err)
        call check_fails(err, HG_ERR_NULL, text, 'visit_pairs')
        call grid%query_neighbors(HG_FULL, offsets, ids, err)
        call check_fails(err, HG_ERR_NULL, text, 'query_neighbors')
        call check(.not. (associated(offsets) .or. associated(ids)), 'lists of a failed query')
        call grid%query_neighbors(point, list, count, err)
        call check_fails(err, HG_ERR_NULL, text, 'query_neighbors into arrays')
        call grid%query_sphere(x(:, 1), r(1), ids, err)
        call check_fails(err, HG_ERR_NULL, text, 'query_sphere')
        call grid%query_spheres(x, r, offsets, ids, err)
        call check_fails(err, HG_ERR_NULL, text, 'query_spheres')
        call check(.not. (associated(offsets) .or. associated(ids)), 'rows of a failed query')
        call grid%query_levels(levels, err)
        call check_fails(err, HG_ERR_NULL, text, 'query_levels')
        call check(.not. associated(levels), 'levels of a failed query')
        call grid%query_level_costs(costs, err)
        call check_fails(err, HG_ERR_NULL, text, 'query_level_costs')
        call check(.not. associated(costs), 'costs of a failed query')
        call grid%get_stats(stats, err)
        call check_fails(err, HG_ERR_NULL, text, 'get_stats')
    end subroutine test_never_created

    subroutine test_shapes()
        type(hg_grid) :: grid
        type(hg_error) :: err
        integer(c_int64_t), pointer :: offsets(:)
        integer(c_int32_t), pointer :: ids(:)
        real(c_double), allocatable :: wide(:, :)

        allocate (wide(2, 5), source=0.0_c_double)
        call grid%create()
        call grid%insert(x, [r, 1.0_c_double], err)
        call check_fails(err, HG_ERR_ARGUMENT, 'x(3,2) and r(3)', 'insert')
        call grid%insert(wide, [r, r, 1.0_c_double], err)
        call check_fails(err, HG_ERR_ARGUMENT, 'x(2,5) does not fit a grid of dimension 3', &
            'insert')
        call grid%insert(real(wide, c_float), [real(c_float) :: 1, 1, 1, 1, 1], err)
        call check_fails(err, HG_ERR_ARGUMENT, 'x(2,5) does not fit', 'insert of real32')
        call expect_particles(grid, 0, 'inserts of wrong shape')
        call grid%insert(x, r, err)
        call check_works(err, 'insert after errors')
        call grid%move(transpose(x), err)
        call check_fails(err, HG_ERR_ARGUMENT, 'move: x(2,3)', 'move')
        call grid%move(x(:, :1), err)
        call check_fails(err, HG_ERR_ARGUMENT, 'move', 'move of too few')
        call grid%move(x, r(:1), err)
        call check_fails(err, HG_ERR_ARGUMENT, 'x(3,2) and r(1)', 'move')
        call grid%move(real(x, c_float), real(r(:1), c_float), err)
        call check_fails(err, HG_ERR_ARGUMENT, 'x(3,2) and r(1)', 'move of real32')
        call grid%query_sphere(x(:2, 1), 1.0_c_double, ids, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'center(2) does not fit a grid of dimension 3', &
            'query_sphere')
        call check(.not. associated(ids), 'ids of a failed query')
        call grid%query_spheres(x(:2, :), r, offsets, ids, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'centers(2,2) does not fit a grid of dimension 3', &
            'query_spheres')
        call grid%query_spheres(real(x, c_float), real(r(:1), c_float), offsets, ids, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'centers(3,2) and radii(1) differ', 'query_spheres')
        call check(.not. (associated(offsets) .or. associated(ids)), 'rows of a failed query')
    end subroutine test_shapes

    subroutine expect_particles(grid, expected, what)
        !> The grid
        type(hg_grid), intent(in) :: grid
        !> Number of particles
        integer, intent(in) :: expected
        !> What was tried
        character(len=*), intent(in) :: what

        type(hg_grid_stats) :: stats

        call grid%get_stats(stats)
        call check(stats%particle_count == expected, what//' change nothing')
    end subroutine expect_particles

    subroutine test_values()
        type(hg_grid) :: grid
        type(hg_error) :: err
        real(c_double) :: bad_x(3, 2)
        integer(c_int32_t), pointer :: ids(:)
        integer(c_int64_t), pointer :: offsets(:)

        call grid%create()
        bad_x = x
        bad_x(2, 2) = ieee_value(1.0_c_double, ieee_quiet_nan)
        call grid%insert(bad_x, r, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'centers(2,2) = nan', 'insert of a NaN')
        call grid%insert(x, [1.0_c_double, -0.25_c_double], err)
        call check_fails(err, HG_ERR_ARGUMENT, 'radii(2) = -0.25', 'insert of a negative radius')
        call grid%insert(real(x, c_float), [1.0_c_float, -0.25_c_float], err)
        call check_fails(err, HG_ERR_ARGUMENT, 'radii(2) = -0.25', &
            'insert of a negative real32 radius')
        call expect_particles(grid, 0, 'inserts of bad values')
        call grid%query_sphere(x(:, 1), -0.5_c_double, ids, err)
        call check_fails(err, HG_ERR_ARGUMENT, '-0.5', 'query_sphere of a negative radius')
        call grid%query_spheres(x, [0.5_c_double, -0.5_c_double], offsets, ids, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'radii(2) = -0.5', 'query_spheres')
        call grid%query_neighbors(7, offsets, ids, err)
        call check_fails(err, HG_ERR_ARGUMENT, '7', 'query_neighbors of an unknown list')
    end subroutine test_values

    subroutine test_ids()
        type(hg_grid) :: grid
        type(hg_error) :: err

        call grid%create()
        call grid%insert(x, r)
        call grid%remove([2, 17], err)
        call check_fails(err, HG_ERR_NOT_FOUND, 'ids(2) = 17', 'remove of an unknown id')
        call grid%remove([0], err)
        call check_fails(err, HG_ERR_NOT_FOUND, '0', 'remove of id 0')
        call grid%remove([1, 1], err)
        call check_fails(err, HG_ERR_NOT_FOUND, '1', 'remove of one id twice')
        call expect_particles(grid, 2, 'removes of bad ids')
        call grid%remove([1], err)
        call check_works(err, 'remove')
    end subroutine test_ids

    subroutine test_limit()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(hg_error) :: err
        integer :: i

        def = hg_default_grid_def()
        def%periodic(1) = 1
        def%box_max(1) = 8
        call grid%create(def)
        call grid%insert(1e18_c_double*x, r, err)
        call check_fails(err, HG_ERR_LIMIT, 'insert', 'insert too many boxes away')
        def = hg_default_grid_def()
        call grid%create(def, [(real(i, c_double), i=1, HG_MAX_LEVELS + 1)], err)
        call check_fails(err, HG_ERR_LIMIT, '65', 'create with too many levels')
    end subroutine test_limit

end program test_errors
