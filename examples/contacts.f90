! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> contacts PARTICLES.csv [CONTACTS.csv]: finds the contacts in a particle file, and writes them if
!> a second file is named.
!>
!> The header names x, y, z and r among its columns; lines that begin with # are skipped.
program contacts
    use, intrinsic :: iso_fortran_env, only: error_unit, int64, iostat_end, iostat_eor
    use hgrid, only: c_double, c_int32_t, hg_grid
    implicit none

    type(hg_grid) :: grid
    real(c_double), allocatable :: rows(:, :)
    integer(c_int32_t), pointer :: pairs(:, :)
    integer(int64) :: start, loaded, found, tick_rate
    integer :: n

    if (command_argument_count() < 1 .or. command_argument_count() > 2) then
        call fail('usage: contacts PARTICLES.csv [CONTACTS.csv]')
    end if
    call system_clock(start, tick_rate)
    call read_particles(argument(1), rows, n)
    call system_clock(loaded)
    call grid%create()
    call grid%insert(rows(1:3, :n), rows(4, :n))
    call grid%query_pairs(pairs)
    call system_clock(found)
    print '("particles ", i0)', n
    print '("contacts ", i0)', size(pairs, 2)
    print '("seconds", f12.6)', real(found - loaded, c_double)/real(tick_rate, c_double)
    print '("reading", f12.6)', real(loaded - start, c_double)/real(tick_rate, c_double)
    if (command_argument_count() == 2) call write_contacts(argument(2), pairs)

contains

    !> Reads x, y, z and r of all particles, in the order of the file.
    subroutine read_particles(path, rows, n)
        !> The file
        character(len=*), intent(in) :: path
        !> (4, at least n)
        real(c_double), allocatable, intent(out) :: rows(:, :)
        !> Number of particles
        integer, intent(out) :: n

        real(c_double), allocatable :: longer(:, :)
        integer, allocatable :: meaning(:)
        character(len=:), allocatable :: line
        integer :: unit, line_number, stat

        open (newunit=unit, file=path, status='old', action='read', iostat=stat)
        if (stat /= 0) call fail(path//': cannot be opened')
        line_number = 0
        if (.not. next_line(unit, path, line, line_number)) call fail(path//': no header')
        call read_header(line, place(path, line_number), meaning)
        allocate (rows(4, 1024))
        n = 0
        do while (next_line(unit, path, line, line_number))
            if (n == size(rows, 2)) then
                allocate (longer(4, 2*n))
                longer(:, :n) = rows
                call move_alloc(longer, rows)
            end if
            n = n + 1
            call read_row(line, meaning, path, line_number, rows(:, n))
        end do
        close (unit)
    end subroutine read_particles

    !> The next line that is neither empty nor a comment; false at the end of the file.
    function next_line(unit, path, line, line_number) result(got)
        !> The open file
        integer, intent(in) :: unit
        !> Its name
        character(len=*), intent(in) :: path
        !> The line, without a carriage return
        character(len=:), allocatable, intent(out) :: line
        !> Counts all lines
        integer, intent(inout) :: line_number
        logical :: got

        character(len=4096) :: buffer
        integer :: length, stat

        do
            read (unit, '(a)', advance='no', size=length, iostat=stat) buffer
            got = stat == iostat_eor
            line_number = line_number + 1
            if (stat == iostat_end) return
            if (stat == 0) call fail(place(path, line_number)//'longer than 4096 characters')
            if (.not. got) call fail(place(path, line_number)//'cannot be read')
            if (length > 0) then
                if (buffer(length:length) == achar(13)) length = length - 1
            end if
            if (length > 0 .and. buffer(1:1) /= '#') exit
        end do
        line = buffer(:length)
    end function next_line

    !> What each column holds: 1 to 4 for x, y, z and r, 0 for anything else.
    subroutine read_header(line, here, meaning)
        !> Names between commas
        character(len=*), intent(in) :: line
        !> Where the line is, for messages
        character(len=*), intent(in) :: here
        !> (number of columns)
        integer, allocatable, intent(out) :: meaning(:)

        character(len=*), parameter :: wanted = 'xyzr'
        character(len=:), allocatable :: name
        integer :: first, last, k

        allocate (meaning(0))
        first = 1
        do while (first <= len(line) + 1)
            last = end_of_field(line, first)
            name = trim(adjustl(line(first:last)))
            k = 0
            if (name == 'radius') name = 'r'
            if (len(name) == 1) k = index(wanted, name)
            if (k > 0 .and. any(meaning == k)) call fail(here//'two columns are named '//name)
            meaning = [meaning, k]
            first = last + 2
        end do
        do k = 1, 4
            if (all(meaning /= k)) call fail(here//'no column is named '//wanted(k:k))
        end do
    end subroutine read_header

    !> Reads the wanted numbers of one particle.
    subroutine read_row(line, meaning, path, line_number, row)
        !> Values between commas
        character(len=*), intent(in) :: line
        !> Of the columns
        integer, intent(in) :: meaning(:)
        !> Name of the file
        character(len=*), intent(in) :: path
        !> Where the line is in it
        integer, intent(in) :: line_number
        !> x, y, z, r
        real(c_double), intent(out) :: row(4)

        integer :: column, first, last, stat

        row = 0
        first = 1
        do column = 1, size(meaning)
            if (first > len(line) + 1) call fail(place(path, line_number)//'too few values')
            last = end_of_field(line, first)
            if (meaning(column) > 0) then
                ! List-directed input would take "1/2" or "3*4" for numbers.
                stat = verify(trim(adjustl(line(first:last))), '+-.0123456789eE')
                if (stat == 0) read (line(first:last), *, iostat=stat) row(meaning(column))
                if (stat /= 0) then
                    call fail(place(path, line_number)//'not a number: "'//line(first:last)//'"')
                end if
            end if
            first = last + 2
        end do
        if (first <= len(line) + 1) call fail(place(path, line_number)//'too many values')
    end subroutine read_row

    !> Index of the last character before the next comma, or of the line.
    pure function end_of_field(line, first) result(last)
        !> Fields between commas
        character(len=*), intent(in) :: line
        !> Where the field begins
        integer, intent(in) :: first
        integer :: last

        last = index(line(first:), ',')
        last = merge(len(line), first + last - 2, last == 0)
    end function end_of_field

    subroutine write_contacts(path, pairs)
        !> The file to write
        character(len=*), intent(in) :: path
        !> (2, count)
        integer(c_int32_t), intent(in) :: pairs(:, :)

        integer :: unit, stat, k

        open (newunit=unit, file=path, status='replace', action='write', iostat=stat)
        if (stat /= 0) call fail(path//': cannot be written')
        write (unit, '(a)') 'a,b'
        do k = 1, size(pairs, 2)
            write (unit, '(i0,",",i0)') pairs(:, k)
        end do
        close (unit)
    end subroutine write_contacts

    function argument(number) result(text)
        !> Counts from 1
        integer, intent(in) :: number
        character(len=:), allocatable :: text

        integer :: length

        call get_command_argument(number, length=length)
        allocate (character(len=length) :: text)
        call get_command_argument(number, text)
    end function argument

    function place(path, line_number) result(text)
        !> Name of the file
        character(len=*), intent(in) :: path
        !> Counts from 1
        integer, intent(in) :: line_number
        character(len=:), allocatable :: text

        character(len=12) :: digits

        write (digits, '(i0)') line_number
        text = path//':'//trim(digits)//': '
    end function place

    subroutine fail(message)
        !> What went wrong
        character(len=*), intent(in) :: message

        write (error_unit, '(2a)') 'contacts: ', message
        stop 1
    end subroutine fail

end program contacts
