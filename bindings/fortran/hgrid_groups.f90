! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Grids that know who meets whom: groups, absent particles, bodies.
module hgrid_groups
    use, intrinsic :: iso_c_binding, only: c_int32_t, c_ptr, c_size_t
    use hgrid_error, only: hg_error
    use hgrid_handle, only: conclude, handle_of
    use hgrid_particles, only: hg_particles
    implicit none
    private

    public :: c_hg_set_bodies, c_hg_set_group_pair, c_hg_set_groups
    public :: hg_groups

    !> A grid whose particles stand in groups and belong to bodies.
    type, extends(hg_particles) :: hg_groups
    contains
        private
        procedure, public :: set_groups, set_group_pair, set_bodies
    end type hg_groups

    interface
        function c_hg_set_groups(grid, count, groups) bind(c, name='hg_set_groups') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> (count); absent: all in group 0
            integer(c_int32_t), intent(in), optional :: groups(*)
            integer(c_int32_t) :: status
        end function c_hg_set_groups

        function c_hg_set_group_pair(grid, group_a, group_b, interacts) &
            bind(c, name='hg_set_group_pair') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_int32_t), value :: group_a, group_b, interacts
            integer(c_int32_t) :: status
        end function c_hg_set_group_pair

        function c_hg_set_bodies(grid, count, bodies) bind(c, name='hg_set_bodies') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> (count); absent: none has one
            integer(c_int32_t), intent(in), optional :: bodies(*)
            integer(c_int32_t) :: status
        end function c_hg_set_bodies
    end interface

contains

    !> Says in which group each particle is: groups(k) of the k-th in ascending id, 0 to
    !> HG_MAX_GROUPS - 1, or -1: absent, in no query. What it says holds until another call, or until
    !> set changes the number of particles; particles inserted later are in group 0.
    subroutine set_groups(self, groups, err)
        class(hg_groups), intent(inout) :: self
        !> One for each particle
        integer(c_int32_t), intent(in), contiguous :: groups(:)
        type(hg_error), intent(out), optional :: err

        call conclude(self, c_hg_set_groups(handle_of(self), size(groups, kind=c_size_t), groups), &
            'set_groups', err)
    end subroutine set_groups

    !> Says whether particles of two groups, or of one, are pairs at all. At first all are.
    subroutine set_group_pair(self, group_a, group_b, interacts, err)
        class(hg_groups), intent(inout) :: self
        !> From 0, also in Fortran, as set_groups takes them
        integer, intent(in) :: group_a, group_b
        logical, intent(in) :: interacts
        type(hg_error), intent(out), optional :: err

        call conclude(self, c_hg_set_group_pair(handle_of(self), int(group_a, c_int32_t), &
            int(group_b, c_int32_t), merge(1_c_int32_t, 0_c_int32_t, interacts)), &
            'set_group_pair', err)
    end subroutine set_group_pair

    !> Says to which rigid body each particle belongs: bodies(k) of the k-th in ascending id, -1: to
    !> none. Two of the same body are no pair.
    subroutine set_bodies(self, bodies, err)
        class(hg_groups), intent(inout) :: self
        !> One for each particle
        integer(c_int32_t), intent(in), contiguous :: bodies(:)
        type(hg_error), intent(out), optional :: err

        call conclude(self, c_hg_set_bodies(handle_of(self), size(bodies, kind=c_size_t), bodies), &
            'set_bodies', err)
    end subroutine set_bodies

end module hgrid_groups
