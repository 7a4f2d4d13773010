! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The Fortran module with the communicator of the older module mpi: two spheres on each rank.
program use_mpi
    use mpi
    use hgrid
    use hgrid_mpi
    implicit none

    type(hg_mpi) :: dist
    integer(c_int32_t), pointer :: pairs(:, :)
    integer(c_int64_t) :: gids(2)
    real(c_double) :: x(3, 2)
    integer :: rank, ranks, total, ierr

    call MPI_Init(ierr)
    call MPI_Comm_rank(MPI_COMM_WORLD, rank, ierr)
    call MPI_Comm_size(MPI_COMM_WORLD, ranks, ierr)
    gids = [2*rank, 2*rank + 1]
    x = 0
    x(1, :) = gids
    call dist%create(MPI_COMM_WORLD)
    call dist%set(gids, x, [0.6_c_double, 0.6_c_double])
    call dist%query_pairs(pairs)
    total = size(pairs, 2)
    call MPI_Allreduce(MPI_IN_PLACE, total, 1, MPI_INTEGER, MPI_SUM, MPI_COMM_WORLD, ierr)
    call dist%destroy()
    call MPI_Finalize(ierr)
    if (total /= 2*ranks - 1) error stop 'not the pairs of a chain'
end program use_mpi
