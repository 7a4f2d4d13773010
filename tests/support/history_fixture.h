/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* What the tests of contact histories start from: one that has matched a list to another, and what it must then say. */
#pragma once

#include "tests/support/fixture.h"

/* A history that has seen `kBefore`, then `kAfter`. */
enum { BEFORE_COUNT = 4, AFTER_COUNT = 5 };
extern const hg_pair kBefore[BEFORE_COUNT], kAfter[AFTER_COUNT];
hg_history *make_history(void);

/* A history that has seen `kKeysBefore`, then `kKeysAfter`. */
enum { KEYS_BEFORE_COUNT = 2, KEYS_AFTER_COUNT = 3 };
extern const hg_contact_key kKeysBefore[KEYS_BEFORE_COUNT], kKeysAfter[KEYS_AFTER_COUNT];
hg_history *make_keyed_history(void);

/* A history that has seen nothing. */
hg_history *make_empty_history(void);

/* The history is as make_history left it: its list, and what it carries. */
void assert_history(const hg_history *history);

/* The history remembers exactly this list. */
void assert_remembers(const hg_history *history, const hg_pair *pairs, size_t count);

/* The same for keys. */
void assert_remembers_keys(const hg_history *history, const hg_contact_key *keys, size_t count);

/* MANY other pairs: more than a history of few has room for. */
enum { MANY = 1000 };
const hg_pair *many_pairs(void);

/* Up to MANY pairs as keys, each with a sub-key that is not 0; overwritten by the next call. */
const hg_contact_key *keys_of(size_t count, const hg_pair *pairs);

/* Runs `call` for a history as make_history leaves it and the many pairs, with each of its allocations refused in turn:
 * the history stays as it was and then remembers them. The result is the number of requests that were refused. */
typedef hg_status history_call(hg_history *history, size_t count, const hg_pair *pairs);
long long refuse_each_allocation_for_many(history_call *call);

/* The same with another check of what the history then knows. */
long long refuse_each_allocation_of(history_call *call, void (*check)(hg_history *history));

/* hg_history_update with this list says that its pairs were at these places. */
void assert_update(hg_history *history, const hg_pair *pairs, size_t count, const int64_t *expected);
