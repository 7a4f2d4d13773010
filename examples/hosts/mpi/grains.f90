! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The program of grains.c in Fortran, to the same bytes: two giants plough through a bed of grains
!> 50 times smaller, on any number of ranks. Arguments: FILE [COUNT [STEPS]].
!>
!> Why the same bytes: whoever finds a contact computes it from the same bits in the same order (by
!> gid); and forces are rounded to multiples of a quantum so coarse that their sums are exact, in
!> whatever order they are added.
program grains
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
    use, intrinsic :: iso_fortran_env, only: error_unit
    use mpi_f08
    use hgrid
    use hgrid_mpi
    implicit none

    integer, parameter :: dp = c_double, slots = 24, giants = 2, balance_every = 50
    real(dp), parameter :: width = 4.2_dp, stiffness = 1000, damping = 0.02_dp, friction = 0.5_dp
    real(dp), parameter :: gravity = 10, dt = 2e-5_dp, skin = 0.004_dp
    ! A power of two. Sums of multiples are exact below 2^53 of them, 131072.
    real(dp), parameter :: quantum = 2.0_dp**(-36), most = 131072

    ! Owned grains, then ghosts. motion: velocity, spin; loads: force, torque, and the sum of the
    ! sizes of all that was added, which bounds both.
    integer :: n, ghost_count
    integer(c_int64_t), allocatable :: gid(:)
    real(dp), allocatable :: x(:, :), r(:), motion(:, :), loads(:, :)
    ! Of owned grains: the springs of contacts with larger ones, as they are and as they become.
    integer(c_int64_t), allocatable :: partner(:, :), new_partner(:, :)
    real(dp), allocatable :: stretch(:, :), new_stretch(:, :)
    integer, allocatable :: used(:)

    type(hg_mpi) :: dist
    type(hg_mpi_stats) :: stats
    integer(c_int64_t) :: contacts, sliding, mine(3), sums(3)
    integer :: rank, ranks, count, steps, step, balanced
    logical :: changed
    real(dp) :: start
    character(len=200) :: path, word

    call MPI_Init()
    call MPI_Comm_rank(MPI_COMM_WORLD, rank)
    call MPI_Comm_size(MPI_COMM_WORLD, ranks)
    count = 4000
    steps = 500
    contacts = 0
    sliding = 0
    balanced = 0
    if (command_argument_count() < 1) call fail('usage: grains FILE [COUNT [STEPS]]')
    call get_command_argument(1, path)
    if (command_argument_count() > 1) then
        call get_command_argument(2, word)
        read (word, *) count
    end if
    if (command_argument_count() > 2) then
        call get_command_argument(3, word)
        read (word, *) steps
    end if

    call begin()
    start = MPI_Wtime()
    do step = 0, steps - 1
        call dist%move(x(:, :n), changed)
        if (mod(step, balance_every) == 0) call balance()
        call fetch_ghosts()
        call find_loads()
        call integrate()
    end do
    start = MPI_Wtime() - start
    call write_grains()

    call dist%get_stats(stats)
    mine = [contacts, sliding, stats%sent_byte_count]
    call MPI_Reduce(mine, sums, 3, MPI_INTEGER8, MPI_SUM, 0, MPI_COMM_WORLD)
    if (rank == 0) then
        print '(i0, a, i0, a, i0, a, i0, a)', count, ' grains, ', steps, ' steps: ', sums(1), &
            ' contacts, ', sums(2), ' of them slide'
        write (error_unit, '(i0, a, i0, a, i0, a, i0, a, f0.2, a)') ranks, ' ranks: balanced ', balanced, &
            ' times, ghosts chosen ', stats%selection_count, ' times, ', sums(3), ' bytes sent, ', start, ' s'
    end if
    call dist%destroy()
    call MPI_Finalize()

