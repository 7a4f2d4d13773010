! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> Many questions at once about the places of particles. The answers are rows: what question k
!> found is ids(offsets(k) + 1:offsets(k + 1)), ascending.
module hgrid_bulk
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_float, &
        c_int32_t, c_int64_t, c_ptr, c_size_t
    use hgrid_error, only: hg_error, number_text, raise, shape_text
    use hgrid_handle, only: conclude, dimension_of, handle_of
    use hgrid_sets, only: hg_sets
    use hgrid_types, only: HG_ERR_ARGUMENT, HG_OK
    implicit none
    private

    public :: c_hg_query_boxes, c_hg_query_spheres, c_hg_query_triangles
    public :: hg_bulk

    !> A grid that answers them.
    type, extends(hg_sets) :: hg_bulk
    contains
        private
        procedure :: query_spheres_real64, query_spheres_real32
        procedure :: query_boxes_real64, query_boxes_real32
        procedure :: query_triangles_real64, query_triangles_real32
        !> query_spheres(centers, radii, offsets, ids): the particles that each sphere overlaps
        generic, public :: query_spheres => query_spheres_real64, query_spheres_real32
        !> query_boxes(low, high, offsets, ids): the particles that each aligned box meets
        generic, public :: query_boxes => query_boxes_real64, query_boxes_real32
        !> query_triangles(corners, offsets, ids): the particles that each triangle meets
        generic, public :: query_triangles => query_triangles_real64, query_triangles_real32
    end type hg_bulk

    interface
        function c_hg_query_spheres(grid, count, centers, radii, offsets, ids) &
            bind(c, name='hg_query_spheres') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> (dimension, count)
            real(c_double), intent(in) :: centers(*)
            !> (count)
            real(c_double), intent(in) :: radii(*)
            !> int64_t[count + 1], borrowed
            type(c_ptr), intent(out) :: offsets
            !> int32_t[offsets[count]], borrowed
            type(c_ptr), intent(out) :: ids
            integer(c_int32_t) :: status
        end function c_hg_query_spheres

        function c_hg_query_boxes(grid, count, low, high, offsets, ids) &
            bind(c, name='hg_query_boxes') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> (dimension, count)
            real(c_double), intent(in) :: low(*), high(*)
            !> int64_t[count + 1], borrowed
            type(c_ptr), intent(out) :: offsets
            !> int32_t[offsets[count]], borrowed
            type(c_ptr), intent(out) :: ids
            integer(c_int32_t) :: status
        end function c_hg_query_boxes

        function c_hg_query_triangles(grid, count, corners, offsets, ids) &
            bind(c, name='hg_query_triangles') result(status)
            import
            type(c_ptr), value :: grid
            integer(c_size_t), value :: count
            !> (3, 3 corners, count)
            real(c_double), intent(in) :: corners(*)
            !> int64_t[count + 1], borrowed
            type(c_ptr), intent(out) :: offsets
            !> int32_t[offsets[count]], borrowed
            type(c_ptr), intent(out) :: ids
            integer(c_int32_t) :: status
        end function c_hg_query_triangles
    end interface

    !> Where nothing is found.
    integer(c_int32_t), target :: no_ids(0)

