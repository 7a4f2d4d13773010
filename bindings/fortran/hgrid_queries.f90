! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The calls that read a grid, but for those of many places (hgrid_bulk). A new query is all in
!> one file: the C call, the name, the procedure.
module hgrid_queries
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_float, &
        c_int32_t, c_int64_t, c_ptr, c_size_t, c_sizeof
    use hgrid_bulk, only: hg_bulk
    use hgrid_error, only: hg_error, number_text, raise, shape_text
    use hgrid_handle, only: c_hg_get_stats, conclude, dimension_of, handle_of
    use hgrid_types, only: hg_grid_stats, hg_level, hg_level_cost, HG_ERR_ARGUMENT, &
        HG_ERR_CAPACITY, HG_ERR_LIMIT, HG_HALF, HG_OK
    use hgrid_visit, only: hg_contact_visitor, hg_pair_procedure, hg_pair_visitor, &
        visit_contacts_with_object, visit_with_object, visit_with_procedure
    implicit none
    private

    public :: c_hg_copy_neighbors, c_hg_copy_pairs, c_hg_overlap, c_hg_query_level_costs
    public :: c_hg_query_levels, c_hg_query_neighbors, c_hg_query_order, c_hg_query_pair_vectors
    public :: c_hg_query_pairs, c_hg_query_sphere
    public :: hg_grid

    !> A grid: particles, and the search for pairs among them. It frees itself when it goes out of
    !> scope.
    type, extends(hg_bulk) :: hg_grid
    contains
        private
        procedure :: query_sphere_real64, query_sphere_real32
        procedure :: visit_pairs_object, visit_pairs_procedure
        procedure :: query_pair_list, query_vectors, query_shifts, copy_pairs
        procedure :: query_rows, copy_neighbors, copy_half_neighbors
        procedure :: overlap_real64, overlap_real32
        !> query_pairs(pairs), query_pairs(pairs, vectors=d, shifts=s): memory of the grid;
        !> query_pairs(i, j, count): into arrays of the caller's
        generic, public :: query_pairs => query_pair_list, query_vectors, query_shifts, copy_pairs
        !> visit_pairs(visit), visit_pairs(visitor): a function, or an object that extends
        !> hg_pair_visitor
        generic, public :: visit_pairs => visit_pairs_procedure, visit_pairs_object
        procedure, public :: visit_contacts
        !> query_neighbors(list, offsets, neighbors): memory of the grid;
        !> query_neighbors(list, point, neighbors, count), of HG_HALF without the first argument:
        !> into arrays of the caller's
        generic, public :: query_neighbors => query_rows, copy_neighbors, copy_half_neighbors
        !> query_sphere(center, radius, ids): the particles that a sphere overlaps
        generic, public :: query_sphere => query_sphere_real64, query_sphere_real32
        !> overlap(xa, ra, xb, rb, yes): whether two spheres interact, by the rule of the grid
        generic, public :: overlap => overlap_real64, overlap_real32
        procedure, public :: query_order
        procedure, public :: query_levels
        procedure, public :: query_level_costs
        procedure, public :: get_stats
    end type hg_grid

    interface
        function c_hg_query_pairs(grid, pairs, count) bind(c, name='hg_query_pairs') result(status)
            import
            type(c_ptr), value :: grid
            !> hg_pair[count], borrowed
            type(c_ptr), intent(out) :: pairs
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_query_pairs

        function c_hg_query_pair_vectors(grid, vectors, shifts) &
            bind(c, name='hg_query_pair_vectors') result(status)
            import
            type(c_ptr), value :: grid
            !> double[pairs][dimension], borrowed
            type(c_ptr), intent(out), optional :: vectors
            !> int32_t[pairs][dimension], borrowed
            type(c_ptr), intent(out), optional :: shifts
            integer(c_int32_t) :: status
        end function c_hg_query_pair_vectors

        function c_hg_copy_pairs(grid, capacity, a, b, count) bind(c, name='hg_copy_pairs') &
            result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: capacity
            !> (capacity), left alone if that is too small
            integer(c_int32_t), intent(inout) :: a(*), b(*)
            !> What is needed
            integer(c_size_t), intent(inout) :: count
            integer(c_int32_t) :: status
        end function c_hg_copy_pairs

        function c_hg_query_order(grid, ids, count) bind(c, name='hg_query_order') result(status)
            import
            type(c_ptr), value :: grid
            !> int32_t[count], borrowed
            type(c_ptr), intent(out) :: ids
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_query_order

        function c_hg_overlap(grid, center_a, radius_a, center_b, radius_b, overlaps) &
            bind(c, name='hg_overlap') result(status)
            import
            type(c_ptr), value :: grid
            !> (dimension)
            real(c_double), intent(in) :: center_a(*), center_b(*)
            !> Radii of the spheres
            real(c_double), value :: radius_a, radius_b
            !> 0 or 1
            integer(c_int32_t), intent(out) :: overlaps
            integer(c_int32_t) :: status
        end function c_hg_overlap

        function c_hg_query_neighbors(grid, list, offsets, neighbors) &
            bind(c, name='hg_query_neighbors') result(status)
            import
            type(c_ptr), value :: grid
            !> HG_HALF or HG_FULL
            integer(c_int32_t), value :: list
            !> int64_t[N + 1], borrowed
            type(c_ptr), intent(out) :: offsets
            !> int32_t[offsets[N]], borrowed
            type(c_ptr), intent(out) :: neighbors
            integer(c_int32_t) :: status
        end function c_hg_query_neighbors

        function c_hg_copy_neighbors(grid, list, capacity, offsets, neighbors, count) &
            bind(c, name='hg_copy_neighbors') result(status)
            import
            type(c_ptr), value :: grid
            !> HG_HALF or HG_FULL
            integer(c_int32_t), value :: list
            integer(c_size_t), value :: capacity
            !> (N + 1), from 0
            integer(c_int32_t), intent(inout) :: offsets(*)
            !> (capacity), left alone if that is too small
            integer(c_int32_t), intent(inout) :: neighbors(*)
            !> What is needed
            integer(c_size_t), intent(inout) :: count
            integer(c_int32_t) :: status
        end function c_hg_copy_neighbors

        function c_hg_query_sphere(grid, center, radius, ids, count) &
            bind(c, name='hg_query_sphere') result(status)
            import
            type(c_ptr), value :: grid
            !> (dimension)
            real(c_double), intent(in) :: center(*)
            !> Radius of the sphere
            real(c_double), value :: radius
            !> int32_t[count], borrowed
            type(c_ptr), intent(out) :: ids
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_query_sphere

        function c_hg_query_levels(grid, levels, count) bind(c, name='hg_query_levels') &
            result(status)
            import
            type(c_ptr), value :: grid
            !> hg_level[count], borrowed
            type(c_ptr), intent(out) :: levels
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_query_levels

        function c_hg_query_level_costs(grid, costs, count) &
            bind(c, name='hg_query_level_costs') result(status)
            import
            type(c_ptr), value :: grid
            !> hg_level_cost[count], borrowed
            type(c_ptr), intent(out) :: costs
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_query_level_costs
    end interface

    ! What pointers show when there is nothing: C then gives NULL, a Fortran result must be
    ! associated.
    integer(c_int32_t), target :: no_pairs(2, 0), no_ids(0), no_shifts(3, 0)
    real(c_double), target :: no_vectors(3, 0)
    type(hg_level), target :: no_levels(0)
    type(hg_level_cost), target :: no_costs(0)

