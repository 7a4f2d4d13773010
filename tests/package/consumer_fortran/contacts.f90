! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> A user's Fortran program: the version of the library and the two contacts among three spheres.
program contacts
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int32_t
    use hgrid, only: HG_ORDER_ID, hg_default_grid_def, hg_grid, hg_grid_def, hg_version
    implicit none
    type(hg_grid) :: grid
    type(hg_grid_def) :: def
    real(c_double) :: x(3, 3), r(3)
    integer(c_int32_t), pointer :: pairs(:, :)
    integer(c_int) :: major, minor, patch
    integer :: k

    x = 0
    x(1, :) = [0.0_c_double, 1.5_c_double, 3.0_c_double]
    r = [1.0_c_double, 0.8_c_double, 0.9_c_double]
    def = hg_default_grid_def()
    def%pair_order = HG_ORDER_ID
    call grid%create(def)
    call grid%insert(x, r)
    call grid%query_pairs(pairs)
    call hg_version(major, minor, patch)
    print '("hgrid ", i0, ".", i0, ".", i0)', major, minor, patch
    do k = 1, size(pairs, 2)
        print '(i0, 1x, i0)', pairs(:, k)
    end do
    call grid%destroy()
end program contacts
