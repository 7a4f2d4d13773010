! SPDX-FileCopyrightText: The libhgrid developers
! SPDX-License-Identifier: BSD-3-Clause

!> The C interface of contact histories.
module hgrid_history_c
    use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t, c_ptr, c_size_t
    implicit none
    private

    public :: c_hg_history_carry, c_hg_history_clear, c_hg_history_create, c_hg_history_destroy
    public :: c_hg_history_ended, c_hg_history_ended_keys, c_hg_history_keys, c_hg_history_pairs
    public :: c_hg_history_restore, c_hg_history_restore_keys
    public :: c_hg_history_update, c_hg_history_update_keys
    public :: hg_contact_key

    !> What tells a contact from all others: two ids and a sub-key.
    type, bind(c) :: hg_contact_key
        integer(c_int64_t) :: a, b, sub
    end type hg_contact_key

    interface
        function c_hg_history_create(history) bind(c, name='hg_history_create') result(status)
            import
            !> The new history, null on failure
            type(c_ptr), intent(out) :: history
            integer(c_int32_t) :: status
        end function c_hg_history_create

        subroutine c_hg_history_destroy(history) bind(c, name='hg_history_destroy')
            import
            !> The history; null is fine
            type(c_ptr), value :: history
        end subroutine c_hg_history_destroy

        function c_hg_history_update(history, count, pairs, previous) &
            bind(c, name='hg_history_update') result(status)
            import
            type(c_ptr), value :: history
            integer(c_size_t), value :: count
            !> hg_pair[count]
            type(c_ptr), value :: pairs
            !> int64_t[count], borrowed: places from 0, -1 for pairs that are new
            type(c_ptr), intent(out) :: previous
            integer(c_int32_t) :: status
        end function c_hg_history_update

        function c_hg_history_update_keys(history, count, keys, previous) &
            bind(c, name='hg_history_update_keys') result(status)
            import
            type(c_ptr), value :: history
            integer(c_size_t), value :: count
            !> hg_contact_key[count]
            type(c_ptr), value :: keys
            !> As in hg_history_update
            type(c_ptr), intent(out) :: previous
            integer(c_int32_t) :: status
        end function c_hg_history_update_keys

        function c_hg_history_carry(history, item_size, old_items, new_items) &
            bind(c, name='hg_history_carry') result(status)
            import
            type(c_ptr), value :: history
            !> Bytes for one contact
            integer(c_size_t), value :: item_size
            !> One item for each pair of the list before
            type(c_ptr), value :: old_items
            !> One item for each pair of the last list
            type(c_ptr), value :: new_items
            integer(c_int32_t) :: status
        end function c_hg_history_carry

        function c_hg_history_ended(history, pairs, places, count) &
            bind(c, name='hg_history_ended') result(status)
            import
            type(c_ptr), value :: history
            !> hg_pair[count], borrowed
            type(c_ptr), intent(out) :: pairs
            !> int64_t[count], borrowed: places in the list before, from 0
            type(c_ptr), intent(out) :: places
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_history_ended

        function c_hg_history_ended_keys(history, keys, places, count) &
            bind(c, name='hg_history_ended_keys') result(status)
            import
            type(c_ptr), value :: history
            !> hg_contact_key[count], borrowed
            type(c_ptr), intent(out) :: keys
            !> As in hg_history_ended
            type(c_ptr), intent(out) :: places
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_history_ended_keys

        function c_hg_history_pairs(history, pairs, count) bind(c, name='hg_history_pairs') &
            result(status)
            import
            type(c_ptr), value :: history
            !> hg_pair[count], borrowed
            type(c_ptr), intent(out) :: pairs
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_history_pairs

        function c_hg_history_keys(history, keys, count) bind(c, name='hg_history_keys') &
            result(status)
            import
            type(c_ptr), value :: history
            !> hg_contact_key[count], borrowed
            type(c_ptr), intent(out) :: keys
            integer(c_size_t), intent(out) :: count
            integer(c_int32_t) :: status
        end function c_hg_history_keys

        function c_hg_history_restore(history, count, pairs) bind(c, name='hg_history_restore') &
            result(status)
            import
            type(c_ptr), value :: history
            integer(c_size_t), value :: count
            !> hg_pair[count]
            type(c_ptr), value :: pairs
            integer(c_int32_t) :: status
        end function c_hg_history_restore

        function c_hg_history_restore_keys(history, count, keys) &
            bind(c, name='hg_history_restore_keys') result(status)
            import
            type(c_ptr), value :: history
            integer(c_size_t), value :: count
            !> hg_contact_key[count]
            type(c_ptr), value :: keys
            integer(c_int32_t) :: status
        end function c_hg_history_restore_keys

        function c_hg_history_clear(history) bind(c, name='hg_history_clear') result(status)
            import
            type(c_ptr), value :: history
            integer(c_int32_t) :: status
        end function c_hg_history_clear
    end interface

end module hgrid_history_c
