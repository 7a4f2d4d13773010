! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Grids that follow a rule of brute_force.
module rule_grid
    use hgrid, only: HG_MAX_RANGE, HG_ORDER_ID, hg_default_grid_def, hg_grid, hg_grid_def
    use brute_force, only: length_of, rule, scene
    implicit none
    private

    public :: make_grid

contains

    subroutine make_grid(grid, particles, by)
        !> Becomes a grid with the particles, of ascending pairs
        type(hg_grid), intent(inout) :: grid
        !> What it is to hold
        type(scene), intent(in) :: particles
        !> The rule
        type(rule), intent(in) :: by

        type(hg_grid_def) :: def

        def = hg_default_grid_def()
        def%dimension = size(particles%x, 1)
        if (by%max_range) def%interaction = HG_MAX_RANGE
        def%margin = length_of(by%margin)
        where (by%box > 0)
            def%periodic = 1
            def%box_max = length_of(by%box)
        end where
        def%tilt = length_of(by%tilt)
        def%touching = merge(1, 0, by%touching)
        def%pair_order = HG_ORDER_ID
        call grid%create(def)
        call grid%insert(length_of(particles%x), length_of(particles%r))
    end subroutine make_grid

end module rule_grid
