! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Particles on several ranks, their owners and their pairs: all of hgrid_mpi but the rows that
!> follow particles from rank to rank.
module hgrid_mpi_particles
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int32_t, &
        c_int64_t, c_loc, c_ptr, c_size_t, c_sizeof
    use hgrid_error, only: hg_error, raise, refuse_copies, settle, settle_on
    use hgrid_handle, only: hg_default_grid_def
    use hgrid_mpi_c
    use hgrid_owner, only: disown, hg_owner, own, owned_object => owned
    use hgrid_types, only: hg_grid_def, HG_ERR_ARGUMENT, HG_OK
    implicit none
    private

    public :: hg_mpi_particles
    public :: conclude, former_count, ghost_count, handle_of, misfit, owned_count

    !> Particles of all ranks of a communicator.
    type :: hg_mpi_particles
        private
        ! First, so that its place is that of the whole.
        integer :: dimension = 0
        ! Owned particles before the last balance.
        integer(c_size_t) :: count_before = 0
        type(hg_owner), allocatable :: owner
    contains
        private
        procedure, pass(self) :: refuse_copy
        procedure, public :: create, destroy, set, balance, owned, move, set_groups
        procedure, public :: set_group_pair, set_bodies, query_pairs, ghosts, get_stats
        generic, public :: assignment(=) => refuse_copy
    end type hg_mpi_particles

    ! What no array has: the library refuses it on all ranks alike, where a refusal here would leave
    ! the others waiting.
    integer(c_size_t), parameter :: misfit = huge(1_c_size_t)

    integer(c_int32_t), target :: no_pairs(2, 0), no_owners(0)
    integer(c_int64_t), target :: no_gids(0)
    real(c_double), target :: no_centers(3, 0), no_radii(0)

