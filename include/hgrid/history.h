/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Contact history: which pair of a new list was where in the list before it.
 *
 * Friction, bonds and adhesion remember something for each contact. hg_query_pairs gives contacts in an order of its
 * own, which changes when particles move, come or go. A history matches each new list to the one before, so that data
 * kept in an array beside the list can follow it.
 *
 * Pairs are compared as they are given: (a, b) is not (b, a). Any two numbers will do, so that contacts with walls may
 * stand in the same list, under ids that no particle has. Lists may be in any order.
 * Ownership: lists are copied; what calls return is borrowed until the next call that changes the history.
 * Threads: different histories are independent. On one history, hg_history_carry and hg_history_pairs may run in
 * several threads; all other calls need it for themselves. Errors: a call that fails has changed nothing. Any call on a
 * NULL history gives HG_ERR_NULL. Memory: 32 bytes for each pair of the longest lists, and up to 34 more for each while
 * a list is matched, depending on how many pairs came, went or changed their order. It does not depend on how large ids
 * are. */
#ifndef HGRID_HISTORY_H
#define HGRID_HISTORY_H

#include <hgrid/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A list of pairs and how it follows from the one before. Created by hg_history_create, freed by hg_history_destroy. */
typedef struct hg_history hg_history;

/* Creates a history that remembers an empty list. On failure *history is NULL.
 * Memory comes from the allocator that hg_set_allocator has set.
 * Errors: HG_ERR_NULL, HG_ERR_MEMORY. */
HG_API hg_status hg_history_create(hg_history **history);

/* Frees the history and what it lent. NULL is fine. */
HG_API void hg_history_destroy(hg_history *history);

/* Matches a new list to the remembered one, and remembers the new one instead.
 * pairs: [count], may be NULL if count is 0.
 * (*previous)[k], k < count, is the place of pairs[k] in the former list, or -1 if it was not there. *previous is NULL
 * only if count is 0.
 * Errors: HG_ERR_NULL; HG_ERR_ARGUMENT: the list holds a pair twice (the text names both places); HG_ERR_MEMORY.
 * Complexity: O(length of both lists), expected, whatever the ids; fastest where pairs follow one another as before. */
HG_API hg_status hg_history_update(hg_history *history, size_t count, const hg_pair *pairs, const int64_t **previous);

/* Brings data of the contacts in the order of the list last given to hg_history_update: new_items[k] becomes
 * old_items[previous[k]], or zero bytes for a contact that is new. May be called for several arrays.
 * item_size: bytes for one contact, > 0. old_items: one for each pair of the list before; new_items: one for each pair
 * of the last list. Either may be NULL if its list is empty. They must not overlap.
 * Errors: HG_ERR_NULL; HG_ERR_ARGUMENT: item_size is 0 or the arrays overlap; HG_ERR_STATE: no list has been matched
 * since the history was created, cleared or restored. Complexity: O(count). */
HG_API hg_status hg_history_carry(const hg_history *history, size_t item_size, const void *old_items, void *new_items);

/* The remembered list, e.g. to write it to a checkpoint. *pairs is NULL only if *count is 0.
 * Errors: HG_ERR_NULL. */
HG_API hg_status hg_history_pairs(const hg_history *history, const hg_pair **pairs, size_t *count);

/* Remembers a list without matching it, e.g. that of a checkpoint. The next hg_history_update refers to it.
 * Errors and complexity: as hg_history_update. */
HG_API hg_status hg_history_restore(hg_history *history, size_t count, const hg_pair *pairs);

/* Remembers an empty list. Memory is kept for what comes next. */
HG_API hg_status hg_history_clear(hg_history *history);

#ifdef __cplusplus
}
#endif

#endif
