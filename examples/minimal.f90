! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Four spheres, two overlaps.
program minimal
    use hgrid
    implicit none

    type(hg_grid) :: grid
    integer(c_int32_t), pointer :: pairs(:, :)
    real(c_double) :: x(3, 4) = 0, r(4) = [1.0, 0.5, 0.1, 4.0]
    integer :: k

    x(1, :) = [0.0, 1.4, 1.95, 8.0]
    call grid%create()
    call grid%insert(x, r)
    call grid%query_pairs(pairs)
    do k = 1, size(pairs, 2)
        print '(i0, " overlaps ", i0)', pairs(:, k)
    end do
end program minimal
