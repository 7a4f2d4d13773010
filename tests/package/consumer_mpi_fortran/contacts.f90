! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> A user's program over ranks: the version of the library and the two contacts among three spheres.
program contacts
    use hgrid
    use hgrid_mpi
    implicit none
    include 'mpif.h'

    type(hg_mpi) :: dist
    type(hg_grid_def) :: def
    integer(c_int32_t), pointer :: pairs(:, :)
    real(c_double) :: x(3, 3)
    integer :: major, minor, patch, k, ierr

    call MPI_Init(ierr)
    x = 0
    x(1, :) = [0.0_c_double, 1.5_c_double, 3.0_c_double]
    def = hg_default_grid_def()
    def%pair_order = HG_ORDER_ID
    call dist%create(MPI_COMM_WORLD, def)
    call dist%set([1_c_int64_t, 2_c_int64_t, 3_c_int64_t], x, &
        [1.0_c_double, 0.8_c_double, 0.9_c_double])
    call dist%query_pairs(pairs)
    call hg_version(major, minor, patch)
    print '(a,i0,a,i0,a,i0)', 'hgrid ', major, '.', minor, '.', patch
    do k = 1, size(pairs, 2)
        print '(i0,1x,i0)', pairs(:, k)
    end do
    call dist%destroy()
    call MPI_Finalize(ierr)
end program contacts
