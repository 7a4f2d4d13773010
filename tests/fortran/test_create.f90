! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Creating and destroying grids, in every form of the call.
program test_create
    use, intrinsic :: iso_c_binding, only: c_loc
    use hgrid
    use checks, only: check, check_fails, check_works, finish_checks
    implicit none

    call test_defaults()
    call test_forms()
    call test_create_again()
    call test_failed_create_keeps_grid()
    call test_cell_sizes()
    call test_level_costs()
    call test_version_and_names()
    call finish_checks()

contains

    subroutine test_defaults()
        type(hg_grid_def) :: def

        def = hg_default_grid_def()
        call check(def%dimension == 3, 'default dimension is 3')
        call check(def%index_base == 1, 'default index_base is 1')
        call check(def%interaction == HG_CONTACT, 'default interaction')
        call check(def%accuracy == HG_EXACT, 'default accuracy')
        call check(def%pair_order == HG_ORDER_GRID, 'default pair_order')
        call check(def%level_rule == HG_LEVELS_AUTO, 'default level_rule')
        call check(all(def%periodic == 0), 'default periodic')
        call check(abs(def%margin) + abs(def%skin) <= 0, 'default margin and skin')
        call check(def%cell_overhead < 0, 'default cell_overhead is the rule''s own')
        call check(all(abs(def%tilt) <= 0), 'default tilt')
        call check(def%touching == 0, 'default touching')
        call check(def%images == HG_NEAREST_IMAGE, 'default images')
        call check(def%level_price < 0 .and. def%row_price < 0, 'default prices are the library''s own')
    end subroutine test_defaults

    !> Every form leaves a grid that counts two particles.
    subroutine test_forms()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(hg_error) :: err

        def = hg_default_grid_def()
        call grid%create()
        call expect_count(grid, 2, 'create()')
        call grid%create(err)
        call check_works(err, 'create(err)')
        call expect_count(grid, 2, 'create(err)')
        call grid%create(def)
        call expect_count(grid, 2, 'create(def)')
        call grid%create(def, err)
        call check_works(err, 'create(def, err)')
        call expect_count(grid, 2, 'create(def, err)')
        call grid%create(def, [8.0_c_double])
        call expect_count(grid, 2, 'create(def, cell_sizes)')
        call grid%create(def, cell_sizes=[8.0_c_double], err=err)
        call check_works(err, 'create(def, cell_sizes, err)')
        call expect_count(grid, 2, 'create(def, cell_sizes, err)')
        call grid%destroy()
        call grid%destroy(err)
        call check_works(err, 'destroying twice')
    end subroutine test_forms

    !> Inserts two touching spheres and one apart, removes one.
    subroutine expect_count(grid, expected, what)
        !> An empty grid
        type(hg_grid), intent(inout) :: grid
        !> Number of particles then
        integer, intent(in) :: expected
        !> The call that made the grid
        character(len=*), intent(in) :: what

        type(hg_grid_stats) :: stats

        call grid%insert(reshape([real(c_double) :: 0, 0, 0, 1, 0, 0, 9, 9, 9], [3, 3]), &
            [real(c_double) :: 1, 1, 1])
        call grid%remove([3])
        call grid%get_stats(stats)
        call check(stats%particle_count == expected, what//': number of particles')
    end subroutine expect_count

    subroutine test_create_again()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(hg_grid_stats) :: stats

        call grid%create()
        call grid%insert(reshape([real(c_double) :: 0, 0, 0], [3, 1]), [1.0_c_double])
        def = hg_default_grid_def()
        def%dimension = 2
        call grid%create(def)
        call grid%get_stats(stats)
        call check(stats%particle_count == 0, 'a grid created again is empty')
        call grid%insert(reshape([real(c_double) :: 0, 0], [2, 1]), [1.0_c_double])
        call grid%get_stats(stats)
        call check(stats%particle_count == 1, 'a grid created again has the new dimension')
    end subroutine test_create_again

    subroutine test_failed_create_keeps_grid()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def, empty
        type(hg_grid_stats) :: stats
        type(hg_error) :: err

        call grid%create()
        call grid%insert(reshape([real(c_double) :: 0, 0, 0], [3, 1]), [1.0_c_double])
        def = hg_default_grid_def()
        def%dimension = 4
        call grid%create(def, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'dimension', 'create with dimension 4')
        call grid%create(empty, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'create', 'create with a def that nobody filled')
        call grid%create(hg_default_grid_def(), [real(c_double) ::], err)
        call check_fails(err, HG_ERR_ARGUMENT, 'cell_sizes', 'create with no cell sizes')
        call grid%create(hg_default_grid_def(), [2.0_c_double, 1.0_c_double], err)
        call check_fails(err, HG_ERR_ARGUMENT, 'cell_sizes', 'create with descending cell sizes')
        call grid%get_stats(stats)
        call check(stats%particle_count == 1, 'a failed create leaves the former grid')
    end subroutine test_failed_create_keeps_grid

    subroutine test_cell_sizes()
        real(c_double), target :: sizes(3)
        real(c_double) :: strided(6)
        type(hg_grid) :: grid
        type(hg_grid_def) :: def

        sizes = [real(c_double) :: 1, 2, 8]
        strided = [real(c_double) :: 1, -1, 2, -1, 8, -1]
        call grid%create(hg_default_grid_def(), sizes)
        call expect_sizes(grid, sizes, 'cell_sizes')
        call grid%create(hg_default_grid_def(), strided(1:6:2))
        call expect_sizes(grid, sizes, 'strided cell_sizes')
        def = hg_default_grid_def()
        def%level_rule = HG_LEVELS_USER
        def%level_count = 3
        def%cell_sizes = c_loc(sizes)
        call grid%create(def)
        sizes = 0
        call expect_sizes(grid, [real(c_double) :: 1, 2, 8], 'def%cell_sizes, copied')
    end subroutine test_cell_sizes

    subroutine expect_sizes(grid, sizes, what)
        !> An empty grid
        type(hg_grid), intent(inout) :: grid
        !> Expected cell sizes
        real(c_double), intent(in) :: sizes(:)
        !> How they were given
        character(len=*), intent(in) :: what

        type(hg_level), pointer :: levels(:)
        type(hg_level_cost), pointer :: costs(:)

        call grid%insert(reshape([real(c_double) :: 0, 0, 0, 1, 0, 0], [3, 2]), &
            [real(c_double) :: 0.4, 3])
        call grid%query_levels(levels)
        call check(size(levels) == size(sizes), what//': number of levels')
        if (size(levels) /= size(sizes)) return
        call check(all(abs(levels%cell_size - sizes) <= 0), what//': cell sizes')
        call check(all(levels%particle_count == [1, 0, 1]), what//': particles per level')
        call check(all(abs(levels%largest_radius - [real(c_double) :: 0.4, 0, 3]) <= 0), &
            what//': largest radii')
        call grid%query_level_costs(costs)
        call check(associated(costs) .and. size(costs) == 0, what//': no costs')
    end subroutine expect_sizes

    !> The costs follow Eq. 7 of the paper, L (m + K), with the K that was asked for.
    subroutine test_level_costs()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(hg_level), pointer :: levels(:)
        type(hg_level_cost), pointer :: costs(:)
        real(c_double) :: x(3, 1000), r(1000)
        integer :: i

        x = reshape([((real(mod(i*[7, 11, 13], 101), c_double)), i=1, 1000)], [3, 1000])
        r = [(50.0_c_double/i, i=1, 1000)]
        def = hg_default_grid_def()
        def%level_rule = HG_LEVELS_PAPER
        def%cell_overhead = 0.5_c_double
        call grid%create(def)
        call grid%insert(x, r)
        call grid%query_level_costs(costs)
        call grid%query_levels(levels)
        call check(size(costs) > 1, 'several numbers of levels are looked at')
        call check(all(costs%level_count == [(i, i=1, size(costs))]), 'costs of L = 1, 2, ...')
        do i = 1, size(costs)
            if (costs(i)%reachable == 0) cycle
            call check(abs(costs(i)%cost - i*(costs(i)%occupancy + 0.5_c_double)) <= &
                1e-12_c_double*costs(i)%cost, 'cost is L (m + K)')
        end do
        i = minloc(costs%cost, 1, costs%reachable == 1)
        call check(size(levels) == i, 'the cheapest number of levels is taken')
    end subroutine test_level_costs

    subroutine test_version_and_names()
        integer :: major, minor, patch

        call hg_version(major, minor, patch)
        call check(major >= 0 .and. minor >= 0 .and. patch >= 0 .and. major + minor > 0, 'version')
        call check(hg_status_string(HG_OK) == 'HG_OK', 'name of HG_OK')
        call check(hg_status_string(HG_ERR_LIMIT) == 'HG_ERR_LIMIT', 'name of HG_ERR_LIMIT')
        call check(hg_status_string(-1) == 'unknown status', 'name of a code that is none')
    end subroutine test_version_and_names

end program test_create
