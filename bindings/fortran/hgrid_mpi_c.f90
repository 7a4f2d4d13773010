! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The calls of hgrid/mpi.h as Fortran sees them. Communicators are integers, as in the modules mpi
!> and mpi_f08 (comm%MPI_VAL), so that this module needs neither.
module hgrid_mpi_c
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_ptr, c_size_t
    use hgrid_types, only: hg_grid_def
    implicit none
    public

    integer(c_int32_t), parameter :: HG_MPI_BISECTION = 0
    integer(c_int32_t), parameter :: HG_MPI_CURVE = 1
    integer(c_int32_t), parameter :: HG_MPI_MAX_GROUPS = 32

    !> How the ranks work together.
    type, bind(c) :: hg_mpi_def
        integer(c_int32_t) :: struct_size = 0
        integer(c_int32_t) :: balancer = HG_MPI_BISECTION
        integer(c_int32_t) :: verify = 0
        integer(c_int32_t) :: reserved0 = 0
        real(c_double) :: imbalance = 0.0_c_double
    end type hg_mpi_def

    !> Counters of a rank.
    type, bind(c) :: hg_mpi_stats
        integer(c_int64_t) :: owned_count = 0
        integer(c_int64_t) :: ghost_count = 0
        integer(c_int64_t) :: pair_count = 0
        integer(c_int64_t) :: send_rank_count = 0
        integer(c_int64_t) :: receive_rank_count = 0
        integer(c_int64_t) :: sent_byte_count = 0
        integer(c_int64_t) :: selection_count = 0
        integer(c_int64_t) :: update_count = 0
        integer(c_int64_t) :: opened_axis_count = 0
        real(c_double) :: imbalance = 1.0_c_double
    end type hg_mpi_stats

    interface
        function c_hg_mpi_def_init(def, struct_size) bind(c, name='hg_mpi_def_init') result(status)
            import
            !> Filled with the defaults
            type(hg_mpi_def), intent(out) :: def
            integer(c_size_t), value :: struct_size
            integer(c_int32_t) :: status
        end function c_hg_mpi_def_init

        function c_hg_mpi_create_f(comm, grid_def, def, mpi) bind(c, name='hg_mpi_create_f') &
            result(status)
            import
            integer(c_int32_t), value :: comm
            type(hg_grid_def), intent(in) :: grid_def
            type(hg_mpi_def), intent(in) :: def
            !> Null on failure
            type(c_ptr), intent(out) :: mpi
            integer(c_int32_t) :: status
        end function c_hg_mpi_create_f

        function c_hg_mpi_destroy(mpi) bind(c, name='hg_mpi_destroy') result(status)
            import
            !> Null is fine
            type(c_ptr), value :: mpi
            integer(c_int32_t) :: status
        end function c_hg_mpi_destroy

        function c_hg_mpi_set(mpi, count, gids, centers, radii) bind(c, name='hg_mpi_set') &
            result(status)
            import
            type(c_ptr), value :: mpi
            integer(c_size_t), value :: count
            integer(c_int64_t), intent(in) :: gids(*)
            real(c_double), intent(in) :: centers(*), radii(*)
            integer(c_int32_t) :: status
        end function c_hg_mpi_set

        function c_hg_mpi_balance(mpi, weights, new_count) bind(c, name='hg_mpi_balance') &
            result(status)
            import
            type(c_ptr), value :: mpi
            !> (owned); absent: by pairs
            real(c_double), intent(in), optional :: weights(*)
            integer(c_size_t), intent(inout) :: new_count
            integer(c_int32_t) :: status
        end function c_hg_mpi_balance

        function c_hg_mpi_owned(mpi, count, gids, centers, radii) bind(c, name='hg_mpi_owned') &
            result(status)
            import
            type(c_ptr), value :: mpi
            integer(c_size_t), intent(inout) :: count
            type(c_ptr), intent(out) :: gids, centers, radii
            integer(c_int32_t) :: status
        end function c_hg_mpi_owned

        function c_hg_mpi_migrate(mpi, row_bytes, before, after) bind(c, name='hg_mpi_migrate') &
            result(status)
            import
            type(c_ptr), value :: mpi
            integer(c_size_t), value :: row_bytes
            type(c_ptr), value :: before, after
            integer(c_int32_t) :: status
        end function c_hg_mpi_migrate

        function c_hg_mpi_move(mpi, count, centers, radii, ghosts_changed) &
            bind(c, name='hg_mpi_move') result(status)
            import
            type(c_ptr), value :: mpi
            integer(c_size_t), value :: count
            real(c_double), intent(in) :: centers(*)
            !> Absent: unchanged
            real(c_double), intent(in), optional :: radii(*)
            integer(c_int32_t), intent(out) :: ghosts_changed
            integer(c_int32_t) :: status
        end function c_hg_mpi_move

        function c_hg_mpi_set_groups(mpi, count, groups) bind(c, name='hg_mpi_set_groups') &
            result(status)
            import
            type(c_ptr), value :: mpi
            integer(c_size_t), value :: count
            integer(c_int32_t), intent(in) :: groups(*)
            integer(c_int32_t) :: status
        end function c_hg_mpi_set_groups

        function c_hg_mpi_set_group_pair(mpi, group_a, group_b, interacts) &
            bind(c, name='hg_mpi_set_group_pair') result(status)
            import
            type(c_ptr), value :: mpi
            integer(c_int32_t), value :: group_a, group_b, interacts
            integer(c_int32_t) :: status
        end function c_hg_mpi_set_group_pair

        function c_hg_mpi_set_bodies(mpi, count, bodies) bind(c, name='hg_mpi_set_bodies') &
            result(status)
            import
            type(c_ptr), value :: mpi
            integer(c_size_t), value :: count
            integer(c_int32_t), intent(in) :: bodies(*)
            integer(c_int32_t) :: status
        end function c_hg_mpi_set_bodies

        function c_hg_mpi_query_pairs(mpi, pairs, count) bind(c, name='hg_mpi_query_pairs') &
            result(status)
            import
            type(c_ptr), value :: mpi
            type(c_ptr), intent(out) :: pairs
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_mpi_query_pairs

        function c_hg_mpi_ghosts(mpi, count, gids, owners, centers, radii) &
            bind(c, name='hg_mpi_ghosts') result(status)
            import
            type(c_ptr), value :: mpi
            integer(c_size_t), intent(inout) :: count
            type(c_ptr), intent(out) :: gids, owners, centers, radii
            integer(c_int32_t) :: status
        end function c_hg_mpi_ghosts

        function c_hg_mpi_forward(mpi, row_bytes, owned, ghosts) bind(c, name='hg_mpi_forward') &
            result(status)
            import
            type(c_ptr), value :: mpi
            integer(c_size_t), value :: row_bytes
            type(c_ptr), value :: owned, ghosts
            integer(c_int32_t) :: status
        end function c_hg_mpi_forward

        function c_hg_mpi_reverse_add(mpi, columns, ghosts, owned) &
            bind(c, name='hg_mpi_reverse_add') result(status)
            import
            type(c_ptr), value :: mpi
            integer(c_size_t), value :: columns
            real(c_double), intent(in) :: ghosts(*)
            real(c_double), intent(inout) :: owned(*)
            integer(c_int32_t) :: status
        end function c_hg_mpi_reverse_add

        function c_hg_mpi_get_stats(mpi, stats, struct_size) bind(c, name='hg_mpi_get_stats') &
            result(status)
            import
            type(c_ptr), value :: mpi
            type(hg_mpi_stats), intent(inout) :: stats
            integer(c_size_t), value :: struct_size
            integer(c_int32_t) :: status
        end function c_hg_mpi_get_stats
    end interface

end module hgrid_mpi_c
