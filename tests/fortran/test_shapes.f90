! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Boxes and triangles among particles, against brute force in whole numbers.
program test_shapes
    use, intrinsic :: iso_c_binding, only: c_double, c_float, c_int32_t, c_int64_t
    use hgrid, only: hg_error, hg_grid, HG_ERR_ARGUMENT, HG_ERR_NULL, HG_ERR_STATE
    use brute_force, only: length_of, rule, scene, scene_name
    use rule_grid, only: make_grid
    use checks, only: check, check_fails, finish_checks
    implicit none

    integer, parameter :: edge = 2**20, n = 250
    integer :: dimension, k

    do dimension = 2, 3
        do k = 0, 3
            call test_boxes(dimension, by_number(k))
        end do
    end do
    do k = 0, 3
        call test_triangles(by_number(k))
    end do
    call test_errors()
    call finish_checks()

contains

    !> With a margin, with touching.
    function by_number(k) result(by)
        !> 0 to 3
        integer, intent(in) :: k
        type(rule) :: by

        by%margin = merge(edge/32, 0, btest(k, 0))
        by%touching = btest(k, 1)
    end function by_number

    !> Around every tenth particle, of coarse numbers so that many touch.
    subroutine test_boxes(dimension, by)
        !> 2 or 3
        integer, intent(in) :: dimension
        !> The rule; its first axis is periodic here
        type(rule), intent(in) :: by

        type(hg_grid) :: grid
        type(scene) :: particles
        type(rule) :: periodic
        integer(c_int64_t), allocatable :: low(:, :), high(:, :)
        integer(c_int64_t), pointer :: offsets(:)
        integer(c_int32_t), pointer :: ids(:)
        integer :: i, k

        call particles%fill(7, dimension, n=n, edge=edge, r_max=edge/8, grain=edge/32)
        periodic = by
        periodic%box(1) = edge
        allocate (high, source=particles%x(:, 1::10))
        allocate (low, source=high - edge/16)
        call make_grid(grid, particles, periodic)
        call grid%query_boxes(length_of(low), length_of(high), offsets, ids)
        call check(size(offsets) == size(low, 2) + 1, 'offsets of query_boxes')
        do k = 1, size(low, 2)
            call check(is_row(ids(offsets(k) + 1:offsets(k + 1)), &
                [(box_meets(particles, i, periodic, low(:, k), high(:, k)), i=1, n)]), &
                'query_boxes; '//scene_name(particles))
        end do
        call grid%query_boxes(real(length_of(low), c_float), real(length_of(high), c_float), &
            offsets, ids)
        call check(size(ids) > n/10, 'query_boxes of real32')
    end subroutine test_boxes

    pure function box_meets(particles, i, by, low, high) result(answer)
        !> The particles
        type(scene), intent(in) :: particles
        !> One of them
        integer, intent(in) :: i
        !> The rule
        type(rule), intent(in) :: by
        !> Corners
        integer(c_int64_t), intent(in) :: low(:), high(:)
        logical :: answer

        integer(c_int64_t) :: gap, square, x
        integer :: axis, image

        square = 0
        do axis = 1, size(low)
            gap = huge(gap)
            do image = -1, 1
                x = particles%x(axis, i) + image*by%box(axis)
                gap = min(gap, max(low(axis) - x, x - high(axis), 0_c_int64_t))
            end do
            square = square + gap**2
        end do
        answer = square == 0 .or. in_reach(square, particles%r(i), by)
    end function box_meets

    pure function in_reach(square, radius, by) result(answer)
        !> Of the distance
        integer(c_int64_t), intent(in) :: square
        !> Of the particle
        integer(c_int64_t), intent(in) :: radius
        !> The rule
        type(rule), intent(in) :: by
        logical :: answer

        answer = square < (radius + by%margin)**2
        if (by%touching) answer = answer .or. square == (radius + by%margin)**2
    end function in_reach

    !> Triangles that cover all particles, so that their planes alone count. Those that touch may be
    !> found in any case.
    subroutine test_triangles(by)
        !> The rule
        type(rule), intent(in) :: by

        type(hg_grid) :: grid
        type(scene) :: particles
        real(c_double) :: corners(3, 3, 20)
        integer(c_int64_t) :: height(20)
        integer(c_int64_t), pointer :: offsets(:)
        integer(c_int32_t), pointer :: ids(:)
        integer :: i, k

        call particles%fill(8, 3, n=n, edge=edge, r_max=edge/8, grain=1)
        height = [(50001_c_int64_t*k, k=1, 20)]
        do k = 1, 20
            corners(:2, :, k) = reshape([real(c_double) :: -8, -8, 24, -8, -8, 24], [2, 3])
            corners(3, :, k) = length_of(height(k))
        end do
        call make_grid(grid, particles, by)
        call grid%query_triangles(corners, offsets, ids)
        call check(size(offsets) == 21, 'offsets of query_triangles')
        do k = 1, 20
            call check(is_row(ids(offsets(k) + 1:offsets(k + 1)), &
                [(in_reach((particles%x(3, i) - height(k))**2, particles%r(i), by), i=1, n)]), &
                'query_triangles; '//scene_name(particles))
        end do
        call grid%query_triangles(real(corners, c_float), offsets, ids)
        call check(size(ids) > n/10, 'query_triangles of real32')
    end subroutine test_triangles

    function is_row(ids, met) result(same)
        !> What was found
        integer(c_int32_t), intent(in) :: ids(:)
        !> Which particles should be
        logical, intent(in) :: met(:)
        logical :: same

        integer :: i

        same = size(ids) == count(met)
        if (same) same = all(ids == pack([(i, i=1, size(met))], met))
    end function is_row

    subroutine test_errors()
        type(hg_grid) :: grid
        type(hg_error) :: err
        type(scene) :: particles
        real(c_double) :: low(3, 2), corners(3, 3, 2)
        integer(c_int64_t), pointer :: offsets(:)
        integer(c_int32_t), pointer :: ids(:)

        low = 0
        corners = 0
        call grid%query_boxes(low, low, offsets, ids, err)
        call check_fails(err, HG_ERR_NULL, 'grid', 'query_boxes without a grid')
        call grid%query_triangles(corners, offsets, ids, err)
        call check_fails(err, HG_ERR_NULL, 'grid', 'query_triangles without a grid')
        call particles%fill(9, 3, n=10, edge=edge, r_max=edge/8, grain=1)
        call make_grid(grid, particles, rule())
        call grid%query_boxes(low(:2, :), low(:2, :), offsets, ids, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'low(2,2) does not fit', 'query_boxes of a plane')
        call grid%query_boxes(low, low(:, :1), offsets, ids, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'low(3,2) and high(3,1)', 'query_boxes, one short')
        call grid%query_boxes(low + 1, low, offsets, ids, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'low(1,1) = 1', 'query_boxes upside down')
        call check(.not. (associated(offsets) .or. associated(ids)), 'rows of a failed query')
        call grid%query_triangles(corners(:2, :, :), offsets, ids, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'corners(2,3,2)', 'query_triangles of a plane')
        call particles%fill(9, 2, n=10, edge=edge, r_max=edge/8, grain=1)
        call make_grid(grid, particles, rule())
        call grid%query_triangles(corners, offsets, ids, err)
        call check_fails(err, HG_ERR_STATE, 'three dimensions', 'query_triangles in a plane')
        call check(.not. (associated(offsets) .or. associated(ids)), 'rows of a failed query')
    end subroutine test_errors

end program test_shapes