contains

    !> Without particles; a former object is destroyed. Collective on comm.
    subroutine create(self, comm, def, balancer, verify, imbalance, err)
        class(hg_mpi_particles), intent(inout) :: self
        !> MPI_COMM_WORLD of the module mpi, comm%MPI_VAL of mpi_f08
        integer, intent(in) :: comm
        !> How pairs are decided; absent: hg_default_grid_def()
        type(hg_grid_def), intent(in), optional :: def
        !> HG_MPI_BISECTION or HG_MPI_CURVE
        integer, intent(in), optional :: balancer
        !> Whether set checks that no gid stands twice
        logical, intent(in), optional :: verify
        !> Largest over mean weight that balance may leave
        real(c_double), intent(in), optional :: imbalance
        type(hg_error), intent(out), optional :: err

        type(hg_grid_def) :: grid_def
        type(hg_mpi_def) :: mpi_def
        type(c_ptr) :: created
        integer(c_int32_t) :: status

        grid_def = hg_default_grid_def()
        if (present(def)) grid_def = def
        status = c_hg_mpi_def_init(mpi_def, c_sizeof(mpi_def))
        if (present(balancer)) mpi_def%balancer = int(balancer, c_int32_t)
        if (present(verify)) mpi_def%verify = merge(1_c_int32_t, 0_c_int32_t, verify)
        if (present(imbalance)) mpi_def%imbalance = imbalance
        status = c_hg_mpi_create_f(int(comm, c_int32_t), grid_def, mpi_def, created)
        if (status == HG_OK) then
            call own(self%owner, created, destroy_object)
            self%dimension = grid_def%dimension
        end if
        call settle(status, 'create', err)
    end subroutine create

    subroutine destroy_object(object) bind(c)
        type(c_ptr), value :: object

        integer(c_int32_t) :: ignored

        ignored = c_hg_mpi_destroy(object)
    end subroutine destroy_object

    !> Frees the object and all it lent; collective.
    subroutine destroy(self)
        class(hg_mpi_particles), intent(inout) :: self

        call disown(self%owner)
        self%dimension = 0
    end subroutine destroy

    !> The particles that this rank owns from now on.
    subroutine set(self, gids, x, r, err)
        class(hg_mpi_particles), intent(inout) :: self
        !> (n): each one once on all ranks together
        integer(c_int64_t), intent(in), contiguous :: gids(:)
        !> (dimension, n)
        real(c_double), intent(in), contiguous :: x(:, :)
        !> (n)
        real(c_double), intent(in), contiguous :: r(:)
        type(hg_error), intent(out), optional :: err

        integer(c_size_t) :: count

        count = size(r, kind=c_size_t)
        if (size(gids) /= size(r) .or. .not. fits(self, x, size(r))) count = misfit
        self%count_before = 0
        call conclude(self, c_hg_mpi_set(handle_of(self), count, gids, x, r), 'set', err, &
            count == misfit)
    end subroutine set

    !> New owners, chosen by Zoltan.
    subroutine balance(self, new_count, weights, err)
        class(hg_mpi_particles), intent(inout) :: self
        !> How many particles this rank owns then
        integer, intent(out) :: new_count
        !> (n): of each particle, as many as owned gives; absent on all ranks: by pairs
        real(c_double), intent(in), contiguous, optional :: weights(:)
        type(hg_error), intent(out), optional :: err

        real(c_double), allocatable :: refused(:)
        integer(c_size_t) :: count, before
        integer(c_int32_t) :: status

        before = owned_count(self)
        new_count = int(before)
        count = 0
        if (present(weights)) then
            if (size(weights, kind=c_size_t) /= before .and. before > 0) then
                allocate (refused(before), source=-1.0_c_double)
                call conclude(self, c_hg_mpi_balance(handle_of(self), refused, count), 'balance', &
                    err, .true.)
                return
            end if
        end if
        status = c_hg_mpi_balance(handle_of(self), weights, count)
        if (status == HG_OK) then
            new_count = int(count)
            self%count_before = before
        end if
        call conclude(self, status, 'balance', err)
    end subroutine balance

    !> The particles of this rank; memory of the object, valid until set, balance or move.
    subroutine owned(self, gids, x, r, err)
        class(hg_mpi_particles), intent(in) :: self
        integer(c_int64_t), pointer, intent(out) :: gids(:)
        real(c_double), pointer, intent(out) :: x(:, :), r(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: gid_memory, center_memory, radius_memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (gids, x, r)
        count = 0
        status = c_hg_mpi_owned(handle_of(self), count, gid_memory, center_memory, radius_memory)
        if (status == HG_OK) call show(self, count, gid_memory, center_memory, radius_memory, &
            gids, x, r)
        call conclude(self, status, 'owned', err)
    end subroutine owned

    !> The ghosts; owners are ranks, from 0.
    subroutine ghosts(self, gids, owners, x, r, err)
        class(hg_mpi_particles), intent(in) :: self
        integer(c_int64_t), pointer, intent(out) :: gids(:)
        integer(c_int32_t), pointer, intent(out) :: owners(:)
        real(c_double), pointer, intent(out) :: x(:, :), r(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: gid_memory, owner_memory, center_memory, radius_memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (gids, owners, x, r)
        count = 0
        status = c_hg_mpi_ghosts(handle_of(self), count, gid_memory, owner_memory, &
            center_memory, radius_memory)
        if (status == HG_OK) then
            call show(self, count, gid_memory, center_memory, radius_memory, gids, x, r)
            owners => no_owners
            if (count > 0) call c_f_pointer(owner_memory, owners, [count])
        end if
        call conclude(self, status, 'ghosts', err)
    end subroutine ghosts

    !> New centres, and new radii if present, of this rank's particles.
    subroutine move(self, x, ghosts_changed, r, err)
        class(hg_mpi_particles), intent(inout) :: self
        !> (dimension, n)
        real(c_double), intent(in), contiguous :: x(:, :)
        !> Whether ids of ghosts mean others now
        logical, intent(out) :: ghosts_changed
        !> (n)
        real(c_double), intent(in), contiguous, optional :: r(:)
        type(hg_error), intent(out), optional :: err

        integer(c_size_t) :: count
        integer(c_int32_t) :: status, changed

        count = size(x, 2, c_size_t)
        if (.not. fits(self, x, size(x, 2))) count = misfit
        if (present(r)) then
            if (size(r) /= size(x, 2)) count = misfit
        end if
        changed = 0
        status = c_hg_mpi_move(handle_of(self), count, x, r, changed)
        ghosts_changed = changed /= 0
        call conclude(self, status, 'move', err, count == misfit)
    end subroutine move

    !> In which group each owned particle is: 0 to HG_MPI_MAX_GROUPS - 1, or -1: absent.
    subroutine set_groups(self, groups, err)
        class(hg_mpi_particles), intent(inout) :: self
        integer(c_int32_t), intent(in), contiguous :: groups(:)
        type(hg_error), intent(out), optional :: err

        call conclude(self, c_hg_mpi_set_groups(handle_of(self), size(groups, kind=c_size_t), &
            groups), 'set_groups', err)
    end subroutine set_groups

    !> Whether particles of two groups are pairs at all; groups from 0.
    subroutine set_group_pair(self, group_a, group_b, interacts, err)
        class(hg_mpi_particles), intent(inout) :: self
        integer, intent(in) :: group_a, group_b
        logical, intent(in) :: interacts
        type(hg_error), intent(out), optional :: err

        call conclude(self, c_hg_mpi_set_group_pair(handle_of(self), int(group_a, c_int32_t), &
            int(group_b, c_int32_t), merge(1_c_int32_t, 0_c_int32_t, interacts)), &
            'set_group_pair', err)
    end subroutine set_group_pair

    !> To which body each owned particle belongs, -1: to none.
    subroutine set_bodies(self, bodies, err)
        class(hg_mpi_particles), intent(inout) :: self
        integer(c_int32_t), intent(in), contiguous :: bodies(:)
        type(hg_error), intent(out), optional :: err

        call conclude(self, c_hg_mpi_set_bodies(handle_of(self), size(bodies, kind=c_size_t), &
            bodies), 'set_bodies', err)
    end subroutine set_bodies

    !> The pairs that this rank finds; memory of the object.
    subroutine query_pairs(self, pairs, err)
        class(hg_mpi_particles), intent(in) :: self
        !> (2, count): the first is owned
        integer(c_int32_t), pointer, intent(out) :: pairs(:, :)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        pairs => no_pairs
        status = c_hg_mpi_query_pairs(handle_of(self), memory, count)
        if (status == HG_OK) then
            if (count > 0) call c_f_pointer(memory, pairs, [2_c_size_t, count])
        end if
        call conclude(self, status, 'query_pairs', err)
    end subroutine query_pairs

    !> The counters of this rank.
    subroutine get_stats(self, stats, err)
        class(hg_mpi_particles), intent(in) :: self
        type(hg_mpi_stats), intent(out) :: stats
        type(hg_error), intent(out), optional :: err

        call conclude(self, c_hg_mpi_get_stats(handle_of(self), stats, c_sizeof(stats)), &
            'get_stats', err)
    end subroutine get_stats

    !> What the library lends of some particles.
    subroutine show(self, count, gid_memory, center_memory, radius_memory, gids, x, r)
        class(hg_mpi_particles), intent(in) :: self
        integer(c_size_t), intent(in) :: count
        type(c_ptr), intent(in) :: gid_memory, center_memory, radius_memory
        integer(c_int64_t), pointer, intent(out) :: gids(:)
        real(c_double), pointer, intent(out) :: x(:, :), r(:)

        gids => no_gids
        x => no_centers(:self%dimension, :)
        r => no_radii
        if (count == 0) return
        call c_f_pointer(gid_memory, gids, [count])
        call c_f_pointer(center_memory, x, [int(self%dimension, c_size_t), count])
        call c_f_pointer(radius_memory, r, [count])
    end subroutine show

    !> How many particles this rank owns; none before set.
    function owned_count(self) result(count)
        class(hg_mpi_particles), intent(in) :: self
        integer(c_size_t) :: count

        type(hg_mpi_stats) :: stats

        count = 0
        if (c_hg_mpi_get_stats(handle_of(self), stats, c_sizeof(stats)) /= HG_OK) return
        count = int(stats%owned_count, c_size_t)
    end function owned_count

    !> The same of ghosts.
    function ghost_count(self) result(count)
        class(hg_mpi_particles), intent(in) :: self
        integer(c_size_t) :: count

        type(hg_mpi_stats) :: stats

        count = 0
        if (c_hg_mpi_get_stats(handle_of(self), stats, c_sizeof(stats)) /= HG_OK) return
        count = int(stats%ghost_count, c_size_t)
    end function ghost_count

    !> How many it owned before the last balance; 0 without one since set.
    function former_count(self) result(count)
        class(hg_mpi_particles), intent(in) :: self
        integer(c_size_t) :: count

        count = self%count_before
    end function former_count

    pure function fits(self, x, count)
        class(hg_mpi_particles), intent(in) :: self
        real(c_double), intent(in) :: x(:, :)
        integer, intent(in) :: count
        logical :: fits

        fits = size(x, 2) == count .and. (size(x, 1) == self%dimension .or. self%dimension == 0)
    end function fits

    function handle_of(self) result(handle)
        class(hg_mpi_particles), intent(in) :: self
        type(c_ptr) :: handle

        handle = owned_object(self%owner)
    end function handle_of

    !> Two copies would own the same memory.
    impure elemental subroutine refuse_copy(left, self)
        class(hg_mpi_particles), intent(inout), target :: left
        class(hg_mpi_particles), intent(in) :: self

        if (c_associated(c_loc(left%dimension))) then
            if (.not. (c_associated(handle_of(left)) .or. c_associated(handle_of(self)))) return
        end if
        call refuse_copies('mpi')
    end subroutine refuse_copy

    !> Ends a call: with what the library says, unless an array of this rank does not fit.
    subroutine conclude(self, status, caller, err, misfits)
        class(hg_mpi_particles), intent(in) :: self
        integer(c_int32_t), intent(in) :: status
        character(len=*), intent(in) :: caller
        type(hg_error), intent(out), optional :: err
        logical, intent(in), optional :: misfits

        if (present(misfits) .and. c_associated(handle_of(self))) then
            if (misfits) then
                call raise(HG_ERR_ARGUMENT, caller//': the shapes of the arrays do not fit', err)
                return
            end if
        end if
        call settle_on('object', handle_of(self), status, caller, err)
    end subroutine conclude

end module hgrid_mpi_particles
