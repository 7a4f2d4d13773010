! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> set: all particles anew in each step, from arrays of either kind, any shape and any stride.
program test_sets
    use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
    use hgrid
    use brute_force, only: contact_matrix, difference, length_of, rule, scene, scene_name
    use checks, only: check, check_fails, check_works, finish_checks
    implicit none

    integer, parameter :: most = 300
    integer :: dimension

    do dimension = 2, 3
        call test_shapes(dimension)
        call test_strides(dimension)
        call test_any_count(dimension)
    end do
    call test_stored_candidates()
    call test_errors()
    call finish_checks()

contains

    subroutine make_grid(grid, dimension)
        !> Becomes an empty grid
        type(hg_grid), intent(inout) :: grid
        !> 2 or 3
        integer, intent(in) :: dimension

        type(hg_grid_def) :: def

        def = hg_default_grid_def()
        def%dimension = dimension
        call grid%create(def)
    end subroutine make_grid

    !> The grid must hold the scene; it is emptied, so that the next call cannot lean on it.
    subroutine expect(grid, particles, what)
        type(hg_grid), intent(inout) :: grid
        !> What it should hold
        type(scene), intent(in) :: particles
        !> Named if it does not
        character(len=*), intent(in) :: what

        integer(c_int32_t), pointer :: pairs(:, :)
        character(len=:), allocatable :: text

        call grid%query_pairs(pairs)
        call check(size(pairs, 2) > 0, what//': no pairs')
        text = difference(pairs, contact_matrix(particles, rule()))
        call check(text == '', what//': '//text//'; '//scene_name(particles))
        call grid%clear()
    end subroutine expect

    !> Every combination of kinds, as x(dimension, n), x(dimension*n) and one array for each axis.
    subroutine test_shapes(dimension)
        !> 2 or 3
        integer, intent(in) :: dimension

        type(hg_grid) :: grid
        type(scene) :: particles
        real(c_double), allocatable :: x(:, :), r(:), a(:), b(:), c(:)
        real(c_float), allocatable :: xs(:, :), rs(:), as(:), bs(:), cs(:)

        call particles%fill(seed=5, dimension=dimension, n=most, edge=2**20, r_max=2**18, grain=2**10)
        x = length_of(particles%x)
        r = length_of(particles%r)
        xs = real(x, c_float)
        rs = real(r, c_float)
        a = x(1, :)
        b = x(2, :)
        c = x(dimension, :)
        as = real(a, c_float)
        bs = real(b, c_float)
        cs = real(c, c_float)
        call make_grid(grid, dimension)
        call grid%set(x, r)
        call expect(grid, particles, 'rows')
        call grid%set(xs, rs)
        call expect(grid, particles, 'real32 rows')
        call grid%set(x, rs)
        call expect(grid, particles, 'real64 rows, real32 radii')
        call grid%set(xs, r)
        call expect(grid, particles, 'real32 rows, real64 radii')
        call grid%set(reshape(x, [size(x)]), r)
        call expect(grid, particles, 'flat')
        call grid%set(reshape(xs, [size(x)]), rs)
        call expect(grid, particles, 'real32 flat')
        call grid%set(reshape(x, [size(x)]), rs)
        call expect(grid, particles, 'real64 flat, real32 radii')
        call grid%set(reshape(xs, [size(x)]), r)
        call expect(grid, particles, 'real32 flat, real64 radii')
        if (dimension == 2) then
            call grid%set(a, b, r)
            call expect(grid, particles, 'plane')
            call grid%set(as, bs, rs)
            call expect(grid, particles, 'real32 plane')
            call grid%set(a, b, rs)
            call expect(grid, particles, 'real64 plane, real32 radii')
            call grid%set(as, bs, r)
            call expect(grid, particles, 'real32 plane, real64 radii')
        else
            call grid%set(a, b, c, r)
            call expect(grid, particles, 'columns')
            call grid%set(as, bs, cs, rs)
            call expect(grid, particles, 'real32 columns')
            call grid%set(a, b, c, rs)
            call expect(grid, particles, 'real64 columns, real32 radii')
            call grid%set(as, bs, cs, r)
            call expect(grid, particles, 'real32 columns, real64 radii')
        end if
    end subroutine test_shapes

    !> Sections of tables, also backwards; what lies between them must not be read.
    subroutine test_strides(dimension)
        !> 2 or 3
        integer, intent(in) :: dimension

        type(hg_grid) :: grid
        type(scene) :: particles
        real(c_double) :: table(4, 2*most)
        real(c_float) :: single(4, 2*most)

        call particles%fill(seed=6, dimension=dimension, n=most, edge=2**20, r_max=2**18, grain=2**10)
        table = huge(table)
        table(:dimension, 1::2) = length_of(particles%x)
        table(4, 1::2) = length_of(particles%r)
        single = huge(single)
        single(:dimension, 2*most:2:-2) = real(length_of(particles%x), c_float)
        single(4, 2*most:2:-2) = real(length_of(particles%r), c_float)
        call make_grid(grid, dimension)
        call grid%set(table(:dimension, 1::2), table(4, 1::2))
        call expect(grid, particles, 'a section')
        call grid%set(single(:dimension, 2*most:2:-2), table(4, 1::2))
        call expect(grid, particles, 'a section backwards')
        if (dimension == 2) then
            call grid%set(table(1, 1::2), table(2, 1::2), single(4, 2*most:2:-2))
        else
            call grid%set(single(1, 2*most:2:-2), single(2, 2*most:2:-2), single(3, 2*most:2:-2), &
                table(4, 1::2))
        end if
        call expect(grid, particles, 'rows of tables')
    end subroutine test_strides

    !> More, fewer and no particles from step to step; ids count from 1.
    subroutine test_any_count(dimension)
        !> 2 or 3
        integer, intent(in) :: dimension

        integer, parameter :: counts(6) = [100, 300, 0, 1, 299, 2]
        type(hg_grid) :: grid
        type(hg_error) :: err
        type(hg_grid_stats) :: stats
        type(scene) :: particles
        integer(c_int32_t), pointer :: pairs(:, :)
        integer :: k

        call make_grid(grid, dimension)
        do k = 1, size(counts)
            call particles%fill(seed=6 + k, dimension=dimension, n=counts(k), edge=2**20, &
                r_max=2**18, grain=1)
            call grid%set(length_of(particles%x), length_of(particles%r), err)
            call check_works(err, 'set')
            call grid%get_stats(stats)
            call check(stats%particle_count == counts(k), 'as many particles as given')
            call grid%query_pairs(pairs)
            call check(difference(pairs, contact_matrix(particles, rule())) == '', 'any count')
            call grid%set(reshape(real(length_of(particles%x), c_float), [size(particles%x)]), &
                real(length_of(particles%r), c_float), err)
            call check_works(err, 'set of real32')
        end do
    end subroutine test_any_count

    !> The same number and radii: filtered, not searched.
    subroutine test_stored_candidates()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(hg_grid_stats) :: stats
        integer(c_int32_t), pointer :: pairs(:, :)
        real(c_double) :: x(3, 2) = reshape([real(c_double) :: 0, 0, 0, 1, 0, 0], [3, 2])
        real(c_double) :: r(2) = 0.6_c_double

        def = hg_default_grid_def()
        def%skin = 0.2_c_double
        call grid%create(def)
        call grid%set(x, r)
        call grid%query_pairs(pairs)
        call grid%set(x(1, :), x(2, :), x(3, :), r)
        call grid%query_pairs(pairs)
        call grid%get_stats(stats)
        call check(stats%search_count == 1 .and. stats%filter_count == 1, 'candidates stay in use')
    end subroutine test_stored_candidates

    subroutine test_errors()
        type(hg_grid) :: grid
        type(hg_error) :: err
        real(c_double) :: x(3, 2), r(2), none(0)
        real(c_float) :: rs(2)

        x = 0
        r = 1
        rs = 1
        call grid%set(x, r, err)
        call check_fails(err, HG_ERR_NULL, 'set: the grid was not created', 'set(x, r)')
        call grid%set(x, rs, err)
        call check_fails(err, HG_ERR_NULL, 'not created', 'set(x, r) of two kinds')
        call grid%set(none, none, err)
        call check_fails(err, HG_ERR_NULL, 'not created', 'set flat')
        call grid%set(x(1, :), x(2, :), x(3, :), r, err)
        call check_fails(err, HG_ERR_NULL, 'not created', 'set(x, y, z, r)')
        call grid%create()
        call grid%set(x(:2, :), r, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'x(2,2) and r(2) do not fit', 'a plane in space')
        call grid%set(x, r(:1), err)
        call check_fails(err, HG_ERR_ARGUMENT, 'x(3,2) and r(1) do not fit', 'fewer radii')
        call grid%set(x, rs(:1), err)
        call check_fails(err, HG_ERR_ARGUMENT, 'x(3,2) and r(1) do not fit', 'fewer radii of real32')
        call grid%set([x(:, 1), 0.0_c_double], r, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'x(4) and r(2) do not fit', 'flat, too short')
        call grid%set([x(:, 1), 0.0_c_double], rs, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'x(4) and r(2) do not fit', 'flat, of two kinds')
        call grid%set(x(1, :), x(2, :), r, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'sizes (2,2,2)', 'two axes in space')
        call grid%set(x(1, :), x(2, :), x(3, :1), r, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'sizes (2,2,1,2)', 'a short axis')
        rs(2) = -0.5
        call grid%set(x, rs, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'set: radii(2) = -0.5 is negative', 'a bad radius')
        x(2, 1) = ieee_value(x(2, 1), ieee_quiet_nan)
        call grid%set(x(1, :), x(2, :), x(3, :), r, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'centers(2,1) = nan', 'a bad centre')
        call grid%set(none, none, none, none, err)
        call check_works(err, 'set of nothing')
    end subroutine test_errors

end program test_sets