contains

    !> All pairs, each once, pairs(1, k) < pairs(2, k), in the order of def%pair_order.
    subroutine query_pair_list(self, pairs, err)
        class(hg_grid), intent(in) :: self
        !> (2, count), ids; memory of the grid
        integer(c_int32_t), pointer, intent(out) :: pairs(:, :)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (pairs)
        status = c_hg_query_pairs(handle_of(self), memory, count)
        if (status == HG_OK) then
            pairs => no_pairs
            if (count > 0) call c_f_pointer(memory, pairs, [2_c_size_t, count])
        end if
        call conclude(self, status, 'query_pairs', err)
    end subroutine query_pair_list

    !> All pairs, what leads from the first particle of each to the image of the second that it
    !> meets, and which image that is, in whole edges of the periodic cell.
    subroutine query_vectors(self, pairs, vectors, shifts, err)
        class(hg_grid), intent(in) :: self
        !> (2, count), ids; memory of the grid
        integer(c_int32_t), pointer, intent(out) :: pairs(:, :)
        !> (dimension, count); memory of the grid
        real(c_double), pointer, intent(out) :: vectors(:, :)
        !> (dimension, count); memory of the grid
        integer(c_int32_t), pointer, intent(out), optional :: shifts(:, :)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        type(hg_error) :: problem
        integer(c_int32_t) :: status

        nullify (pairs, vectors)
        if (present(shifts)) nullify (shifts)
        status = c_hg_query_pair_vectors(handle_of(self), vectors=memory)
        if (status == HG_OK .and. present(shifts)) then
            call self%query_shifts(pairs, shifts, problem)
            status = problem%code
        else if (status == HG_OK) then
            call self%query_pair_list(pairs, problem)
            status = problem%code
        end if
        if (status == HG_OK) then
            vectors => no_vectors(:dimension_of(self), :)
            if (size(pairs) > 0) then
                call c_f_pointer(memory, vectors, [dimension_of(self), size(pairs, 2)])
            end if
        end if
        call conclude(self, status, 'query_pairs', err)
    end subroutine query_vectors

    !> The same without the vectors.
    subroutine query_shifts(self, pairs, shifts, err)
        class(hg_grid), intent(in) :: self
        !> (2, count), ids; memory of the grid
        integer(c_int32_t), pointer, intent(out) :: pairs(:, :)
        !> (dimension, count); memory of the grid
        integer(c_int32_t), pointer, intent(out) :: shifts(:, :)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        type(hg_error) :: problem
        integer(c_int32_t) :: status

        nullify (pairs, shifts)
        status = c_hg_query_pair_vectors(handle_of(self), shifts=memory)
        if (status == HG_OK) then
            call self%query_pair_list(pairs, problem)
            status = problem%code
        end if
        if (status == HG_OK) then
            shifts => no_shifts(:dimension_of(self), :)
            if (size(pairs) > 0) then
                call c_f_pointer(memory, shifts, [dimension_of(self), size(pairs, 2)])
            end if
        end if
        call conclude(self, status, 'query_pairs', err)
    end subroutine query_shifts

    !> All pairs into arrays of the caller's. If they are too small: HG_ERR_CAPACITY, count tells
    !> what is needed, and they are left alone.
    subroutine copy_pairs(self, i, j, count, err)
        class(hg_grid), intent(in) :: self
        !> Ids, i(k) < j(k)
        integer, intent(inout), contiguous :: i(:), j(:)
        !> Number of pairs
        integer, intent(out) :: count
        type(hg_error), intent(out), optional :: err

        integer(c_size_t) :: found
        integer(c_int32_t) :: status

        count = 0
        found = 0
        status = c_hg_copy_pairs(handle_of(self), int(min(size(i), size(j)), c_size_t), i, j, found)
        if (found > huge(count)) then
            call raise(HG_ERR_LIMIT, 'query_pairs: more pairs than an integer can count', err)
            return
        end if
        if (status == HG_OK .or. status == HG_ERR_CAPACITY) count = int(found)
        call conclude(self, status, 'query_pairs', err)
    end subroutine copy_pairs

    !> Hands all pairs with their geometry to an object, in batches: what a loop over forces wants.
    subroutine visit_contacts(self, visitor, err)
        class(hg_grid), intent(in) :: self
        !> Its procedure visit returns 0 to go on, anything else to end the visit
        class(hg_contact_visitor), intent(inout) :: visitor
        type(hg_error), intent(out), optional :: err

        call conclude(self, visit_contacts_with_object(handle_of(self), visitor), &
            'visit_contacts', err)
    end subroutine visit_contacts

    !> Hands all pairs to a function, in batches.
    subroutine visit_pairs_procedure(self, visit, err)
        class(hg_grid), intent(in) :: self
        !> Returns 0 to go on, anything else to end the visit; must not call the grid
        procedure(hg_pair_procedure) :: visit
        type(hg_error), intent(out), optional :: err

        call conclude(self, visit_with_procedure(handle_of(self), visit), 'visit_pairs', err)
    end subroutine visit_pairs_procedure

    !> Hands all pairs to an object, in batches.
    subroutine visit_pairs_object(self, visitor, err)
        class(hg_grid), intent(in) :: self
        !> Its procedure visit returns 0 to go on, anything else to end the visit
        class(hg_pair_visitor), intent(inout) :: visitor
        type(hg_error), intent(out), optional :: err

        call conclude(self, visit_with_object(handle_of(self), visitor), 'visit_pairs', err)
    end subroutine visit_pairs_object

    !> Neighbour lists in compressed rows: those of the k-th live particle in ascending id are
    !> neighbors(offsets(k) + 1:offsets(k + 1)), ascending.
    subroutine query_rows(self, list, offsets, neighbors, err)
        class(hg_grid), intent(in) :: self
        !> HG_HALF: only greater ids; HG_FULL: all
        integer(c_int32_t), intent(in) :: list
        !> (n + 1), starts with 0; memory of the grid
        integer(c_int64_t), pointer, intent(out) :: offsets(:)
        !> (offsets(n + 1)), ids; memory of the grid
        integer(c_int32_t), pointer, intent(out) :: neighbors(:)
        type(hg_error), intent(out), optional :: err

        type(hg_grid_stats) :: stats
        type(c_ptr) :: offset_memory, id_memory
        integer(c_int32_t) :: status
        integer(c_int64_t) :: count

        nullify (offsets, neighbors)
        status = c_hg_query_neighbors(handle_of(self), list, offset_memory, id_memory)
        if (status == HG_OK) status = c_hg_get_stats(handle_of(self), stats, c_sizeof(stats))
        if (status == HG_OK) then
            call c_f_pointer(offset_memory, offsets, [stats%particle_count + 1])
            count = offsets(stats%particle_count + 1)
            neighbors => no_ids
            if (count > 0) call c_f_pointer(id_memory, neighbors, [count])
        end if
        call conclude(self, status, 'query_neighbors', err)
    end subroutine query_rows

    !> The same into arrays of the caller's, counted from 1 as in old codes: the neighbours of the
    !> k-th live particle are neighbors(point(k):point(k + 1) - 1). If neighbors is too small:
    !> HG_ERR_CAPACITY, count tells what is needed, point is complete, and neighbors is left alone.
    subroutine copy_neighbors(self, list, point, neighbors, count, err)
        class(hg_grid), intent(in) :: self
        !> HG_HALF: only greater ids; HG_FULL: all
        integer(c_int32_t), intent(in) :: list
        !> At least (n + 1) for n particles
        integer, intent(inout), contiguous :: point(:)
        !> Ids
        integer, intent(inout), contiguous :: neighbors(:)
        !> Number of neighbours
        integer, intent(out) :: count
        type(hg_error), intent(out), optional :: err

        type(hg_grid_stats) :: stats
        integer(c_size_t) :: found
        integer(c_int32_t) :: status

        count = 0
        found = 0
        status = c_hg_get_stats(handle_of(self), stats, c_sizeof(stats))
        if (size(point) <= stats%particle_count) then
            call raise(HG_ERR_ARGUMENT, 'query_neighbors: point'//shape_text(shape(point))// &
                ' needs one place more than the grid has particles', err)
            return
        end if
        if (status == HG_OK) then
            status = c_hg_copy_neighbors(handle_of(self), list, size(neighbors, kind=c_size_t), &
                point, neighbors, found)
        end if
        if (status == HG_OK .or. status == HG_ERR_CAPACITY) then
            count = int(found)
            point(:stats%particle_count + 1) = point(:stats%particle_count + 1) + 1
        end if
        call conclude(self, status, 'query_neighbors', err)
    end subroutine copy_neighbors

    subroutine copy_half_neighbors(self, point, neighbors, count, err)
        class(hg_grid), intent(in) :: self
        !> At least (n + 1) for n particles
        integer, intent(inout), contiguous :: point(:)
        !> Ids
        integer, intent(inout), contiguous :: neighbors(:)
        !> Number of neighbours
        integer, intent(out) :: count
        type(hg_error), intent(out), optional :: err

        call self%query_neighbors(HG_HALF, point, neighbors, count, err)
    end subroutine copy_half_neighbors

    !> The particles that a sphere overlaps, by the grid's own rule; ids ascending, borrowed
    !> until this thread's next query_sphere.
    subroutine query_sphere_real64(self, center, radius, ids, err)
        class(hg_grid), intent(in) :: self
        !> (dimension)
        real(c_double), intent(in), contiguous :: center(:)
        !> >= 0
        real(c_double), intent(in) :: radius
        !> (count); memory of the library
        integer(c_int32_t), pointer, intent(out) :: ids(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (ids)
        if (c_associated(handle_of(self)) .and. size(center) /= dimension_of(self)) then
            call raise(HG_ERR_ARGUMENT, 'query_sphere: center'//shape_text(shape(center))// &
                ' does not fit a grid of dimension '//number_text(dimension_of(self)), err)
            return
        end if
        status = c_hg_query_sphere(handle_of(self), center, radius, memory, count)
        if (status == HG_OK) then
            ids => no_ids
            if (count > 0) call c_f_pointer(memory, ids, [count])
        end if
        call conclude(self, status, 'query_sphere', err)
    end subroutine query_sphere_real64

    subroutine query_sphere_real32(self, center, radius, ids, err)
        class(hg_grid), intent(in) :: self
        !> (dimension)
        real(c_float), intent(in) :: center(:)
        !> >= 0
        real(c_float), intent(in) :: radius
        !> (count); memory of the library
        integer(c_int32_t), pointer, intent(out) :: ids(:)
        type(hg_error), intent(out), optional :: err

        call self%query_sphere_real64(real(center, c_double), real(radius, c_double), ids, err)
    end subroutine query_sphere_real32

    !> The ids of all particles in an order in which near ones stand together.
    subroutine query_order(self, ids, err)
        class(hg_grid), intent(in) :: self
        !> (count); memory of the grid
        integer(c_int32_t), pointer, intent(out) :: ids(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (ids)
        status = c_hg_query_order(handle_of(self), memory, count)
        if (status == HG_OK) then
            ids => no_ids
            if (count > 0) call c_f_pointer(memory, ids, [count])
        end if
        call conclude(self, status, 'query_order', err)
    end subroutine query_order

    !> Whether two spheres interact that the grid need not hold.
    subroutine overlap_real64(self, xa, ra, xb, rb, yes, err)
        class(hg_grid), intent(in) :: self
        !> Centres (dimension)
        real(c_double), intent(in), contiguous :: xa(:), xb(:)
        !> Radii, >= 0
        real(c_double), intent(in) :: ra, rb
        !> The verdict
        logical, intent(out) :: yes
        type(hg_error), intent(out), optional :: err

        integer(c_int32_t) :: overlaps

        yes = .false.
        if (c_associated(handle_of(self)) .and. &
            any([size(xa), size(xb)] /= dimension_of(self))) then
            call raise(HG_ERR_ARGUMENT, 'overlap: xa'//shape_text(shape(xa))//' and xb'// &
                shape_text(shape(xb))//' do not both fit a grid of dimension '// &
                number_text(dimension_of(self)), err)
            return
        end if
        overlaps = 0
        call conclude(self, c_hg_overlap(handle_of(self), xa, ra, xb, rb, overlaps), 'overlap', err)
        yes = overlaps /= 0
    end subroutine overlap_real64

    subroutine overlap_real32(self, xa, ra, xb, rb, yes, err)
        class(hg_grid), intent(in) :: self
        !> Centres (dimension)
        real(c_float), intent(in) :: xa(:), xb(:)
        !> Radii, >= 0
        real(c_float), intent(in) :: ra, rb
        !> The verdict
        logical, intent(out) :: yes
        type(hg_error), intent(out), optional :: err

        call self%overlap_real64(real(xa, c_double), real(ra, c_double), real(xb, c_double), &
            real(rb, c_double), yes, err)
    end subroutine overlap_real32

    !> The levels as they stand, finest first.
    subroutine query_levels(self, levels, err)
        class(hg_grid), intent(in) :: self
        !> (count); memory of the grid
        type(hg_level), pointer, intent(out) :: levels(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (levels)
        status = c_hg_query_levels(handle_of(self), memory, count)
        if (status == HG_OK) then
            levels => no_levels
            if (count > 0) call c_f_pointer(memory, levels, [count])
        end if
        call conclude(self, status, 'query_levels', err)
    end subroutine query_levels

    !> The predicted cost of each number of levels that the rule looked at.
    subroutine query_level_costs(self, costs, err)
        class(hg_grid), intent(in) :: self
        !> (count), empty for HG_LEVELS_USER; memory of the grid
        type(hg_level_cost), pointer, intent(out) :: costs(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (costs)
        status = c_hg_query_level_costs(handle_of(self), memory, count)
        if (status == HG_OK) then
            costs => no_costs
            if (count > 0) call c_f_pointer(memory, costs, [count])
        end if
        call conclude(self, status, 'query_level_costs', err)
    end subroutine query_level_costs

    !> The counters of the grid as built and of the last search.
    subroutine get_stats(self, stats, err)
        class(hg_grid), intent(in) :: self
        !> A copy
        type(hg_grid_stats), intent(out) :: stats
        type(hg_error), intent(out), optional :: err

        call conclude(self, c_hg_get_stats(handle_of(self), stats, c_sizeof(stats)), &
            'get_stats', err)
    end subroutine get_stats

end module hgrid_queries
