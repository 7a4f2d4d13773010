! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The contacts of a large, a middle and a small sphere.
program minimal
    use hgrid
    implicit none

    type(hg_grid) :: grid
    integer(c_int32_t), pointer :: pairs(:, :)
    real(c_double) :: x(3, 3) = 0
    real(c_double) :: r(3) = [10.0, 1.0, 0.5]

    x(1, :) = [0.0, 10.5, 11.75]
    call grid%create()
    call grid%insert(x, r)
    call grid%query_pairs(pairs)
    print '(i0, " meets ", i0)', pairs
end program minimal
