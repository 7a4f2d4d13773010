! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Periodic cells: tilted, touching spheres, a box that changes, and all images.
program test_boxes
    use, intrinsic :: iso_c_binding, only: c_double, c_float, c_int32_t, c_int64_t
    use hgrid
    use brute_force, only: contact_matrix, difference, length_of, rule, scene, scene_name
    use rule_grid, only: make_grid
    use checks, only: check, check_fails, check_works, finish_checks
    implicit none

    integer, parameter :: edge = 2**20
    integer, parameter :: dimensions(2) = [2, 3]
    real(c_double), parameter :: nowhere(3) = 0, unit_box(3) = 1
    integer :: k

    do k = 1, size(dimensions)
        call test_tilt(dimensions(k), seed=11 + k)
        call test_changes(dimensions(k), seed=21 + k)
    end do
    call test_all_images()
    call test_refusals()
    call finish_checks()

contains

    !> A tilted definition, with touching spheres counted and not.
    subroutine test_tilt(dimension, seed)
        !> 2 or 3
        integer, intent(in) :: dimension
        !> Of the scene
        integer, intent(in) :: seed

        type(hg_grid) :: grid
        type(scene) :: particles
        type(rule) :: by
        integer :: found(0:1), touching

        call particles%fill(seed, dimension, n=150, edge=edge, r_max=edge/8, grain=edge/32)
        by = tilted_rule(dimension, [edge/4, -edge/2, edge/8])
        do touching = 0, 1
            by%touching = touching == 1
            call make_grid(grid, particles, by)
            call expect_pairs(grid, particles, by, 'tilted', found(touching))
        end do
        call check(found(1) > found(0), 'no spheres touch; '//scene_name(particles))
    end subroutine test_tilt

    !> Every form of set_box, one after the other on one grid.
    subroutine test_changes(dimension, seed)
        !> 2 or 3
        integer, intent(in) :: dimension
        !> Of the scene
        integer, intent(in) :: seed

        type(hg_grid) :: grid
        type(hg_error) :: err
        type(scene) :: particles
        type(rule) :: by
        real(c_double) :: high(3), tilt(3)
        integer :: found

        call particles%fill(seed, dimension, n=150, edge=edge, r_max=edge/8, grain=edge/64)
        by = tilted_rule(dimension, [0, 0, 0])
        call make_grid(grid, particles, by)
        call expect_pairs(grid, particles, by, 'upright', found)

        by = tilted_rule(dimension, [edge/2, edge/4, -edge/4])
        high = length_of(by%box)
        tilt = length_of(by%tilt)
        call grid%set_box(nowhere, high, tilt)
        call expect_pairs(grid, particles, by, 'set_box(low, high, tilt)', found)
        by%box = by%box + edge/8
        high = length_of(by%box)
        call grid%set_box(nowhere, high, tilt, err)
        call check_works(err, 'set_box(low, high, tilt, err)')
        call expect_pairs(grid, particles, by, 'set_box(low, high, tilt, err)', found)
        by%tilt = by%tilt/2
        call grid%set_box(real(nowhere, c_float), real(high, c_float), real(tilt/2, c_float))
        call expect_pairs(grid, particles, by, 'set_box of real32 with tilt', found)
        by%tilt = 0
        call grid%set_box(nowhere, high)
        call expect_pairs(grid, particles, by, 'set_box(low, high)', found)
        by%box = merge(edge, 0, by%box > 0)
        call grid%set_box(real(nowhere, c_float), real(length_of(by%box), c_float), err)
        call check_works(err, 'set_box of real32 with err')
        call expect_pairs(grid, particles, by, 'set_box of real32', found)
    end subroutine test_changes

    !> A cube, or square, with this tilt.
    function tilted_rule(dimension, tilt) result(by)
        !> 2 or 3
        integer, intent(in) :: dimension
        !> xy, xz, yz
        integer, intent(in) :: tilt(3)
        type(rule) :: by

        by%box(:dimension) = edge
        by%tilt = tilt
        if (dimension == 2) by%tilt(2:) = 0
    end function tilted_rule

    subroutine expect_pairs(grid, particles, by, what, found)
        !> The grid
        type(hg_grid), intent(in) :: grid
        !> Its particles
        type(scene), intent(in) :: particles
        !> Its rule
        type(rule), intent(in) :: by
        !> For messages
        character(len=*), intent(in) :: what
        !> Number of pairs
        integer, intent(out) :: found

        integer(c_int32_t), pointer :: pairs(:, :)
        character(len=:), allocatable :: text

        call grid%query_pairs(pairs)
        found = size(pairs, 2)
        text = difference(pairs, contact_matrix(particles, by))
        call check(text == '', what//': '//text//'; '//scene_name(particles))
    end subroutine expect_pairs

    !> A sphere alone in a cube meets itself: 6 neighbours at one edge, 12 at its diagonal, and each
    !> pair stands for two of them.
    subroutine test_all_images()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        integer(c_int32_t), pointer :: pairs(:, :), neighbors(:)
        integer(c_int64_t), pointer :: offsets(:)

        def = hg_default_grid_def()
        def%periodic = 1
        def%box_max = 1
        def%touching = 1
        def%images = HG_ALL_IMAGES
        call grid%create(def)
        call grid%insert(reshape(nowhere, [3, 1]), [0.5_c_double])
        call grid%query_pairs(pairs)
        call check(size(pairs, 2) == 3, 'images at one edge')
        call check(all(pairs == 1), 'a pair of a particle with itself')
        call grid%move(reshape(nowhere, [3, 1]), [0.75_c_double])
        call grid%query_pairs(pairs)
        call check(size(pairs, 2) == 3 + 6, 'images at the diagonals')
        call grid%query_neighbors(HG_FULL, offsets, neighbors)
        call check(size(neighbors) == 6 + 12, 'both of each two images')
        call grid%query_neighbors(HG_HALF, offsets, neighbors)
        call check(size(neighbors) == 3 + 6, 'one of each two images')
    end subroutine test_all_images

    !> What is refused changes nothing.
    subroutine test_refusals()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(hg_error) :: err
        integer(c_int32_t), pointer :: pairs(:, :)

        call grid%set_box(nowhere, unit_box, err)
        call check_fails(err, HG_ERR_NULL, 'set_box: the grid was not created', 'set_box')
        def = hg_default_grid_def()
        def%periodic = 1
        def%box_max = 1
        call grid%create(def)
        call grid%insert(reshape([0.125_c_double, 0.5_c_double, 0.5_c_double, &
            0.875_c_double, 0.5_c_double, 0.5_c_double], [3, 2]), [0.2_c_double, 0.2_c_double])
        call grid%set_box(nowhere(:2), unit_box(:2), err)
        call check_fails(err, HG_ERR_ARGUMENT, 'box_min(2), box_max(2) and tilt(3)', 'two values')
        call grid%set_box(nowhere, unit_box, [0.5_c_double], err)
        call check_fails(err, HG_ERR_ARGUMENT, 'tilt(1)', 'one tilt')
        call grid%set_box(nowhere, -unit_box, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'box_max(1)', 'a box upside down')
        call grid%set_box(nowhere, unit_box/2, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'set_box', 'a box so short that two meet twice')
        call grid%query_pairs(pairs)
        call check(size(pairs, 2) == 1, 'a refused box has changed the grid')
    end subroutine test_refusals

end program test_boxes
