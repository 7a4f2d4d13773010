! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Grains flow down a rough slope, periodic along it and across: a discrete element code as many
!> are. A Verlet list in compressed rows, springs of friction beside it, and behind the grains
!> slots for ghosts, copies of those near the faces of the box. Arguments: [COUNT [STEPS]]. Prints
!> where each grain ends, with all digits; on standard error, the seconds that the search and the
!> whole took.
program slope
    use hgrid
    use, intrinsic :: iso_fortran_env, only: error_unit, int64, real64
    implicit none

    integer, parameter :: max_slots = 400000, max_list = 6000000
    real(real64), parameter :: largest = 1d0, skin = 0.5d0, dt = 0.003d0
    real(real64), parameter :: stiffness = 4d3, damping = 8d0, friction = 0.5d0
    real(real64), parameter :: gravity(3) = [4.5d0, 0d0, -8.9d0]
    !> Of grains, then ghosts
    real(real64) :: x(3, max_slots), v(3, max_slots), r(max_slots)
    !> Of grains: forces, and places when the list was made
    real(real64) :: f(3, max_slots), x_listed(3, max_slots)
    !> Of the ghosts: the grain that each is a copy of, and how far from it
    integer :: owner(max_slots)
    real(real64) :: offset(3, max_slots)
    !> Row i of the list: the partners list(first(i):first(i + 1) - 1) > i, ascending
    integer :: first(max_slots + 1), list(max_list)
    !> Beside the list: the grain behind each partner, and what friction remembers
    integer :: mate(max_list)
    real(real64) :: spring(3, max_list)
    !> The same of the list before
    integer :: old_first(max_slots + 1), old_mate(max_list)
    real(real64) :: old_spring(3, max_list)
    !> Grains that stay, all grains, all with ghosts
    integer :: fixed, n, total
    real(real64) :: width
    integer :: lists = 0
    integer(int64) :: search_ticks = 0, start, finish, tick_rate
    integer :: step, steps, contacts, i

    n = number_argument(1, 20000)
    steps = number_argument(2, 800)
    if (n < 500 .or. n > max_slots/4) error stop 'COUNT is not in 500 .. 100000'
    call fill_box()
    call system_clock(start, tick_rate)
    do step = 1, steps
        call update_list()
        call add_forces()
        v(:, fixed + 1:n) = v(:, fixed + 1:n) + dt*f(:, fixed + 1:n)
        x(:, fixed + 1:n) = x(:, fixed + 1:n) + dt*v(:, fixed + 1:n)
        if (mod(step, 50) == 0) then
            print '("step ", i0, ": ", i0, " contacts, lists made ", i0)', step, contacts, lists
        end if
    end do
    call system_clock(finish)
    write (error_unit, '("search ", f0.3, " s, all ", f0.3, " s")') &
        real(search_ticks, real64)/tick_rate, real(finish - start, real64)/tick_rate
    print '(3es25.16e3)', (x(:, i), i=1, n)

