! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> A visitor that keeps what it is shown.
module contact_collector
    use hgrid
    implicit none
    private

    public :: collector

    integer, parameter :: most = 100000

    type, extends(hg_contact_visitor) :: collector
        integer :: batches = 0
        integer :: last_batch = huge(0)
        integer :: count = 0
        integer :: dimension = 0
        integer :: largest = 0
        integer(c_int32_t) :: pairs(2, most) = 0
        real(c_double) :: d(3, most) = 0, reach(most) = 0
    contains
        procedure :: visit
    end type collector

contains

    function visit(self, i, j, d, reach) result(answer)
        !> The visitor
        class(collector), intent(inout) :: self
        !> (n)
        integer(c_int32_t), intent(in) :: i(:), j(:)
        !> (dimension, n)
        real(c_double), intent(in) :: d(:, :)
        !> (n)
        real(c_double), intent(in) :: reach(:)
        integer(c_int32_t) :: answer

        integer :: first, last

        first = self%count + 1
        last = self%count + size(i)
        self%batches = self%batches + 1
        self%largest = max(self%largest, size(i), size(j), size(d, 2), size(reach))
        self%dimension = size(d, 1)
        self%pairs(1, first:last) = i
        self%pairs(2, first:last) = j
        self%d(:self%dimension, first:last) = d
        self%reach(first:last) = reach
        self%count = last
        answer = merge(1, 0, self%batches == self%last_batch)
    end function visit

end module contact_collector

!> Vectors, shifts, copies of pairs, contacts in batches, order and verdicts, against brute force.
program test_contacts
    use hgrid
    use brute_force, only: contact_matrix, difference, length_of, rule, scene, scene_name
    use checks, only: check, check_fails, check_works, finish_checks
    use contact_collector, only: collector
    implicit none

    integer, parameter :: n = 1500, edge = 2**20
    integer :: dimension

    do dimension = 2, 3
        call test_scene(dimension)
    end do
    call test_copies()
    call test_nothing()
    call test_order()
    call test_overlap()
    call test_never_created()
    call finish_checks()