contains

    subroutine fail(what)
        character(len=*), intent(in) :: what

        write (error_unit, '(a, i0, 2a)') 'rank ', rank, ': ', what
        call MPI_Abort(MPI_COMM_WORLD, 1)
    end subroutine fail

    !> Between -0.5 and 0.5, of a grain, the same everywhere.
    pure real(dp) function noise(of, which)
        integer(c_int64_t), intent(in) :: of
        integer, intent(in) :: which
        integer(c_int64_t), parameter :: modulus = 2147483647
        integer(c_int64_t) :: state
        integer :: k

        state = mod(of*16 + which + 1, modulus)
        do k = 1, 3
            state = mod(state*48271, modulus)
        end do
        noise = real(state, dp)/2147483647.0_dp - 0.5_dp
    end function noise

    !> The grain that has this gid: giants first, then layers on the floor.
    subroutine place_grain(of, row)
        integer(c_int64_t), intent(in) :: of
        integer, intent(in) :: row
        real(dp), parameter :: spacing = 0.085_dp
        integer(c_int64_t) :: side, k
        integer :: axis

        side = int(width/spacing, c_int64_t)
        k = of - giants
        gid(row) = of
        motion(:, row) = 0
        if (of < giants) then
            r(row) = 1
            x(1:2, row) = 1 + 2.1_dp*real(of, dp)
            ! Above the layers.
            x(3, row) = 0.96_dp + spacing*real((count - giants + side*side - 1)/(side*side), dp)
            motion(1, row) = 2
            motion(3, row) = -4
            motion(5, row) = 3
            return
        end if
        r(row) = 0.02_dp*(1.5_dp + noise(of, 0))
        x(1, row) = (real(mod(k, side), dp) + 0.5_dp + 0.1_dp*noise(of, 1))*spacing
        x(2, row) = (real(mod(k/side, side), dp) + 0.5_dp + 0.1_dp*noise(of, 2))*spacing
        x(3, row) = (real(k/(side*side), dp) + 0.5_dp)*spacing
        do axis = 1, 3
            motion(axis, row) = 2*noise(of, 2 + axis)
        end do
    end subroutine place_grain

    subroutine begin()
        type(hg_grid_def) :: def
        integer(c_int64_t) :: of

        n = max(0, (count - rank + ranks - 1)/ranks)
        ghost_count = 0
        allocate (gid(n), x(3, n), r(n), motion(6, n), loads(7, n))
        do of = 1, n
            call place_grain((of - 1)*ranks + rank, int(of))
        end do
        allocate (partner(slots, n), source=-1_c_int64_t)
        allocate (stretch(3*slots, n), source=0.0_dp)
        def = hg_default_grid_def()
        def%skin = skin
        def%thread_count = 1
        def%periodic(1:2) = 1
        def%box_max(1:2) = width
        call dist%create(MPI_COMM_WORLD%MPI_VAL, def)
        call dist%set(gid, x, r)
    end subroutine begin

    !> New owners: all that a grain has follows it.
    subroutine balance()
        type(hg_error) :: err
        integer(c_int64_t), allocatable :: partner_after(:, :)
        real(dp), allocatable :: motion_after(:, :), stretch_after(:, :)
        integer(c_int64_t), pointer :: gids(:)
        real(dp), pointer :: centers(:, :), radii(:)
        integer :: new_count

        call dist%balance(new_count, err=err)
        if (err%code == HG_ERR_STATE) return ! the library was built without Zoltan: owners stay
        if (err%code /= HG_OK) call fail(err%message)
        call dist%migrate(motion(:, :n), motion_after)
        call dist%migrate(partner, partner_after)
        call dist%migrate(stretch, stretch_after)
        call move_alloc(motion_after, motion)
        call move_alloc(partner_after, partner)
        call move_alloc(stretch_after, stretch)
        call dist%owned(gids, centers, radii)
        n = new_count
        gid = gids
        x = centers
        r = radii
        balanced = balanced + 1
    end subroutine balance

    !> Behind the owned grains.
    subroutine fetch_ghosts()
        integer(c_int64_t), pointer :: gids(:)
        integer(c_int32_t), pointer :: owners(:)
        real(dp), pointer :: centers(:, :), radii(:)
        real(dp), allocatable :: ghost_motion(:, :)

        call dist%ghosts(gids, owners, centers, radii)
        call dist%forward(motion(:, :n), ghost_motion)
        ghost_count = size(gids)
        gid = [gid(:n), gids]
        r = [r(:n), radii]
        x = reshape([x(:, :n), centers], [3, n + ghost_count])
        motion = reshape([motion(:, :n), ghost_motion], [6, n + ghost_count])
    end subroutine fetch_ghosts

    subroutine find_loads()
        integer(c_int32_t), pointer :: pairs(:, :)
        integer :: k

        if (allocated(loads)) deallocate (loads)
        allocate (loads(7, n + ghost_count), source=0.0_dp)
        allocate (new_partner(slots, n), source=-1_c_int64_t)
        allocate (new_stretch(3*slots, n), source=0.0_dp)
        allocate (used(n), source=0)
        call dist%query_pairs(pairs)
        do k = 1, size(pairs, 2)
            if (gid(pairs(1, k)) < gid(pairs(2, k))) then
                call touch(pairs(1, k), pairs(2, k))
            else
                call touch(pairs(2, k), pairs(1, k))
            end if
        end do
        call move_alloc(new_partner, partner)
        call move_alloc(new_stretch, stretch)
        deallocate (used)
        call dist%reverse_add(loads(:, n + 1:), loads(:, :n))
    end subroutine find_loads

    !> i has the smaller gid: all ranks compute alike.
    subroutine touch(i, j)
        integer, intent(in) :: i, j
        real(dp) :: normal(3), distance, overlap, arm_i, arm_j, w(3), v(3), f(3)
        integer :: keeper, other, slot

        ! The smaller one, which is owned, keeps the spring.
        keeper = merge(j, i, r(j) < r(i))
        other = merge(i, j, r(j) < r(i))
        normal = x(:, j) - x(:, i)
        normal(1:2) = normal(1:2) - width*anint(normal(1:2)/width)
        distance = sqrt(dot(normal, normal))
        overlap = r(i) + r(j) - distance
        normal = normal/distance
        arm_i = r(i) - 0.5_dp*overlap
        arm_j = r(j) - 0.5_dp*overlap
        w = arm_i*motion(4:6, i) + arm_j*motion(4:6, j)
        v = motion(1:3, j) - motion(1:3, i) - cross(w, normal)
        slot = slot_of(keeper, gid(other))
        call contact_force(normal, overlap, v, new_stretch(3*slot - 2:3*slot, keeper), f)
        call add_load(i, f, -1.0_dp, -arm_i, normal)
        call add_load(j, f, 1.0_dp, -arm_j, normal)
        contacts = contacts + 1
    end subroutine touch

    !> A new slot of a grain, with the spring that its contact had.
    integer function slot_of(keeper, with) result(slot)
        integer, intent(in) :: keeper
        integer(c_int64_t), intent(in) :: with
        integer :: before

        if (used(keeper) == slots) call fail('a grain touches more larger ones than it has slots for')
        used(keeper) = used(keeper) + 1
        slot = used(keeper)
        new_partner(slot, keeper) = with
        before = findloc(partner(:, keeper), with, 1)
        if (before > 0) then
            new_stretch(3*slot - 2:3*slot, keeper) = stretch(3*before - 2:3*before, keeper)
        end if
    end function slot_of

    !> Spring and dashpot along the normal, which leads from the first grain to the other, and a
    !> spring of friction across. v: of the other's surface against the first's.
    subroutine contact_force(normal, overlap, v, spring, f)
        real(dp), intent(in) :: normal(3), overlap, v(3)
        real(dp), intent(inout) :: spring(3)
        real(dp), intent(out) :: f(3)
        real(dp) :: v_normal, push, along, length, limit

        v_normal = dot(normal, v)
        push = max(0.0_dp, stiffness*overlap - damping*v_normal)
        spring = spring + dt*(v - v_normal*normal)
        along = dot(spring, normal)
        spring = spring - along*normal
        length = 0.5_dp*stiffness*sqrt(dot(spring, spring))
        limit = friction*push
        if (length > limit) then
            spring = spring*(limit/length)
            sliding = sliding + 1
        end if
        f = push*normal - 0.5_dp*stiffness*spring
    end subroutine contact_force

    !> Adds a force on a grain at arm * normal from its centre.
    subroutine add_load(i, f, sign_of_force, arm, normal)
        integer, intent(in) :: i
        real(dp), intent(in) :: f(3), sign_of_force, arm, normal(3)
        real(dp) :: torque(3), one, other
        integer :: k

        torque = cross(normal, f)
        do k = 1, 3
            one = to_quantum(sign_of_force*f(k))
            other = to_quantum(arm*torque(k))
            loads(k, i) = loads(k, i) + one
            loads(3 + k, i) = loads(3 + k, i) + other
            loads(7, i) = loads(7, i) + (abs(one) + abs(other))
        end do
    end subroutine add_load

    subroutine integrate()
        real(dp) :: mass, inertia, depth, floor_force
        integer :: i, k

        do i = 1, n
            mass = 4.18879020478639_dp*r(i)*r(i)*r(i)
            inertia = 0.4_dp*mass*r(i)*r(i)
            depth = r(i) - x(3, i)
            if (.not. loads(7, i) < most) call fail('forces too large for sums that are exact')
            floor_force = 0
            if (depth > 0) floor_force = max(0.0_dp, stiffness*depth - damping*motion(3, i))
            loads(3, i) = loads(3, i) + (floor_force - gravity*mass)
            do k = 1, 3
                motion(k, i) = motion(k, i) + dt*loads(k, i)/mass
                motion(3 + k, i) = motion(3 + k, i) + dt*loads(3 + k, i)/inertia
                x(k, i) = x(k, i) + dt*motion(k, i)
            end do
        end do
    end subroutine integrate

    pure real(dp) function dot(a, b)
        real(dp), intent(in) :: a(3), b(3)

        dot = a(1)*b(1) + a(2)*b(2) + a(3)*b(3)
    end function dot

    pure function cross(a, b) result(c)
        real(dp), intent(in) :: a(3), b(3)
        real(dp) :: c(3)

        c = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
    end function cross

    !> Of numbers as large as the shift the last bit is the quantum.
    pure real(dp) function to_quantum(number)
        real(dp), intent(in) :: number
        real(dp), parameter :: shift = 1.5_dp*2.0_dp**52*quantum

        to_quantum = (number + shift) - shift
    end function to_quantum

    !> Place, velocity and spin of each grain, by gid.
    subroutine write_grains()
        type(MPI_File) :: file
        integer(MPI_OFFSET_KIND) :: row_bytes
        integer :: i, code

        row_bytes = 9*storage_size(0.0_dp)/8
        call MPI_File_open(MPI_COMM_WORLD, trim(path), ior(MPI_MODE_CREATE, MPI_MODE_WRONLY), MPI_INFO_NULL, &
            file, code)
        if (code /= MPI_SUCCESS) call fail('the file cannot be written')
        call MPI_File_set_size(file, count*row_bytes)
        do i = 1, n
            call MPI_File_write_at(file, gid(i)*row_bytes, [x(:, i), motion(:, i)], 9, MPI_DOUBLE_PRECISION, &
                MPI_STATUS_IGNORE, code)
            if (code /= MPI_SUCCESS) call fail('the file cannot be written')
        end do
        call MPI_File_close(file)
    end subroutine write_grains

end program grains