contains

    function number_argument(place, default) result(number)
        integer, intent(in) :: place, default
        integer :: number

        character(len=20) :: text

        number = default
        if (command_argument_count() < place) return
        call get_command_argument(place, text)
        read (text, *) number
    end function number_argument

    !> Between 0 and 1, the same everywhere.
    function noise() result(value)
        real(real64) :: value

        integer(int64), save :: state = 1

        state = mod(16807*state, 2147483647_int64)
        value = real(state, real64)/2147483647
    end function noise

    !> Layers of grains of many sizes, the lowest one fixed.
    subroutine fill_box()
        integer :: i, k, row

        row = max(8, nint((2d0*n)**(1d0/3)))
        width = row*2.05d0
        fixed = row**2
        do i = 1, n
            r(i) = largest/(1 + 0.7d0*noise())
            x(:, i) = 2.05d0*[mod(i - 1, row), mod((i - 1)/row, row), (i - 1)/row**2]
            if (i > fixed) x(3, i) = x(3, i) + 1
            v(:, i) = 0
            do k = 1, 3
                x(k, i) = x(k, i) + 0.05d0*noise()
                if (i > fixed) v(k, i) = noise() - 0.5d0
            end do
        end do
        total = n
    end subroutine fill_box

    subroutine update_list()
        integer(int64) :: begin, finish
        integer :: g

        do g = n + 1, total
            x(:, g) = x(:, owner(g)) + offset(:, g)
            v(:, g) = v(:, owner(g))
        end do
        if (lists > 0) then
            if (4*maxval(sum((x(:, :n) - x_listed(:, :n))**2, 1)) < skin**2) return
        end if
        do i = 1, n
            x(:2, i) = modulo(x(:2, i), width)
        end do
        call add_ghosts()
        if (lists > 0) then
            old_first(:n + 1) = first(:n + 1)
            old_mate(:first(n + 1) - 1) = mate(:first(n + 1) - 1)
            old_spring(:, :first(n + 1) - 1) = spring(:, :first(n + 1) - 1)
        else
            old_first = 1
        end if
        call system_clock(begin)
        call make_list()
        call system_clock(finish)
        search_ticks = search_ticks + finish - begin
        call carry_springs()
        x_listed(:, :n) = x(:, :n)
        lists = lists + 1
    end subroutine update_list

    !> Copies of grains near the faces, behind the others.
    subroutine add_ghosts()
        real(real64) :: halo, place(2)
        integer :: a, b

        halo = 2*largest + skin
        total = n
        do i = 1, n
            do b = -1, 1
                do a = -1, 1
                    place = x(:2, i) + width*[a, b]
                    if (a == 0 .and. b == 0) cycle
                    if (any(place < -halo) .or. any(place > width + halo)) cycle
                    total = total + 1
                    if (total > max_slots) error stop 'too many ghosts'
                    owner(total) = i
                    offset(:, total) = [width*a, width*b, 0d0]
                    x(:, total) = x(:, i) + offset(:, total)
                    v(:, total) = v(:, i)
                    r(total) = r(i)
                end do
            end do
        end do
    end subroutine add_ghosts

    !> Lists the partners of each grain that are nearer to touching than the skin. Rows ascend, so
    !> that forces are added up in the same order whatever the cells.
    subroutine make_list()
        type(hg_grid), save :: grid
        integer(c_int64_t), pointer :: offsets(:)
        integer(c_int32_t), pointer :: neighbors(:)

        if (lists == 0) call grid%create()
        call grid%set(x(:, :total), r(:total) + 0.5d0*skin)
        call grid%query_neighbors(HG_HALF, offsets, neighbors)
        first(:n + 1) = int(offsets(:n + 1)) + 1
        list(:first(n + 1) - 1) = neighbors(:first(n + 1) - 1)
    end subroutine make_list

    !> Finds for each contact what the list before remembered of it.
    subroutine carry_springs()
        integer :: i, j, k

        do i = 1, n
            do k = first(i), first(i + 1) - 1
                j = list(k)
                if (j > n) j = owner(j)
                mate(k) = j
                spring(:, k) = old_spring_of(i, j)
            end do
        end do
    end subroutine carry_springs

    !> As seen from grain i; it may stand in the row of either grain.
    function old_spring_of(i, j) result(s)
        integer, intent(in) :: i, j
        real(real64) :: s(3)

        integer :: k

        do k = old_first(i), old_first(i + 1) - 1
            if (old_mate(k) == j) then
                s = old_spring(:, k)
                return
            end if
        end do
        do k = old_first(j), old_first(j + 1) - 1
            if (old_mate(k) == i) then
                s = -old_spring(:, k)
                return
            end if
        end do
        s = 0
    end function old_spring_of

    !> Springs and dashpots along the line of centres, friction across it. What acts on a ghost is
    !> found again at the other face.
    subroutine add_forces()
        real(real64) :: d(3), distance, normal(3), speed(3), push(3), reach, press, slip
        integer :: i, j, k

        do i = 1, n
            f(:, i) = gravity
        end do
        contacts = 0
        do i = 1, n
            do k = first(i), first(i + 1) - 1
                j = list(k)
                if (i <= fixed .and. mate(k) <= fixed) cycle
                d = x(:, j) - x(:, i)
                reach = r(i) + r(j)
                distance = sum(d**2)
                if (distance >= reach**2) then
                    spring(:, k) = 0
                    cycle
                end if
                contacts = contacts + 1
                distance = sqrt(distance)
                normal = d/distance
                speed = v(:, j) - v(:, i)
                press = stiffness*(reach - distance) - damping*sum(speed*normal)
                spring(:, k) = spring(:, k) + dt*(speed - sum(speed*normal)*normal)
                push = stiffness*spring(:, k)
                slip = sqrt(sum(push**2))
                if (slip > friction*abs(press)) then
                    spring(:, k) = spring(:, k)*(friction*abs(press)/slip)
                    push = stiffness*spring(:, k)
                end if
                push = push - press*normal
                f(:, i) = f(:, i) + push
                if (j <= n) f(:, j) = f(:, j) - push
            end do
        end do
    end subroutine add_forces

end program slope
