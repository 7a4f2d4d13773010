! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Particles on several ranks of MPI: each pair is found by one rank, which owns at least the smaller
!> of the two. Calls are those of hgrid/mpi.h, with ids that start at 1: 1 to n are owned, n + 1 to
!> n + g ghosts. Collective calls, which are all but owned, ghosts, query_pairs and get_stats,
!> succeed on all ranks or fail on all; also the end of a variable that was created is collective.
module hgrid_mpi
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_loc, c_ptr, c_size_t
    use hgrid_error, only: hg_error
    use hgrid_mpi_c
    use hgrid_mpi_particles
    implicit none
    private

    public :: hg_mpi, hg_mpi_stats, HG_MPI_BISECTION, HG_MPI_CURVE, HG_MPI_MAX_GROUPS

    !> Particles of all ranks of a communicator, and rows of numbers that follow them.
    type, extends(hg_mpi_particles) :: hg_mpi
    contains
        private
        procedure :: reverse_add_one, reverse_add_rows
        procedure :: forward_real64, forward_real64_rows, forward_int32
        procedure :: forward_int32_rows, forward_int64, forward_int64_rows
        procedure :: migrate_real64, migrate_real64_rows, migrate_int32
        procedure :: migrate_int32_rows, migrate_int64, migrate_int64_rows
        !> forward(rows, ghost_rows): real64, int32 or int64, (n) or (columns, n); ghost_rows gets
        !> the size that it needs
        generic, public :: forward => forward_real64, forward_real64_rows, &
            forward_int32, forward_int32_rows, &
            forward_int64, forward_int64_rows
        !> migrate(before, after): as forward, from owners before the last balance to those after it
        generic, public :: migrate => migrate_real64, migrate_real64_rows, &
            migrate_int32, migrate_int32_rows, &
            migrate_int64, migrate_int64_rows
        !> reverse_add(ghost_rows, rows): real64, (g) and (n), or (columns, g) and (columns, n)
        generic, public :: reverse_add => reverse_add_one, reverse_add_rows
    end type hg_mpi

