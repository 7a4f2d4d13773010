! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The calls that read a grid.
submodule(hgrid) hgrid_queries
    use, intrinsic :: iso_c_binding, only: c_f_pointer, c_size_t
    use hgrid_c, only: c_hg_query_level_costs, c_hg_query_levels, c_hg_query_neighbors, &
        c_hg_query_pairs, c_hg_query_sphere
    use hgrid_visit, only: visit_with_object, visit_with_procedure
    implicit none

    ! What pointers show when there is nothing: C then gives NULL, a Fortran result must be
    ! associated.
    integer(c_int32_t), target :: no_pairs(2, 0), no_ids(0)
    type(hg_level), target :: no_levels(0)
    type(hg_level_cost), target :: no_costs(0)

contains

    module procedure query_pairs
        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (pairs)
        status = c_hg_query_pairs(self%handle, memory, count)
        if (status == HG_OK) then
            pairs => no_pairs
            if (count > 0) call c_f_pointer(memory, pairs, [2_c_size_t, count])
        end if
        call self%conclude(status, 'query_pairs', err)
    end procedure query_pairs

    module procedure visit_pairs_procedure
        call self%conclude(visit_with_procedure(self%handle, visit), 'visit_pairs', err)
    end procedure visit_pairs_procedure

    module procedure visit_pairs_object
        call self%conclude(visit_with_object(self%handle, visitor), 'visit_pairs', err)
    end procedure visit_pairs_object

    module procedure query_neighbors
        type(hg_grid_stats) :: stats
        type(c_ptr) :: offset_memory, id_memory
        integer(c_int32_t) :: status
        integer(c_int64_t) :: count

        nullify (offsets, neighbors)
        status = c_hg_query_neighbors(self%handle, list, offset_memory, id_memory)
        if (status == HG_OK) status = c_hg_get_stats(self%handle, stats, c_sizeof(stats))
        if (status == HG_OK) then
            call c_f_pointer(offset_memory, offsets, [stats%particle_count + 1])
            count = offsets(stats%particle_count + 1)
            neighbors => no_ids
            if (count > 0) call c_f_pointer(id_memory, neighbors, [count])
        end if
        call self%conclude(status, 'query_neighbors', err)
    end procedure query_neighbors

    module procedure query_sphere_real64
        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (ids)
        if (c_associated(self%handle) .and. size(center) /= self%dimension) then
            call raise(HG_ERR_ARGUMENT, 'query_sphere: center'//shape_text(shape(center))// &
                ' does not fit a grid of dimension '//number_text(self%dimension), err)
            return
        end if
        status = c_hg_query_sphere(self%handle, center, radius, memory, count)
        if (status == HG_OK) then
            ids => no_ids
            if (count > 0) call c_f_pointer(memory, ids, [count])
        end if
        call self%conclude(status, 'query_sphere', err)
    end procedure query_sphere_real64

    module procedure query_sphere_real32
        call self%query_sphere_real64(real(center, c_double), real(radius, c_double), ids, err)
    end procedure query_sphere_real32

    module procedure query_levels
        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (levels)
        status = c_hg_query_levels(self%handle, memory, count)
        if (status == HG_OK) then
            levels => no_levels
            if (count > 0) call c_f_pointer(memory, levels, [count])
        end if
        call self%conclude(status, 'query_levels', err)
    end procedure query_levels

    module procedure query_level_costs
        type(c_ptr) :: memory
        integer(c_size_t) :: count
        integer(c_int32_t) :: status

        nullify (costs)
        status = c_hg_query_level_costs(self%handle, memory, count)
        if (status == HG_OK) then
            costs => no_costs
            if (count > 0) call c_f_pointer(memory, costs, [count])
        end if
        call self%conclude(status, 'query_level_costs', err)
    end procedure query_level_costs

    module procedure get_stats
        call self%conclude(c_hg_get_stats(self%handle, stats, c_sizeof(stats)), 'get_stats', err)
    end procedure get_stats

end submodule hgrid_queries
