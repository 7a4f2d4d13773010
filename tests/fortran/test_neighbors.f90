! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Neighbour lists: half and full, in two and three dimensions, with gaps in the ids.
program test_neighbors
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
    use hgrid, only: HG_ERR_ARGUMENT, HG_ERR_CAPACITY, HG_FULL, HG_HALF, hg_default_grid_def, &
        hg_error, hg_grid, hg_grid_def
    use brute_force, only: contact_matrix, length_of, rule, scene, scene_name
    use checks, only: check, check_fails, check_works, finish_checks
    implicit none

    integer, parameter :: n = 300
    integer :: dimension

    do dimension = 2, 3
        call test_lists(dimension, [integer ::])
        call test_lists(dimension, [1, 2, 150, n])
    end do
    call test_empty_grid()
    call test_no_pairs()
    call finish_checks()

contains

    subroutine test_lists(dimension, gone)
        !> 2 or 3
        integer, intent(in) :: dimension
        !> Ids to remove
        integer, intent(in) :: gone(:)

        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(scene) :: particles
        logical, allocatable :: matrix(:, :)
        integer, allocatable :: live(:)
        integer :: i

        call particles%fill(seed=23, dimension=dimension, n=n, edge=2**20, r_max=2**18, grain=2**12)
        def = hg_default_grid_def()
        def%dimension = dimension
        call grid%create(def)
        call grid%insert(length_of(particles%x), length_of(particles%r))
        call grid%remove(gone)
        allocate (live, source=pack([(i, i=1, n)], [(all(gone /= i), i=1, n)]))
        allocate (matrix, source=contact_matrix(particles, rule()))
        call expect_rows(grid, HG_HALF, matrix, live, 'half; '//scene_name(particles))
        matrix = matrix .or. transpose(matrix)
        call expect_rows(grid, HG_FULL, matrix, live, 'full; '//scene_name(particles))
    end subroutine test_lists

    !> Row k holds the live particles that the matrix names for particle live(k), ascending.
    subroutine expect_rows(grid, list, matrix, live, what)
        !> The grid
        type(hg_grid), intent(in) :: grid
        !> HG_HALF or HG_FULL
        integer(c_int32_t), intent(in) :: list
        !> (n, n): row i holds j
        logical, intent(in) :: matrix(:, :)
        !> Ids, ascending
        integer, intent(in) :: live(:)
        !> For messages
        character(len=*), intent(in) :: what

        integer(c_int64_t), pointer :: offsets(:)
        integer(c_int32_t), pointer :: neighbors(:)
        integer, allocatable :: expected(:)
        integer :: k
        logical :: same

        call grid%query_neighbors(list, offsets, neighbors)
        call check(lbound(offsets, 1) == 1 .and. size(offsets) == size(live) + 1, 'offsets; '//what)
        if (size(offsets) /= size(live) + 1) return
        call check(offsets(1) == 0, 'offsets start with 0; '//what)
        call check(offsets(size(offsets)) == size(neighbors), 'offsets end with the number; '//what)
        call check(size(neighbors) == count(matrix(live, live)), 'number of neighbours; '//what)
        do k = 1, size(live)
            associate (row => neighbors(offsets(k) + 1:offsets(k + 1)))
                expected = pack(live, matrix(live(k), live))
                same = size(row) == size(expected)
                if (same) same = all(row == expected)
                call check(same, 'a row of the list; '//what)
            end associate
        end do
        call expect_copies(grid, list, offsets, neighbors, what)
    end subroutine expect_rows

    !> The same lists in arrays of the caller's: of just enough room, of too little, and of more.
    subroutine expect_copies(grid, list, offsets, neighbors, what)
        !> The grid
        type(hg_grid), intent(in) :: grid
        !> HG_HALF or HG_FULL
        integer(c_int32_t), intent(in) :: list
        !> Of the lists that are lent
        integer(c_int64_t), intent(in) :: offsets(:)
        integer(c_int32_t), intent(in) :: neighbors(:)
        !> For messages
        character(len=*), intent(in) :: what

        integer, parameter :: untouched = -77
        type(hg_error) :: err
        integer, allocatable :: point(:), ids(:)
        integer :: found, room

        do room = size(neighbors) - 1, size(neighbors) + 1
            if (room < 0) cycle
            allocate (point(size(offsets) + 1), ids(room), source=untouched)
            call grid%query_neighbors(list, point, ids, found, err)
            call check(found == size(neighbors), 'number of copied neighbours; '//what)
            call check(all(point(:size(offsets)) == offsets + 1), 'point; '//what)
            call check(point(size(point)) == untouched, 'what lies behind point; '//what)
            if (room < size(neighbors)) then
                call check(err%code == HG_ERR_CAPACITY, 'too little room; '//what)
                call check(all(ids == untouched), 'ids are left alone; '//what)
            else
                call check_works(err, 'query_neighbors; '//what)
                call check(all(ids(:found) == neighbors), 'copied neighbours; '//what)
                if (list == HG_HALF) then
                    ids = untouched
                    call grid%query_neighbors(point, ids, found)
                    call check(all(ids(:found) == neighbors), 'half unless told; '//what)
                end if
            end if
            deallocate (point, ids)
        end do
        allocate (point(size(offsets) - 1), ids(0))
        call grid%query_neighbors(list, point, ids, found, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'point(', 'point is too short; '//what)
    end subroutine expect_copies

    subroutine test_empty_grid()
        type(hg_grid) :: grid
        integer(c_int64_t), pointer :: offsets(:)
        integer(c_int32_t), pointer :: neighbors(:)

        call grid%create()
        call grid%query_neighbors(HG_FULL, offsets, neighbors)
        call check(associated(offsets) .and. associated(neighbors), 'empty lists are associated')
        call check(size(offsets) == 1 .and. size(neighbors) == 0, 'lists of an empty grid')
        call check(all(offsets == 0), 'the only offset of an empty grid')
    end subroutine test_empty_grid

    subroutine test_no_pairs()
        type(hg_grid) :: grid
        integer(c_int64_t), pointer :: offsets(:)
        integer(c_int32_t), pointer :: neighbors(:)

        call grid%create()
        call grid%insert(reshape([real(c_double) :: 0, 0, 0, 2, 0, 0], [3, 2]), &
            [real(c_double) :: 1, 1])
        call grid%query_neighbors(HG_HALF, offsets, neighbors)
        call check(associated(neighbors), 'a list without neighbours is associated')
        call check(size(offsets) == 3 .and. size(neighbors) == 0, 'touching spheres are no pair')
        call check(all(offsets == 0), 'offsets without neighbours')
    end subroutine test_no_pairs

end program test_neighbors