contains

    !> Adds what ghosts have got to their owners.
    subroutine reverse_add_one(self, ghost_rows, rows, err)
        class(hg_mpi), intent(inout) :: self
        real(c_double), intent(in), contiguous :: ghost_rows(:)
        real(c_double), intent(inout), contiguous :: rows(:)
        type(hg_error), intent(out), optional :: err

        integer(c_size_t) :: here, lent
        logical :: wrong

        here = owned_count(self)
        lent = ghost_count(self)
        wrong = size(rows, kind=c_size_t) /= here .or. &
            size(ghost_rows, kind=c_size_t) /= lent
        call conclude(self, c_hg_mpi_reverse_add(handle_of(self), &
            merge(misfit, 1_c_size_t, wrong), ghost_rows, rows), 'reverse_add', err, wrong)
    end subroutine reverse_add_one

    subroutine reverse_add_rows(self, ghost_rows, rows, err)
        class(hg_mpi), intent(inout) :: self
        real(c_double), intent(in), contiguous :: ghost_rows(:, :)
        real(c_double), intent(inout), contiguous :: rows(:, :)
        type(hg_error), intent(out), optional :: err

        integer(c_size_t) :: here, lent
        logical :: wrong

        here = owned_count(self)
        lent = ghost_count(self)
        wrong = size(rows, 2, c_size_t) /= here .or. &
            size(ghost_rows, 2, c_size_t) /= lent .or. &
            size(rows, 1) /= size(ghost_rows, 1)
        call conclude(self, c_hg_mpi_reverse_add(handle_of(self), &
            merge(misfit, size(rows, 1, c_size_t), wrong), ghost_rows, rows), 'reverse_add', err, &
            wrong)
    end subroutine reverse_add_rows

    subroutine forward_real64(self, owned_rows, ghost_rows, err)
        class(hg_mpi), intent(inout) :: self
        real(c_double), intent(in), contiguous, target :: owned_rows(:)
        real(c_double), intent(inout), allocatable, target :: ghost_rows(:)
        type(hg_error), intent(out), optional :: err

        if (allocated(ghost_rows)) deallocate (ghost_rows)
        allocate (ghost_rows(ghost_count(self)))
        call forward_rows(self, 1_c_size_t*storage_size(owned_rows)/8_c_size_t, &
            size(owned_rows, 1, c_size_t), c_loc(owned_rows), c_loc(ghost_rows), err)
    end subroutine forward_real64

    subroutine forward_real64_rows(self, owned_rows, ghost_rows, err)
        class(hg_mpi), intent(inout) :: self
        real(c_double), intent(in), contiguous, target :: owned_rows(:, :)
        real(c_double), intent(inout), allocatable, target :: ghost_rows(:, :)
        type(hg_error), intent(out), optional :: err

        if (allocated(ghost_rows)) deallocate (ghost_rows)
        allocate (ghost_rows(size(owned_rows, 1), ghost_count(self)))
        call forward_rows(self, size(owned_rows, 1, c_size_t)*storage_size(owned_rows)/8_c_size_t, &
            size(owned_rows, 2, c_size_t), c_loc(owned_rows), c_loc(ghost_rows), err)
    end subroutine forward_real64_rows

    subroutine forward_int32(self, owned_rows, ghost_rows, err)
        class(hg_mpi), intent(inout) :: self
        integer(c_int32_t), intent(in), contiguous, target :: owned_rows(:)
        integer(c_int32_t), intent(inout), allocatable, target :: ghost_rows(:)
        type(hg_error), intent(out), optional :: err

        if (allocated(ghost_rows)) deallocate (ghost_rows)
        allocate (ghost_rows(ghost_count(self)))
        call forward_rows(self, 1_c_size_t*storage_size(owned_rows)/8_c_size_t, &
            size(owned_rows, 1, c_size_t), c_loc(owned_rows), c_loc(ghost_rows), err)
    end subroutine forward_int32

    subroutine forward_int32_rows(self, owned_rows, ghost_rows, err)
        class(hg_mpi), intent(inout) :: self
        integer(c_int32_t), intent(in), contiguous, target :: owned_rows(:, :)
        integer(c_int32_t), intent(inout), allocatable, target :: ghost_rows(:, :)
        type(hg_error), intent(out), optional :: err

        if (allocated(ghost_rows)) deallocate (ghost_rows)
        allocate (ghost_rows(size(owned_rows, 1), ghost_count(self)))
        call forward_rows(self, size(owned_rows, 1, c_size_t)*storage_size(owned_rows)/8_c_size_t, &
            size(owned_rows, 2, c_size_t), c_loc(owned_rows), c_loc(ghost_rows), err)
    end subroutine forward_int32_rows

    subroutine forward_int64(self, owned_rows, ghost_rows, err)
        class(hg_mpi), intent(inout) :: self
        integer(c_int64_t), intent(in), contiguous, target :: owned_rows(:)
        integer(c_int64_t), intent(inout), allocatable, target :: ghost_rows(:)
        type(hg_error), intent(out), optional :: err

        if (allocated(ghost_rows)) deallocate (ghost_rows)
        allocate (ghost_rows(ghost_count(self)))
        call forward_rows(self, 1_c_size_t*storage_size(owned_rows)/8_c_size_t, &
            size(owned_rows, 1, c_size_t), c_loc(owned_rows), c_loc(ghost_rows), err)
    end subroutine forward_int64

    subroutine forward_int64_rows(self, owned_rows, ghost_rows, err)
        class(hg_mpi), intent(inout) :: self
        integer(c_int64_t), intent(in), contiguous, target :: owned_rows(:, :)
        integer(c_int64_t), intent(inout), allocatable, target :: ghost_rows(:, :)
        type(hg_error), intent(out), optional :: err

        if (allocated(ghost_rows)) deallocate (ghost_rows)
        allocate (ghost_rows(size(owned_rows, 1), ghost_count(self)))
        call forward_rows(self, size(owned_rows, 1, c_size_t)*storage_size(owned_rows)/8_c_size_t, &
            size(owned_rows, 2, c_size_t), c_loc(owned_rows), c_loc(ghost_rows), err)
    end subroutine forward_int64_rows

    subroutine migrate_real64(self, before, after, err)
        class(hg_mpi), intent(inout) :: self
        real(c_double), intent(in), contiguous, target :: before(:)
        real(c_double), intent(inout), allocatable, target :: after(:)
        type(hg_error), intent(out), optional :: err

        if (allocated(after)) deallocate (after)
        allocate (after(owned_count(self)))
        call migrate_rows(self, 1_c_size_t*storage_size(before)/8_c_size_t, &
            size(before, 1, c_size_t), c_loc(before), c_loc(after), err)
    end subroutine migrate_real64

    subroutine migrate_real64_rows(self, before, after, err)
        class(hg_mpi), intent(inout) :: self
        real(c_double), intent(in), contiguous, target :: before(:, :)
        real(c_double), intent(inout), allocatable, target :: after(:, :)
        type(hg_error), intent(out), optional :: err

        if (allocated(after)) deallocate (after)
        allocate (after(size(before, 1), owned_count(self)))
        call migrate_rows(self, size(before, 1, c_size_t)*storage_size(before)/8_c_size_t, &
            size(before, 2, c_size_t), c_loc(before), c_loc(after), err)
    end subroutine migrate_real64_rows

    subroutine migrate_int32(self, before, after, err)
        class(hg_mpi), intent(inout) :: self
        integer(c_int32_t), intent(in), contiguous, target :: before(:)
        integer(c_int32_t), intent(inout), allocatable, target :: after(:)
        type(hg_error), intent(out), optional :: err

        if (allocated(after)) deallocate (after)
        allocate (after(owned_count(self)))
        call migrate_rows(self, 1_c_size_t*storage_size(before)/8_c_size_t, &
            size(before, 1, c_size_t), c_loc(before), c_loc(after), err)
    end subroutine migrate_int32

    subroutine migrate_int32_rows(self, before, after, err)
        class(hg_mpi), intent(inout) :: self
        integer(c_int32_t), intent(in), contiguous, target :: before(:, :)
        integer(c_int32_t), intent(inout), allocatable, target :: after(:, :)
        type(hg_error), intent(out), optional :: err

        if (allocated(after)) deallocate (after)
        allocate (after(size(before, 1), owned_count(self)))
        call migrate_rows(self, size(before, 1, c_size_t)*storage_size(before)/8_c_size_t, &
            size(before, 2, c_size_t), c_loc(before), c_loc(after), err)
    end subroutine migrate_int32_rows

    subroutine migrate_int64(self, before, after, err)
        class(hg_mpi), intent(inout) :: self
        integer(c_int64_t), intent(in), contiguous, target :: before(:)
        integer(c_int64_t), intent(inout), allocatable, target :: after(:)
        type(hg_error), intent(out), optional :: err

        if (allocated(after)) deallocate (after)
        allocate (after(owned_count(self)))
        call migrate_rows(self, 1_c_size_t*storage_size(before)/8_c_size_t, &
            size(before, 1, c_size_t), c_loc(before), c_loc(after), err)
    end subroutine migrate_int64

    subroutine migrate_int64_rows(self, before, after, err)
        class(hg_mpi), intent(inout) :: self
        integer(c_int64_t), intent(in), contiguous, target :: before(:, :)
        integer(c_int64_t), intent(inout), allocatable, target :: after(:, :)
        type(hg_error), intent(out), optional :: err

        if (allocated(after)) deallocate (after)
        allocate (after(size(before, 1), owned_count(self)))
        call migrate_rows(self, size(before, 1, c_size_t)*storage_size(before)/8_c_size_t, &
            size(before, 2, c_size_t), c_loc(before), c_loc(after), err)
    end subroutine migrate_int64_rows

    subroutine forward_rows(self, row_bytes, count, from, to, err)
        class(hg_mpi), intent(inout) :: self
        integer(c_size_t), intent(in) :: row_bytes, count
        type(c_ptr), intent(in) :: from, to
        type(hg_error), intent(out), optional :: err

        logical :: wrong

        wrong = count /= owned_count(self)
        call conclude(self, c_hg_mpi_forward(handle_of(self), merge(misfit, row_bytes, wrong), &
            from, to), 'forward', err, wrong)
    end subroutine forward_rows

    subroutine migrate_rows(self, row_bytes, count, from, to, err)
        class(hg_mpi), intent(inout) :: self
        integer(c_size_t), intent(in) :: row_bytes, count
        type(c_ptr), intent(in) :: from, to
        type(hg_error), intent(out), optional :: err

        logical :: wrong

        wrong = count /= former_count(self)
        call conclude(self, c_hg_mpi_migrate(handle_of(self), merge(misfit, row_bytes, wrong), &
            from, to), 'migrate', err, wrong)
    end subroutine migrate_rows

end module hgrid_mpi
