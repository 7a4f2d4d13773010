! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The Fortran module with the communicator of mpi_f08: a ring of spheres, dealt out in turn.
program use_f08
    use, intrinsic :: iso_c_binding, only: c_sizeof
    use, intrinsic :: iso_fortran_env, only: error_unit
    use mpi_f08
    use hgrid
    use hgrid_mpi
    implicit none

    integer, parameter :: n = 60
    integer :: rank, ranks, failures

    call MPI_Init()
    call MPI_Comm_rank(MPI_COMM_WORLD, rank)
    call MPI_Comm_size(MPI_COMM_WORLD, ranks)
    failures = 0
    call ring()
    call refusals()
    call MPI_Allreduce(MPI_IN_PLACE, failures, 1, MPI_INTEGER, MPI_SUM, MPI_COMM_WORLD)
    call MPI_Finalize()
    if (failures > 0) error stop 1

contains

    subroutine check(holds, what)
        logical, intent(in) :: holds
        character(len=*), intent(in) :: what

        if (holds) return
        failures = failures + 1
        write (error_unit, '(a,i0,2a)') 'rank ', rank, ': not so: ', what
    end subroutine check

    !> Neighbours along a periodic axis touch: n pairs in all; the forces of all pairs cancel.
    subroutine ring()
        type(hg_mpi) :: dist
        type(hg_mpi_stats) :: stats
        type(hg_grid_def) :: def
        type(hg_error) :: err
        integer(c_int64_t), allocatable :: gids(:), new_gids(:), ghost_gids(:)
        real(c_double), allocatable :: x(:, :), r(:), f(:, :), f_ghost(:, :), f_new(:, :)
        real(c_double), pointer :: x_now(:, :), r_now(:), x_ghost(:, :), r_ghost(:)
        integer(c_int64_t), pointer :: gids_now(:), gids_ghost(:)
        integer(c_int32_t), pointer :: pairs(:, :), owners(:)
        logical :: changed
        integer :: i, k, count, total

        count = 0
        allocate (gids(n), x(3, n), r(n))
        do i = 0, n - 1
            if (mod(i, ranks) /= rank) cycle
            count = count + 1
            gids(count) = 1000_c_int64_t + i
            x(:, count) = [real(i, c_double), 0.0_c_double, 0.0_c_double]
            r(count) = 0.51_c_double
        end do
        gids = gids(:count)
        x = x(:, :count)
        r = r(:count)

        def = hg_default_grid_def()
        def%periodic(1) = 1
        def%box_max(1) = real(n, c_double)
        def%skin = 0.1_c_double
        call dist%create(MPI_COMM_WORLD%MPI_VAL, def, verify=.true.)
        call dist%set(gids, x, r)
        call dist%balance(count, err=err)
        if (err%code == HG_OK) then
            call dist%migrate(gids, new_gids)
            call dist%owned(gids_now, x_now, r_now)
            call check(size(gids_now) == count .and. all(new_gids == gids_now), 'migrated gids')
            x = x_now
        else
            call check(err%code == HG_ERR_STATE, 'balance without Zoltan: '//err%message)
        end if
        x(2, :) = x(2, :) + 0.01_c_double
        call dist%move(x, changed)
        call check(.not. changed, 'a step within the skin')
        call dist%query_pairs(pairs)
        total = size(pairs, 2)
        call MPI_Allreduce(MPI_IN_PLACE, total, 1, MPI_INTEGER, MPI_SUM, MPI_COMM_WORLD)
        call check(total == n, 'a pair for each sphere of the ring')

        call dist%owned(gids_now, x_now, r_now)
        call dist%ghosts(gids_ghost, owners, x_ghost, r_ghost)
        call check(size(owners) == size(gids_ghost) .and. all(owners >= 0 .and. owners < ranks), &
            'owners of ghosts')
        call dist%forward(gids_now, ghost_gids)
        call check(all(ghost_gids == gids_ghost), 'forwarded gids')

        allocate (f(3, size(gids_now)), source=0.0_c_double)
        allocate (f_ghost(3, size(gids_ghost)), source=0.0_c_double)
        do k = 1, size(pairs, 2)
            call check(pairs(1, k) >= 1 .and. pairs(1, k) <= size(gids_now), 'the first is owned')
            f(1, pairs(1, k)) = f(1, pairs(1, k)) + 1
            if (pairs(2, k) <= size(gids_now)) then
                f(1, pairs(2, k)) = f(1, pairs(2, k)) + 1
            else
                i = pairs(2, k) - size(gids_now)
                f_ghost(1, i) = f_ghost(1, i) + 1
            end if
        end do
        call dist%reverse_add(f_ghost, f)
        call check(all(nint(f(1, :)) == 2), 'each sphere has two neighbours')
        call dist%migrate(f(:, :0), f_new, err)
        call check(err%code /= HG_OK, 'rows of another number are refused on all ranks')
        call dist%get_stats(stats)
        call check(stats%owned_count == size(gids_now), 'counters')
        call check(c_sizeof(stats) == 80, 'the size that C knows')
        call dist%destroy()
    end subroutine ring

    !> What one rank does wrong all ranks learn.
    subroutine refusals()
        type(hg_mpi) :: dist
        type(hg_error) :: err
        integer(c_int64_t) :: gids(1)
        real(c_double) :: x(3, 1), r(1)
        logical :: changed

        gids = rank
        x = 100*rank
        r = 1
        call dist%move(x, changed, err=err)
        call check(err%code == HG_ERR_NULL, 'an object that was not created')
        call dist%create(MPI_COMM_WORLD%MPI_VAL)
        call dist%set(gids, x, r)
        if (rank == 0) r = -1
        call dist%set(gids, x, r, err)
        call check(err%code == merge(HG_ERR_ARGUMENT, HG_ERR_REMOTE, rank == 0), 'one radius')
        call check(index(err%message, 'rank 0') > 0, 'names the rank: '//err%message)
        call dist%move(x(:, :merge(0, 1, rank == 0)), changed, err=err)
        call check(err%code == merge(HG_ERR_ARGUMENT, HG_ERR_REMOTE, rank == 0), 'one count')
        call dist%destroy()
    end subroutine refusals

end program use_f08
