! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The oracle: every two particles compared in integers, which decide touching and overlap exactly.
!>
!> Lengths are integers below 2^21, counted in units of 2^-20, so that both real32 and real64 hold
!> them exactly and no square of a distance leaves a 64-bit integer.
module brute_force
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
    implicit none
    private

    public :: contact_matrix, difference, interact, length_of, rule, scene, scene_name

    real(c_double), parameter :: unit = 2.0_c_double**(-20)

    !> Random particles.
    type :: scene
        integer :: seed = 0
        integer(c_int64_t), allocatable :: x(:, :)
        integer(c_int64_t), allocatable :: r(:)
    contains
        procedure :: fill
        procedure :: shake
    end type scene

    !> When two particles interact.
    type :: rule
        logical :: max_range = .false.
        integer(c_int64_t) :: margin = 0
        !> Length of the periodic box per axis, even; 0 is an open axis
        integer(c_int64_t) :: box(3) = 0
        !> xy, xz, yz of the periodic box, each at most half the length it leans over
        integer(c_int64_t) :: tilt(3) = 0
        !> Whether touching counts
        logical :: touching = .false.
    end type rule

contains

    !> Particles in a cube, many small and few large ones.
    subroutine fill(self, seed, dimension, n, edge, r_max, grain)
        !> The scene
        class(scene), intent(inout) :: self
        !> 1 to 2^31 - 2
        integer, intent(in) :: seed
        !> 2 or 3
        integer, intent(in) :: dimension
        !> Number of particles
        integer, intent(in) :: n
        !> Edge of the cube, in units
        integer, intent(in) :: edge
        !> Largest radius, in units
        integer, intent(in) :: r_max
        !> All lengths are multiples of it; a coarse grain gives many spheres that exactly touch
        integer, intent(in) :: grain

        integer(c_int64_t) :: state
        real(c_double) :: share
        integer :: i, k

        self%seed = seed
        if (allocated(self%x)) deallocate (self%x, self%r)
        allocate (self%x(dimension, n), self%r(n))
        state = seed
        do i = 1, n
            do k = 1, dimension
                self%x(k, i) = random_below(state, edge/grain)*grain
            end do
            ! The fourth power of a uniform number favours small radii.
            share = (random_below(state, 1000)/1000.0_c_double)**4
            self%r(i) = int(r_max/grain*share, c_int64_t)*grain
        end do
    end subroutine fill

    !> Shifts all particles at random.
    subroutine shake(self, reach)
        !> The scene
        class(scene), intent(inout) :: self
        !> Largest shift per axis, in units
        integer, intent(in) :: reach

        integer(c_int64_t) :: state
        integer :: i, k

        state = self%seed + 1
        do i = 1, size(self%x, 2)
            do k = 1, size(self%x, 1)
                self%x(k, i) = self%x(k, i) + random_below(state, 2*reach) - reach
            end do
        end do
    end subroutine shake

    !> A whole number from 0 to limit - 1, by the generator of Park and Miller.
    function random_below(state, limit) result(number)
        !> Of the generator
        integer(c_int64_t), intent(inout) :: state
        !> > 0
        integer, intent(in) :: limit
        integer(c_int64_t) :: number

        state = mod(16807_c_int64_t*state, 2147483647_c_int64_t)
        number = state*limit/2147483647_c_int64_t
    end function random_below

    !> Whether particles i and j interact.
    pure function interact(self, i, j, by) result(answer)
        !> The particles
        type(scene), intent(in) :: self
        !> One of them
        integer, intent(in) :: i
        !> Another one
        integer, intent(in) :: j
        !> The rule
        type(rule), intent(in) :: by
        logical :: answer

        integer(c_int64_t) :: reach

        reach = self%r(i) + self%r(j)
        if (by%max_range) reach = max(self%r(i), self%r(j))
        reach = reach + by%margin
        if (by%touching) then
            answer = least_square(self, i, j, by) <= reach**2
        else
            answer = least_square(self, i, j, by) < reach**2
        end if
    end function interact

    !> The squared distance of the nearest images. Places lie less than a box apart.
    pure function least_square(self, i, j, by) result(least)
        !> The particles
        type(scene), intent(in) :: self
        !> One of them
        integer, intent(in) :: i
        !> Another one
        integer, intent(in) :: j
        !> The rule
        type(rule), intent(in) :: by
        integer(c_int64_t) :: least

        integer(c_int64_t) :: gap(3)
        integer :: n1, n2, n3, images(3)

        gap = 0
        gap(:size(self%x, 1)) = self%x(:, i) - self%x(:, j)
        images = merge(2, 0, by%box > 0)
        least = huge(least)
        do n3 = -images(3), images(3)
            do n2 = -images(2), images(2)
                do n1 = -images(1), images(1)
                    least = min(least, (gap(1) + n1*by%box(1) + n2*by%tilt(1) + n3*by%tilt(2))**2 &
                        + (gap(2) + n2*by%box(2) + n3*by%tilt(3))**2 + (gap(3) + n3*by%box(3))**2)
                end do
            end do
        end do
    end function least_square

    !> (n, n): true above the diagonal where two particles interact.
    function contact_matrix(self, by) result(matrix)
        !> The particles
        type(scene), intent(in) :: self
        !> The rule
        type(rule), intent(in) :: by
        logical, allocatable :: matrix(:, :)

        integer :: i, j, n

        n = size(self%r)
        allocate (matrix(n, n))
        matrix = .false.
        do j = 2, n
            do i = 1, j - 1
                matrix(i, j) = interact(self, i, j, by)
            end do
        end do
    end function contact_matrix

    !> How pairs, in any order, differ from a contact matrix; empty if each occurs exactly once.
    function difference(pairs, matrix) result(text)
        !> (2, count), ids from 1
        integer(c_int32_t), intent(in) :: pairs(:, :)
        !> (n, n)
        logical, intent(in) :: matrix(:, :)
        character(len=:), allocatable :: text

        logical, allocatable :: seen(:, :)
        character(len=80) :: line
        integer :: k, a, b

        text = ''
        allocate (seen, mold=matrix)
        seen = .false.
        do k = 1, size(pairs, 2)
            a = pairs(1, k)
            b = pairs(2, k)
            write (line, '(a,i0,a,i0,a,i0)') 'pair ', k, ' is ', a, ', ', b
            if (a < 1 .or. a >= b .or. b > size(matrix, 1)) then
                text = trim(line)//': no such particles'
            else if (.not. matrix(a, b)) then
                text = trim(line)//': they do not interact'
            else if (seen(a, b)) then
                text = trim(line)//': found twice'
            end if
            if (text /= '') return
            seen(a, b) = .true.
        end do
        if (count(seen) /= count(matrix)) then
            write (line, '(i0,a,i0,a)') count(seen), ' pairs found of ', count(matrix), ' pairs'
            text = trim(line)
        end if
    end function difference

    !> For messages.
    function scene_name(self) result(text)
        !> The particles
        type(scene), intent(in) :: self
        character(len=:), allocatable :: text

        character(len=80) :: line

        write (line, '(3(a,i0))') 'seed ', self%seed, ', dimension ', size(self%x, 1), &
            ', particles ', size(self%r)
        text = trim(line)
    end function scene_name

    !> Units as the caller's lengths.
    elemental function length_of(number) result(length)
        !> In units
        integer(c_int64_t), intent(in) :: number
        real(c_double) :: length

        length = real(number, c_double)*unit
    end function length_of

end module brute_force
