! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Inserting, moving, removing and clearing, from whole arrays and from slices of them.
program test_insert
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    use hgrid, only: hg_default_grid_def, hg_grid, hg_grid_def, hg_grid_stats
    use brute_force, only: contact_matrix, difference, length_of, rule, scene, scene_name
    use checks, only: check, finish_checks
    implicit none

    integer, parameter :: n = 300
    integer :: dimension

    do dimension = 2, 3
        call test_batches(dimension)
        call test_slices(dimension)
        call test_move(dimension)
        call test_remove(dimension)
    end do
    call test_ids_after_clear()
    call finish_checks()

contains

    subroutine new_grid(grid, particles, dimension)
        !> Becomes an empty grid
        type(hg_grid), intent(inout) :: grid
        !> Becomes a set of particles, still outside the grid
        type(scene), intent(inout) :: particles
        !> 2 or 3
        integer, intent(in) :: dimension

        type(hg_grid_def) :: def

        def = hg_default_grid_def()
        def%dimension = dimension
        call grid%create(def)
        call particles%fill(seed=41*dimension, dimension=dimension, n=n, edge=2**20, &
            r_max=2**18, grain=1)
    end subroutine new_grid

    !> The pairs must be those among the particles, except those of particles that are gone.
    subroutine expect_pairs(grid, particles, what, gone)
        !> The grid
        type(hg_grid), intent(in) :: grid
        !> Its particles, by id
        type(scene), intent(in) :: particles
        !> What was done to the grid
        character(len=*), intent(in) :: what
        !> Ids
        integer, intent(in), optional :: gone(:)

        integer(c_int32_t), pointer :: pairs(:, :)
        logical, allocatable :: matrix(:, :)
        character(len=:), allocatable :: text

        allocate (matrix, source=contact_matrix(particles, rule()))
        if (present(gone)) then
            matrix(gone, :) = .false.
            matrix(:, gone) = .false.
        end if
        call check(count(matrix) > n/2, what//': the scene has contacts')
        call grid%query_pairs(pairs)
        text = difference(pairs, matrix)
        call check(text == '', what//': '//text//'; '//scene_name(particles))
    end subroutine expect_pairs

    subroutine test_batches(dimension)
        !> 2 or 3
        integer, intent(in) :: dimension

        type(hg_grid) :: grid
        type(scene) :: particles
        real(c_double), allocatable :: x(:, :), r(:)
        integer(c_int32_t), pointer :: pairs(:, :)

        call new_grid(grid, particles, dimension)
        allocate (x, source=length_of(particles%x))
        allocate (r, source=length_of(particles%r))
        call grid%insert(x(:, :0), r(:0))
        call grid%insert(x(:, :100), r(:100))
        call grid%query_pairs(pairs)
        call grid%insert(x(:, 101:101), r(101:101))
        call grid%insert(x(:, 102:), r(102:))
        call expect_pairs(grid, particles, 'insert in batches')
    end subroutine test_batches

    subroutine test_slices(dimension)
        !> 2 or 3
        integer, intent(in) :: dimension

        type(hg_grid) :: grid
        type(scene) :: particles
        real(c_double) :: table(6, 3*n), by_particle(n, 4)

        call new_grid(grid, particles, dimension)
        table = -1
        table(6:7 - dimension:-1, 2::3) = length_of(particles%x)
        table(1, 2::3) = length_of(particles%r)
        call grid%insert(table(6:7 - dimension:-1, 2::3), table(1, 2::3))
        call expect_pairs(grid, particles, 'insert of slices')

        by_particle = 0
        by_particle(:, :dimension) = transpose(length_of(particles%x))
        by_particle(:, 4) = length_of(particles%r)
        call grid%move(transpose(by_particle(:, :dimension)), by_particle(:, 4))
        call expect_pairs(grid, particles, 'move of a transposed slice')
    end subroutine test_slices

    subroutine test_move(dimension)
        !> 2 or 3
        integer, intent(in) :: dimension

        type(hg_grid) :: grid
        type(scene) :: particles
        real(c_double) :: table(4, n)

        call new_grid(grid, particles, dimension)
        call grid%insert(length_of(particles%x), length_of(particles%r))
        call expect_pairs(grid, particles, 'before move')
        call particles%shake(2**17)
        table(:dimension, :) = length_of(particles%x)
        call grid%move(table(:dimension, :))
        call expect_pairs(grid, particles, 'move(x)')
        particles%r = particles%r(n:1:-1)
        call particles%shake(2**16)
        call grid%move(length_of(particles%x), length_of(particles%r))
        call expect_pairs(grid, particles, 'move(x, r)')
    end subroutine test_move

    !> Rows of a move belong to the particles that are left, by ascending id.
    subroutine test_remove(dimension)
        !> 2 or 3
        integer, intent(in) :: dimension

        type(hg_grid) :: grid
        type(scene) :: particles
        real(c_double), allocatable :: x(:, :)
        integer :: gone(n/5), i

        call new_grid(grid, particles, dimension)
        call grid%insert(length_of(particles%x), length_of(particles%r))
        gone = [(i, i=n - 1, 3, -5)]
        call grid%remove(gone)
        call expect_pairs(grid, particles, 'remove', gone)
        call particles%shake(2**17)
        allocate (x, source=length_of(particles%x))
        call grid%move(x(:, pack([(i, i=1, n)], [(all_differ(gone, i), i=1, n)])))
        call expect_pairs(grid, particles, 'move after remove', gone)
    end subroutine test_remove

    pure function all_differ(list, number) result(answer)
        !> Ids
        integer, intent(in) :: list(:)
        !> An id
        integer, intent(in) :: number
        logical :: answer

        answer = all(list /= number)
    end function all_differ

    subroutine test_ids_after_clear()
        type(hg_grid) :: grid
        type(hg_grid_stats) :: stats
        integer(c_int32_t), pointer :: pairs(:, :)
        real(c_double), parameter :: x(3, 2) = reshape([real(c_double) :: 0, 0, 0, 1, 0, 0], [3, 2])
        real(c_double), parameter :: r(2) = [real(c_double) :: 1, 1]

        call grid%create()
        call grid%insert(x, r)
        call grid%remove([1, 2])
        call grid%insert(x, r)
        call grid%build()
        call grid%query_pairs(pairs)
        call check(size(pairs, 2) == 1, 'one pair after remove and insert')
        call check(all(pairs(:, 1) == [3, 4]), 'removed ids are not given out again')
        call grid%clear()
        call grid%get_stats(stats)
        call check(stats%particle_count == 0, 'clear leaves no particle')
        call grid%insert(x, r)
        call grid%query_pairs(pairs)
        call check(size(pairs, 2) == 1, 'one pair after clear and insert')
        call check(all(pairs(:, 1) == [1, 2]), 'ids start anew after clear')
    end subroutine test_ids_after_clear

end program test_insert