contains

    elemental function equal(a, b) result(yes)
        !> Numbers that must not differ at all
        real(c_double), intent(in) :: a, b
        logical :: yes

        yes = .not. abs(a - b) > 0
    end function equal

    !> A box that is periodic along x: lengths are whole numbers of units, so vectors are exact.
    subroutine test_scene(dimension)
        !> 2 or 3
        integer, intent(in) :: dimension

        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(hg_error) :: err
        type(scene) :: particles
        type(rule) :: by
        type(collector), allocatable :: visitor
        integer(c_int32_t), pointer :: pairs(:, :), same(:, :), shifts(:, :), only_shifts(:, :)
        real(c_double), pointer :: vectors(:, :), only_vectors(:, :)
        real(c_double), allocatable :: x(:, :), r(:)
        real(c_double) :: expected(dimension), reach
        integer :: k

        allocate (visitor)
        call particles%fill(seed=3, dimension=dimension, n=n, edge=edge, r_max=3*edge/16, &
            grain=1)
        x = length_of(particles%x)
        r = length_of(particles%r)
        def = hg_default_grid_def()
        def%dimension = dimension
        def%periodic(1) = 1
        def%box_max(1) = 1
        def%margin = 0.03125_c_double
        call grid%create(def)
        call grid%set(x, r)
        call grid%query_pairs(pairs, vectors=vectors, shifts=shifts, err=err)
        call check_works(err, 'query_pairs with vectors and shifts')
        by%box(1) = edge
        by%margin = edge/32
        call check(difference(pairs, contact_matrix(particles, by)) == '', 'pairs beside vectors')
        call check(any(shifts /= 0), 'some pairs meet through the face')
        call check(all(shape(vectors) == [dimension, size(pairs, 2)]), 'shape of vectors')
        call check(all(shape(shifts) == [dimension, size(pairs, 2)]), 'shape of shifts')

        call grid%visit_contacts(visitor, err)
        call check_works(err, 'visit_contacts')
        call check(visitor%count == size(pairs, 2), 'as many contacts as pairs')
        call check(visitor%batches > 1 .and. visitor%largest <= HG_MAX_BATCH, 'batches')
        call check(visitor%dimension == dimension, 'vectors of the dimension of the grid')
        if (visitor%count /= size(pairs, 2)) return
        do k = 1, size(pairs, 2)
            associate (i => pairs(1, k), j => pairs(2, k))
                expected = x(:, j) - x(:, i)
                expected(1) = expected(1) + shifts(1, k)
                reach = r(i) + r(j) + def%margin
            end associate
            call check(all(equal(vectors(:, k), expected)), 'a vector; '//scene_name(particles))
            call check(norm2(expected) < reach, 'the image that is meant; '//scene_name(particles))
            call check(all(visitor%pairs(:, k) == pairs(:, k)), 'contacts in the order of pairs')
            call check(all(equal(visitor%d(:dimension, k), expected)), 'the vector of a contact')
            call check(equal(visitor%reach(k), reach), 'the reach of a contact')
        end do

        call grid%query_pairs(same, vectors=only_vectors)
        call check(all(same == pairs) .and. all(equal(only_vectors, vectors)), 'vectors alone')
        call grid%query_pairs(same, shifts=only_shifts)
        call check(all(same == pairs) .and. all(only_shifts == shifts), 'shifts alone')

        visitor%batches = 0
        visitor%count = 0
        visitor%last_batch = 1
        call grid%visit_contacts(visitor)
        call check(visitor%batches == 1, 'no batch after the one that ended the visit')
    end subroutine test_scene

    subroutine test_copies()
        type(hg_grid) :: grid
        type(hg_error) :: err
        type(scene) :: particles
        integer, allocatable :: i(:), j(:)
        integer :: count, need
        integer(c_int32_t), pointer :: pairs(:, :)

        allocate (i(20000), j(20000))
        call particles%fill(seed=4, dimension=3, n=n, edge=edge, r_max=edge/8, grain=1)
        call grid%create()
        call grid%set(length_of(particles%x), length_of(particles%r))
        call grid%query_pairs(i, j, count, err)
        call check_works(err, 'query_pairs(i, j, count)')
        call grid%query_pairs(pairs)
        call check(count == size(pairs, 2), 'the number of pairs')
        call check(all(i(:count) == pairs(1, :)) .and. all(j(:count) == pairs(2, :)), 'the pairs')
        i = -5
        j = -5
        call grid%query_pairs(i(:count - 1), j, need, err)
        call check_fails(err, HG_ERR_CAPACITY, 'query_pairs: ', 'too little room')
        call check(need == count, 'what is needed')
        call check(all(i == -5) .and. all(j == -5), 'arrays that are too small are left alone')
        call grid%query_pairs(i(:0), j(:0), need, err)
        call check(need == count .and. err%code == HG_ERR_CAPACITY, 'what is needed, asked with nothing')
    end subroutine test_copies

    !> Pointers to nothing have the right shape.
    subroutine test_nothing()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(collector), allocatable :: visitor
        integer(c_int32_t), pointer :: pairs(:, :), shifts(:, :), ids(:)
        real(c_double), pointer :: vectors(:, :)
        integer :: i(1), j(1), count, dimension

        allocate (visitor)
        def = hg_default_grid_def()
        do dimension = 2, 3
            def%dimension = dimension
            call grid%create(def)
            call grid%query_pairs(pairs, vectors=vectors, shifts=shifts)
            call check(all(shape(pairs) == [2, 0]), 'no pairs')
            call check(all(shape(vectors) == [dimension, 0]), 'no vectors')
            call check(all(shape(shifts) == [dimension, 0]), 'no shifts')
            call grid%query_pairs(i, j, count)
            call check(count == 0, 'no pairs to copy')
            call grid%query_order(ids)
            call check(size(ids) == 0, 'no ids')
            call grid%visit_contacts(visitor)
            call check(visitor%batches == 0, 'no contacts')
        end do
    end subroutine test_nothing

    subroutine test_order()
        type(hg_grid) :: grid
        type(hg_error) :: err
        type(scene) :: particles
        integer(c_int32_t), pointer :: ids(:)
        logical :: seen(n)
        real(c_double), allocatable :: x(:, :)
        real(c_double) :: steps, steps_as_given
        integer :: k

        call particles%fill(seed=8, dimension=3, n=n, edge=edge, r_max=edge/64, grain=1)
        x = length_of(particles%x)
        call grid%create()
        call grid%set(x, length_of(particles%r))
        call grid%query_order(ids, err)
        call check_works(err, 'query_order')
        seen = .false.
        seen(ids) = .true.
        call check(size(ids) == n .and. all(seen), 'every id once')
        steps = sum([(norm2(x(:, ids(k)) - x(:, ids(k - 1))), k=2, n)])
        steps_as_given = sum([(norm2(x(:, k) - x(:, k - 1)), k=2, n)])
        call check(steps < 0.5_c_double*steps_as_given, 'near particles stand together')
    end subroutine test_order

    subroutine test_overlap()
        type(hg_grid) :: grid
        type(hg_grid_def) :: def
        type(hg_error) :: err
        real(c_double), parameter :: a(2) = [0.25_c_double, 0.5_c_double], &
            b(2) = [0.875_c_double, 0.5_c_double]
        logical :: yes

        def = hg_default_grid_def()
        def%dimension = 2
        def%periodic(1) = 1
        def%box_max(1) = 1
        call grid%create(def)
        call grid%overlap(a, 0.25_c_double, b, 0.25_c_double, yes, err)
        call check_works(err, 'overlap')
        call check(yes, 'spheres that overlap through the face')
        call grid%overlap(a, 0.125_c_double, b, 0.25_c_double, yes)
        call check(.not. yes, 'spheres that touch')
        call grid%overlap(real(a, c_float), 0.25_c_float, real(b, c_float), 0.25_c_float, yes)
        call check(yes, 'spheres of real32')
        call grid%overlap(a(:1), 1.0_c_double, b, 1.0_c_double, yes, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'xa(1) and xb(2)', 'a centre of one number')
        call check(.not. yes, 'a call that fails says no')
        call grid%overlap(a, -1.0_c_double, b, 1.0_c_double, yes, err)
        call check_fails(err, HG_ERR_ARGUMENT, 'radius_a = -1', 'a negative radius')
    end subroutine test_overlap

    subroutine test_never_created()
        type(hg_grid) :: grid
        type(hg_error) :: err
        type(collector), allocatable :: visitor
        integer(c_int32_t), pointer :: pairs(:, :), shifts(:, :), ids(:)
        real(c_double), pointer :: vectors(:, :)
        integer :: i(1), j(1), count
        real(c_double) :: x(3) = 0, r = 1
        logical :: yes
        character(len=*), parameter :: text = 'the grid was not created'

        allocate (visitor)
        call grid%query_pairs(pairs, vectors, shifts, err)
        call check_fails(err, HG_ERR_NULL, text, 'vectors and shifts')
        call check(.not. (associated(pairs) .or. associated(vectors) .or. associated(shifts)), 'results')
        call grid%query_pairs(pairs, vectors, err=err)
        call check_fails(err, HG_ERR_NULL, text, 'vectors')
        call grid%query_pairs(pairs, shifts, err)
        call check_fails(err, HG_ERR_NULL, text, 'shifts')
        call grid%query_pairs(i, j, count, err)
        call check_fails(err, HG_ERR_NULL, text, 'copies')
        call grid%visit_contacts(visitor, err)
        call check_fails(err, HG_ERR_NULL, text, 'visit_contacts')
        call grid%query_order(ids, err)
        call check_fails(err, HG_ERR_NULL, text, 'query_order')
        call grid%overlap(x, r, x, r, yes, err)
        call check_fails(err, HG_ERR_NULL, text, 'overlap')
    end subroutine test_never_created

end program test_contacts
