! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The calls that change which particles a grid holds and where they are.
submodule(hgrid) hgrid_particles
    use, intrinsic :: iso_c_binding, only: c_size_t
    use hgrid_c, only: c_hg_build, c_hg_clear, c_hg_insert, c_hg_move, c_hg_remove
    implicit none

contains

    module procedure insert_real64
        character(len=:), allocatable :: fault

        fault = self%misfit(shape(x), size(r))
        if (len(fault) > 0) then
            call raise(HG_ERR_ARGUMENT, 'insert: '//fault, err)
            return
        end if
        call self%conclude(c_hg_insert(self%handle, size(r, kind=c_size_t), x, r), 'insert', err)
    end procedure insert_real64

    module procedure insert_real32
        real(c_double), allocatable :: x64(:, :), r64(:)
        integer :: stat

        allocate (x64(size(x, 1), size(x, 2)), r64(size(r)), stat=stat)
        if (stat /= 0) then
            call raise(HG_ERR_MEMORY, 'insert: no memory for x and r as real64', err)
            return
        end if
        x64 = real(x, c_double)
        r64 = real(r, c_double)
        call self%insert_real64(x64, r64, err)
    end procedure insert_real32

    module procedure move_real64
        character(len=:), allocatable :: fault

        fault = self%misfit(shape(x), size(x, 2))
        if (len(fault) > 0) then
            call raise(HG_ERR_ARGUMENT, 'move: '//fault, err)
            return
        end if
        call self%conclude(c_hg_move(self%handle, size(x, 2, kind=c_size_t), x), 'move', err)
    end procedure move_real64

    module procedure move_radii_real64
        character(len=:), allocatable :: fault

        fault = self%misfit(shape(x), size(r))
        if (len(fault) > 0) then
            call raise(HG_ERR_ARGUMENT, 'move: '//fault, err)
            return
        end if
        call self%conclude(c_hg_move(self%handle, size(r, kind=c_size_t), x, r), 'move', err)
    end procedure move_radii_real64

    module procedure move_real32
        real(c_double), allocatable :: x64(:, :)
        integer :: stat

        allocate (x64(size(x, 1), size(x, 2)), stat=stat)
        if (stat /= 0) then
            call raise(HG_ERR_MEMORY, 'move: no memory for x as real64', err)
            return
        end if
        x64 = real(x, c_double)
        call self%move_real64(x64, err)
    end procedure move_real32

    module procedure move_radii_real32
        real(c_double), allocatable :: x64(:, :), r64(:)
        integer :: stat

        allocate (x64(size(x, 1), size(x, 2)), r64(size(r)), stat=stat)
        if (stat /= 0) then
            call raise(HG_ERR_MEMORY, 'move: no memory for x and r as real64', err)
            return
        end if
        x64 = real(x, c_double)
        r64 = real(r, c_double)
        call self%move_radii_real64(x64, r64, err)
    end procedure move_radii_real32

    module procedure remove
        call self%conclude(c_hg_remove(self%handle, size(ids, kind=c_size_t), ids), 'remove', err)
    end procedure remove

    module procedure clear
        call self%conclude(c_hg_clear(self%handle), 'clear', err)
    end procedure clear

    module procedure build
        call self%conclude(c_hg_build(self%handle), 'build', err)
    end procedure build

end submodule hgrid_particles
