! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Groups, absent particles and bodies: of all pairs those that may be, and errors.
program test_groups
    use hgrid
    use brute_force, only: contact_matrix, difference, length_of, rule, scene, scene_name
    use checks, only: check, check_fails, check_works, finish_checks
    implicit none

    integer, parameter :: n = 400, edge = 2**20
    integer :: dimension

    do dimension = 2, 3
        call test_company(dimension)
    end do
    call test_errors()
    call finish_checks()

contains

    !> Groups 0 to 2 and absent ones in turns, of which two do not meet; bodies of five.
    subroutine test_company(dimension)
        !> 2 or 3
        integer, intent(in) :: dimension

        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(hg_error) :: err
        type(scene) :: particles
        integer(c_int32_t), pointer :: pairs(:, :)
        integer(c_int32_t) :: groups(n), bodies(n)
        logical, allocatable :: meets(:, :)
        integer :: i, j

        call particles%fill(seed=11, dimension=dimension, n=n, edge=edge, r_max=edge/6, grain=1)
        do i = 1, n
            groups(i) = int(mod(i, 4) - 1, c_int32_t)
            bodies(i) = int(i/5, c_int32_t)
        end do
        bodies(1::7) = -1
        def = hg_default_grid_def()
        def%dimension = dimension
        call grid%create(def)
        call grid%set(length_of(particles%x), length_of(particles%r))

        meets = contact_matrix(particles, rule())
        call grid%set_groups(groups, err)
        call check_works(err, 'set_groups')
        call grid%set_group_pair(1, 1, .false., err)
        call check_works(err, 'set_group_pair')
        call grid%set_group_pair(2, 0, .false.)
        do j = 1, n
            do i = 1, n
                if (min(groups(i), groups(j)) < 0) meets(i, j) = .false.
                if (groups(i) == 1 .and. groups(j) == 1) meets(i, j) = .false.
                if (groups(i) + groups(j) == 2 .and. groups(i) /= 1) meets(i, j) = .false.
            end do
        end do
        call grid%query_pairs(pairs)
        call check(size(pairs, 2) > 0, 'some pairs are left by groups')
        call check(difference(pairs, meets) == '', 'pairs of groups; '//scene_name(particles))

        call grid%set_bodies(bodies, err)
        call check_works(err, 'set_bodies')
        do j = 1, n
            do i = 1, n
                if (bodies(i) == bodies(j) .and. bodies(i) >= 0) meets(i, j) = .false.
            end do
        end do
        call grid%query_pairs(pairs)
        call check(difference(pairs, meets) == '', 'pairs of bodies; '//scene_name(particles))
        call grid%set_group_pair(2, 0, .true.)
        call grid%set_group_pair(1, 1, .true.)
        call grid%set_groups(spread(0_c_int32_t, 1, n))
        call grid%set_bodies(spread(-1_c_int32_t, 1, n))
        call grid%query_pairs(pairs)
        call check(difference(pairs, contact_matrix(particles, rule())) == '', 'all pairs again')
    end subroutine test_company

    subroutine test_errors()
        type(hg_grid) :: grid, never_created
        type(hg_error) :: err
        integer(c_int32_t) :: bad(2)

        call grid%create()
        call grid%set(reshape([0.0_c_double, 0.0_c_double, 0.0_c_double, 1.0_c_double, &
            0.0_c_double, 0.0_c_double], [3, 2]), [1.0_c_double, 1.0_c_double])
        bad = [0_c_int32_t, HG_MAX_GROUPS]
        call grid%set_groups(bad, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'groups(2) = 64', 'a group that is none')
        call grid%set_groups(bad(:1), err)
        call check_fails(err, HG_ERR_ARGUMENT, 'count is 1', 'too few groups')
        call grid%set_group_pair(0, -1, .true., err)
        call check_fails(err, HG_ERR_ARGUMENT, 'group_b = -1', 'a pair with no group')
        bad = [-2_c_int32_t, 0_c_int32_t]
        call grid%set_bodies(bad, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'bodies(1) = -2', 'a body that is none')
        call never_created%set_groups(bad, err)
        call check_fails(err, HG_ERR_NULL, 'set_groups', 'groups without a grid')
    end subroutine test_errors

end program test_groups
