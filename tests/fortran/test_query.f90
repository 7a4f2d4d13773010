! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> All pairs and spheres, for every rule of interaction, against brute force.
program test_query
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
    use hgrid, only: HG_DOUBLE, HG_FLOAT, hg_default_grid_def, hg_grid, hg_grid_def, hg_grid_stats
    use brute_force, only: contact_matrix, difference, interact, length_of, rule, scene, scene_name
    use rule_grid, only: make_grid
    use checks, only: check, finish_checks
    implicit none

    integer, parameter :: edge = 2**20
    integer :: dimension, seed

    do dimension = 2, 3
        do seed = 1, 4
            call test_rules(dimension, seed, grain=1)
            call test_rules(dimension, seed, grain=edge/32)
        end do
    end do
    call test_base_zero()
    call test_nothing_found()
    call test_pairs_are_borrowed()
    call finish_checks()

contains

    !> Open and periodic axes, both interactions, with and without a margin.
    subroutine test_rules(dimension, seed, grain)
        !> 2 or 3
        integer, intent(in) :: dimension
        !> Of the scene
        integer, intent(in) :: seed
        !> Of the scene; coarse means many touching spheres
        integer, intent(in) :: grain

        type(scene) :: particles
        type(rule) :: by
        integer :: k

        call particles%fill(seed, dimension, n=250, edge=edge, r_max=edge/8, grain=grain)
        do k = 0, 7
            by%max_range = btest(k, 0)
            by%margin = merge(edge/32, 0, btest(k, 1))
            by%box = 0
            if (btest(k, 2)) by%box(1 + mod(seed, dimension)) = edge
            call expect_pairs(particles, by)
            call expect_spheres(particles, by)
        end do
    end subroutine test_rules

    subroutine expect_pairs(particles, by)
        !> The particles
        type(scene), intent(in) :: particles
        !> The rule
        type(rule), intent(in) :: by

        type(hg_grid) :: grid
        integer(c_int32_t), pointer :: pairs(:, :)
        character(len=:), allocatable :: text
        integer(c_int64_t) :: former, this
        integer :: k

        call make_grid(grid, particles, by)
        call grid%query_pairs(pairs)
        text = difference(pairs, contact_matrix(particles, by))
        call check(text == '', 'pairs: '//text//'; '//rule_name(by)//scene_name(particles))
        former = 0
        do k = 1, size(pairs, 2)
            this = pairs(1, k)*2_c_int64_t**32 + pairs(2, k)
            call check(this > former, 'pairs ascend; '//scene_name(particles))
            former = this
        end do
    end subroutine expect_pairs

    !> The last particles leave the grid and ask as spheres whom they meet, all at once and the very
    !> last one alone.
    subroutine expect_spheres(particles, by)
        !> The particles
        type(scene), intent(in) :: particles
        !> The rule
        type(rule), intent(in) :: by

        integer, parameter :: spheres = 20
        type(hg_grid) :: grid
        integer(c_int64_t), pointer :: offsets(:)
        integer(c_int32_t), pointer :: ids(:), rows(:)
        integer, allocatable :: expected(:)
        integer :: i, k, n

        call make_grid(grid, particles, by)
        n = size(particles%r) - spheres
        call grid%remove([(n + k, k=1, spheres)])
        call grid%query_spheres(length_of(particles%x(:, n + 1:)), length_of(particles%r(n + 1:)), &
            offsets, rows)
        call check(size(offsets) == spheres + 1 .and. offsets(1) == 0, 'offsets of query_spheres')
        do k = 1, spheres
            expected = pack([(i, i=1, n)], [(interact(particles, i, n + k, by), i=1, n)])
            call check(is_same(rows(offsets(k) + 1:offsets(k + 1)), expected), &
                'query_spheres; '//rule_name(by)//scene_name(particles))
        end do
        call check(size(rows) == offsets(spheres + 1), 'ids of query_spheres')
        call grid%query_sphere(length_of(particles%x(:, n + spheres)), &
            length_of(particles%r(n + spheres)), ids)
        call check(is_same(ids, expected), 'query_sphere; '//rule_name(by)//scene_name(particles))
    end subroutine expect_spheres

    function is_same(ids, expected) result(same)
        !> What was found
        integer(c_int32_t), intent(in) :: ids(:)
        !> What is true
        integer, intent(in) :: expected(:)
        logical :: same

        same = size(ids) == size(expected)
        if (same) same = all(ids == expected)
    end function is_same

    function rule_name(by) result(text)
        !> The rule
        type(rule), intent(in) :: by
        character(len=:), allocatable :: text

        character(len=80) :: line

        write (line, '(a,l1,4(a,i0))') 'max_range ', by%max_range, ', margin ', by%margin, &
            ', box ', by%box(1), ' ', by%box(2), ' ', by%box(3)
        text = trim(line)//'; '
    end function rule_name

    subroutine test_base_zero()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        integer(c_int32_t), pointer :: pairs(:, :)

        def = hg_default_grid_def()
        def%index_base = 0
        call grid%create(def)
        call grid%insert(reshape([real(c_double) :: 0, 0, 0, 1, 0, 0], [3, 2]), &
            [real(c_double) :: 1, 1])
        call grid%query_pairs(pairs)
        call check(size(pairs, 2) == 1, 'one pair with index_base 0')
        call check(all(pairs(:, 1) == [0, 1]), 'ids from 0 with index_base 0')
    end subroutine test_base_zero

    !> Results without entries are associated, so that size and loops work.
    subroutine test_nothing_found()
        type(hg_grid) :: grid
        integer(c_int32_t), pointer :: pairs(:, :), ids(:)

        call grid%create()
        call grid%query_pairs(pairs)
        call check(associated(pairs), 'pairs of an empty grid are associated')
        call check(all(shape(pairs) == [2, 0]), 'pairs of an empty grid are (2,0)')
        ! These two touch, and touching is not overlapping.
        call grid%insert(reshape([real(c_double) :: 0, 0, 0, 2, 0, 0], [3, 2]), &
            [real(c_double) :: 1, 1])
        call grid%query_pairs(pairs)
        call check(associated(pairs), 'pairs of touching spheres are associated')
        call check(all(shape(pairs) == [2, 0]), 'touching spheres are no pair')
        call grid%query_sphere([real(c_double) :: 1, 2, 0], 1.0_c_double, ids)
        call check(associated(ids), 'ids of a sphere that meets nothing are associated')
        call check(size(ids) == 0, 'a sphere that meets nothing')
    end subroutine test_nothing_found

    !> Asking twice shows the same memory, and the search is not repeated.
    subroutine test_pairs_are_borrowed()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(hg_grid_stats) :: stats
        type(scene) :: particles
        integer(c_int32_t), pointer :: first(:, :), second(:, :)
        integer :: accuracy

        call particles%fill(seed=5, dimension=3, n=250, edge=edge, r_max=edge/8, grain=1)
        def = hg_default_grid_def()
        do accuracy = HG_DOUBLE, HG_FLOAT
            def%accuracy = accuracy
            call grid%create(def)
            call grid%insert(length_of(particles%x), length_of(particles%r))
            call grid%query_pairs(first)
            call grid%query_pairs(second)
            call check(associated(first, second), 'a second query shows the same pairs')
            call grid%get_stats(stats)
            call check(stats%search_count == 1, 'a second query does not search')
            call check(stats%pair_count == size(first, 2), 'pairs are counted')
            call check(size(first, 2) >= count(contact_matrix(particles, rule())), &
                'no pair is missed')
        end do
    end subroutine test_pairs_are_borrowed

end program test_query
