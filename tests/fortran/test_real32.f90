! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Single precision: the grid works on the exact double value of each real32.
program test_real32
    use, intrinsic :: iso_c_binding, only: c_double, c_float, c_int32_t, c_int64_t
    use hgrid, only: hg_default_grid_def, hg_grid, hg_grid_def
    use brute_force, only: contact_matrix, difference, length_of, rule, scene, scene_name
    use checks, only: check, finish_checks
    implicit none

    integer, parameter :: n = 300
    integer :: dimension

    do dimension = 2, 3
        call test_calls(dimension)
    end do
    call test_rounding()
    call finish_checks()

contains

    subroutine test_calls(dimension)
        !> 2 or 3
        integer, intent(in) :: dimension

        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(scene) :: particles
        real(c_float) :: table(4, 2*n)
        integer(c_int64_t), pointer :: offsets(:)
        integer(c_int32_t), pointer :: ids(:)

        call particles%fill(seed=7, dimension=dimension, n=n, edge=2**20, r_max=2**17, grain=2**10)
        def = hg_default_grid_def()
        def%dimension = dimension
        call grid%create(def)
        call grid%insert(real(length_of(particles%x), c_float), &
            real(length_of(particles%r), c_float))
        call expect_pairs(grid, particles, 'insert')

        call particles%shake(2**16)
        table(:dimension, 1::2) = real(length_of(particles%x), c_float)
        call grid%move(table(:dimension, 1::2))
        call expect_pairs(grid, particles, 'move(x)')

        call particles%shake(2**15)
        particles%r = particles%r(n:1:-1)
        table(:dimension, 1::2) = real(length_of(particles%x), c_float)
        table(4, 1::2) = real(length_of(particles%r), c_float)
        call grid%move(table(:dimension, 1::2), table(4, 1::2))
        call expect_pairs(grid, particles, 'move(x, r)')

        call grid%query_sphere(table(:dimension, 1), 0.0_c_float, ids)
        call check(any(ids == 1) .or. table(4, 1) <= 0, 'query_sphere finds who is there')
        call grid%query_spheres(table(:dimension, 1:3:2), table(4, 1:3:2), offsets, ids)
        call check(any(ids(:offsets(2)) == 1) .and. any(ids(offsets(2) + 1:) == 2), &
            'query_spheres finds who is there')
    end subroutine test_calls

    subroutine expect_pairs(grid, particles, what)
        !> The grid
        type(hg_grid), intent(in) :: grid
        !> Its particles
        type(scene), intent(in) :: particles
        !> What was done
        character(len=*), intent(in) :: what

        integer(c_int32_t), pointer :: pairs(:, :)
        character(len=:), allocatable :: text

        call grid%query_pairs(pairs)
        text = difference(pairs, contact_matrix(particles, rule()))
        call check(text == '', 'real32 '//what//': '//text//'; '//scene_name(particles))
    end subroutine expect_pairs

    !> The nearest real32 of 0.1 is above 0.1: as doubles the first two overlap and the others do
    !> not.
    subroutine test_rounding()
        type(hg_grid) :: grid
        integer(c_int32_t), pointer :: pairs(:, :)
        real(c_float) :: x(3, 2)
        real(c_double) :: y(3, 2)

        x = 0
        x(1, 2) = 0.125_c_float
        call grid%create()
        call grid%insert(x, [0.1_c_float, 0.025_c_float])
        call grid%query_pairs(pairs)
        call check(size(pairs, 2) == merge(1, 0, &
            real(0.1_c_float, c_double) + real(0.025_c_float, c_double) > 0.125_c_double), &
            'real32 radii are not rounded again')
        call grid%clear()
        y = real(x, c_double)
        call grid%insert(y, [0.1_c_double - epsilon(y), 0.025_c_double])
        call grid%query_pairs(pairs)
        call check(size(pairs, 2) == 0, 'real64 radii just too small')
    end subroutine test_rounding

end program test_real32
