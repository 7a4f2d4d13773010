/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Contact history: which pair of a new list was where in the list before it.
 *
 * Friction, bonds and adhesion remember something for each contact. hg_query_pairs gives contacts in an order of its
 * own, which changes when particles move, come or go. A history matches each new list to the one before, so that data
 * kept in an array beside the list can follow it.
 *
 * Pairs are compared as they are given: (a, b) is not (b, a). Any two numbers will do, so that contacts with walls may
 * stand in the same list, under ids that no particle has. Lists may be in any order. Where two particles have several
 * contacts at a time, lists of keys tell them apart by a third number.
 * Ownership: lists are copied; what calls return is borrowed until the next call that changes the history.
 * Threads: different histories are independent. On one history, hg_history_carry, hg_history_pairs and hg_history_keys
 * may run in several threads; all other calls need it for themselves. Errors: a call that fails has changed nothing.
 * Any call on a NULL history gives HG_ERR_NULL. Memory: 32 bytes for each pair of the longest lists, 64 for each key,
 * half of that to spare where lists grow; up to 34 (66) more for each while a list is matched, depending on how many
 * came, went or changed their order; up to 17 (33) for those that ended, once asked; 24 where pairs meet keys. It does
 * not depend on how large ids are. */
#ifndef HGRID_HISTORY_H
#define HGRID_HISTORY_H

#include <hgrid/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A list of pairs and how it follows from the one before. Created by hg_history_create, freed by hg_history_destroy. */
typedef struct hg_history hg_history;

/* What tells a contact from all others: two ids and a sub-key, each any number. Two lists of one history may be of
 * pairs and of keys: a pair (a, b) is the key (a, b, 0).
 *
 * The sub-key must stay the same as long as the contact lasts. It may be a place on a particle of several parts, the
 * number of a triangle of a wall, or which periodic image it is. The shifts of hg_query_pair_vectors tell that for
 * positions that are never wrapped into the box; a program that wraps them adds the difference of the numbers of times
 * that it has wrapped both particles. */
typedef struct hg_contact_key {
  int64_t a, b, sub;
} hg_contact_key;

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

/* The same for a list of keys: [count], none twice. */
HG_API hg_status hg_history_update_keys(hg_history *history, size_t count, const hg_contact_key *keys,
                                        const int64_t **previous);

/* Brings data of the contacts in the order of the list last given to hg_history_update: new_items[k] becomes
 * old_items[previous[k]], or zero bytes for a contact that is new. May be called for several arrays.
 * item_size: bytes for one contact, > 0. old_items: one for each pair of the list before; new_items: one for each pair
 * of the last list. Either may be NULL if its list is empty. They must not overlap.
 * Errors: HG_ERR_NULL; HG_ERR_ARGUMENT: item_size is 0 or the arrays overlap; HG_ERR_STATE: no list has been matched
 * since the history was created, cleared or restored. Complexity: O(count). */
HG_API hg_status hg_history_carry(const hg_history *history, size_t item_size, const void *old_items, void *new_items);

/* The contacts that ended with the last update: those of the list before that are not in the new one, in the order of
 * the list before. (*places)[k] is the place of (*pairs)[k] there: old_items[(*places)[k]] is what such a contact had
 * last. Both are NULL only if *count is 0.
 * Errors: HG_ERR_NULL; HG_ERR_STATE: no list has been matched since the history was created, cleared or restored, or
 * the list before was one of keys; HG_ERR_MEMORY. Complexity: O(length of both lists) in the first call after an
 * update, O(1) in others. */
HG_API hg_status hg_history_ended(hg_history *history, const hg_pair **pairs, const int64_t **places, size_t *count);

/* The same if the list before was one of keys; if it was one of pairs, HG_ERR_STATE. */
HG_API hg_status hg_history_ended_keys(hg_history *history, const hg_contact_key **keys, const int64_t **places,
                                       size_t *count);

/* The remembered list, e.g. to write it to a checkpoint. *pairs is NULL only if *count is 0.
 * Errors: HG_ERR_NULL; HG_ERR_STATE: it is a list of keys. */
HG_API hg_status hg_history_pairs(const hg_history *history, const hg_pair **pairs, size_t *count);

/* The same for a list of keys; for one of pairs, HG_ERR_STATE. The list of nothing is either. */
HG_API hg_status hg_history_keys(const hg_history *history, const hg_contact_key **keys, size_t *count);

/* Remembers a list without matching it, e.g. that of a checkpoint. The next hg_history_update refers to it.
 * Errors and complexity: as hg_history_update. */
HG_API hg_status hg_history_restore(hg_history *history, size_t count, const hg_pair *pairs);
HG_API hg_status hg_history_restore_keys(hg_history *history, size_t count, const hg_contact_key *keys);

/* Remembers an empty list. Memory is kept for what comes next. */
HG_API hg_status hg_history_clear(hg_history *history);

#ifdef __cplusplus
}
#endif

#endif