contains

    !> The particles that spheres overlap, by the grid's own rule; borrowed until this thread's next
    !> query_spheres.
    subroutine query_spheres_real64(self, centers, radii, offsets, ids, err)
        class(hg_bulk), intent(in) :: self
        !> (dimension, n)
        real(c_double), intent(in), contiguous :: centers(:, :)
        !> (n), >= 0
        real(c_double), intent(in), contiguous :: radii(:)
        !> (n + 1), starts with 0; memory of the library
        integer(c_int64_t), pointer, intent(out) :: offsets(:)
        !> (offsets(n + 1)); memory of the library
        integer(c_int32_t), pointer, intent(out) :: ids(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: offset_memory, id_memory
        integer(c_int32_t) :: status

        nullify (offsets, ids)
        if (misfit(self, 'query_spheres: centers', shape(centers), err)) return
        if (size(centers, 2) /= size(radii)) then
            call raise(HG_ERR_ARGUMENT, 'query_spheres: centers'//shape_text(shape(centers))// &
                ' and radii'//shape_text(shape(radii))//' differ in the number of spheres', err)
            return
        end if
        status = c_hg_query_spheres(handle_of(self), size(radii, kind=c_size_t), centers, radii, &
            offset_memory, id_memory)
        if (status == HG_OK) call take_rows(offset_memory, id_memory, size(radii), offsets, ids)
        call conclude(self, status, 'query_spheres', err)
    end subroutine query_spheres_real64

    subroutine query_spheres_real32(self, centers, radii, offsets, ids, err)
        class(hg_bulk), intent(in) :: self
        !> (dimension, n)
        real(c_float), intent(in) :: centers(:, :)
        !> (n), >= 0
        real(c_float), intent(in) :: radii(:)
        !> (n + 1), starts with 0; memory of the library
        integer(c_int64_t), pointer, intent(out) :: offsets(:)
        !> (offsets(n + 1)); memory of the library
        integer(c_int32_t), pointer, intent(out) :: ids(:)
        type(hg_error), intent(out), optional :: err

        call self%query_spheres_real64(real(centers, c_double), real(radii, c_double), offsets, &
            ids, err)
    end subroutine query_spheres_real32

    !> The particles that aligned boxes meet; borrowed until this thread's next query_boxes.
    subroutine query_boxes_real64(self, low, high, offsets, ids, err)
        class(hg_bulk), intent(in) :: self
        !> Corners (dimension, n), low <= high, may be infinite
        real(c_double), intent(in), contiguous :: low(:, :), high(:, :)
        !> (n + 1), starts with 0; memory of the library
        integer(c_int64_t), pointer, intent(out) :: offsets(:)
        !> (offsets(n + 1)); memory of the library
        integer(c_int32_t), pointer, intent(out) :: ids(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: offset_memory, id_memory
        integer(c_int32_t) :: status

        nullify (offsets, ids)
        if (misfit(self, 'query_boxes: low', shape(low), err)) return
        if (any(shape(low) /= shape(high))) then
            call raise(HG_ERR_ARGUMENT, 'query_boxes: low'//shape_text(shape(low))// &
                ' and high'//shape_text(shape(high))//' differ in shape', err)
            return
        end if
        status = c_hg_query_boxes(handle_of(self), size(low, 2, kind=c_size_t), low, high, &
            offset_memory, id_memory)
        if (status == HG_OK) call take_rows(offset_memory, id_memory, size(low, 2), offsets, ids)
        call conclude(self, status, 'query_boxes', err)
    end subroutine query_boxes_real64

    subroutine query_boxes_real32(self, low, high, offsets, ids, err)
        class(hg_bulk), intent(in) :: self
        !> Corners (dimension, n), low <= high, may be infinite
        real(c_float), intent(in) :: low(:, :), high(:, :)
        !> (n + 1), starts with 0; memory of the library
        integer(c_int64_t), pointer, intent(out) :: offsets(:)
        !> (offsets(n + 1)); memory of the library
        integer(c_int32_t), pointer, intent(out) :: ids(:)
        type(hg_error), intent(out), optional :: err

        call self%query_boxes_real64(real(low, c_double), real(high, c_double), offsets, ids, err)
    end subroutine query_boxes_real32

    !> The particles that triangles in space meet; borrowed until this thread's next
    !> query_triangles.
    subroutine query_triangles_real64(self, corners, offsets, ids, err)
        class(hg_bulk), intent(in) :: self
        !> (3, 3 corners, n)
        real(c_double), intent(in), contiguous :: corners(:, :, :)
        !> (n + 1), starts with 0; memory of the library
        integer(c_int64_t), pointer, intent(out) :: offsets(:)
        !> (offsets(n + 1)); memory of the library
        integer(c_int32_t), pointer, intent(out) :: ids(:)
        type(hg_error), intent(out), optional :: err

        type(c_ptr) :: offset_memory, id_memory
        integer(c_int32_t) :: status

        nullify (offsets, ids)
        if (size(corners, 1) /= 3 .or. size(corners, 2) /= 3) then
            call raise(HG_ERR_ARGUMENT, 'query_triangles: corners'//shape_text(shape(corners))// &
                ' are not corners(3,3,n)', err)
            return
        end if
        status = c_hg_query_triangles(handle_of(self), size(corners, 3, kind=c_size_t), corners, &
            offset_memory, id_memory)
        if (status == HG_OK) then
            call take_rows(offset_memory, id_memory, size(corners, 3), offsets, ids)
        end if
        call conclude(self, status, 'query_triangles', err)
    end subroutine query_triangles_real64

    subroutine query_triangles_real32(self, corners, offsets, ids, err)
        class(hg_bulk), intent(in) :: self
        !> (3, 3 corners, n)
        real(c_float), intent(in) :: corners(:, :, :)
        !> (n + 1), starts with 0; memory of the library
        integer(c_int64_t), pointer, intent(out) :: offsets(:)
        !> (offsets(n + 1)); memory of the library
        integer(c_int32_t), pointer, intent(out) :: ids(:)
        type(hg_error), intent(out), optional :: err

        call self%query_triangles_real64(real(corners, c_double), offsets, ids, err)
    end subroutine query_triangles_real32

    !> True, and the failure is reported, if points do not have the dimension of a created grid.
    function misfit(self, what, extents, err) result(wrong)
        class(hg_bulk), intent(in) :: self
        !> The Fortran call and the argument
        character(len=*), intent(in) :: what
        !> The shape of the argument
        integer, intent(in) :: extents(:)
        type(hg_error), intent(out), optional :: err
        logical :: wrong

        wrong = .false.
        if (c_associated(handle_of(self))) wrong = extents(1) /= dimension_of(self)
        if (wrong) then
            call raise(HG_ERR_ARGUMENT, what//shape_text(extents)// &
                ' does not fit a grid of dimension '//number_text(dimension_of(self)), err)
        end if
    end function misfit

    subroutine take_rows(offset_memory, id_memory, rows, offsets, ids)
        !> What C lends
        type(c_ptr), intent(in) :: offset_memory, id_memory
        !> How many there are
        integer, intent(in) :: rows
        !> (rows + 1)
        integer(c_int64_t), pointer, intent(out) :: offsets(:)
        !> (offsets(rows + 1))
        integer(c_int32_t), pointer, intent(out) :: ids(:)

        call c_f_pointer(offset_memory, offsets, [rows + 1])
        ids => no_ids
        if (offsets(rows + 1) > 0) call c_f_pointer(id_memory, ids, [offsets(rows + 1)])
    end subroutine take_rows

end module hgrid_bulk
