/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* An allocator for hg_set_allocator that keeps the books and can refuse a chosen allocation. */
#pragma once

#include <hgrid/hgrid.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Books of the allocator. They are process-wide since grids created with it may outlive a test's stack frame. */
typedef struct alloc_books {
  long long calls;       /* requests for memory so far, refused ones included */
  long long live_blocks; /* blocks not released yet */
  long long live_bytes;  /* by the sizes asked for */
  long long faults;      /* blocks released or resized with another size than they were asked with */
  long long refused;     /* requests refused since arming */
} alloc_books;

/* Makes the library use this allocator for grids created from now on, with all books at zero and nothing refused. */
void failing_alloc_install(void);

/* Back to malloc for grids created from now on. */
void failing_alloc_remove(void);

/* Refuses the request number `countdown` from now (0 = the next), once; a negative number refuses none. */
void failing_alloc_arm(long long countdown);

/* A copy of the books. */
alloc_books failing_alloc_books(void);

/* Runs one scenario with each of its allocations refused in turn.
 *
 * For n = 0, 1, 2 ...: `prepare` makes a grid (nothing is refused), then `act` runs with its n-th request refused and
 * must give HG_ERR_MEMORY; then `unchanged` checks that the grid is as `prepare` left it; `act` then succeeds and
 * `done` checks its result. It ends with the first n that is never reached, and fails if memory is left over when the
 * grid is gone. The result is the number of requests that were refused. `unchanged` may be NULL. `act` gets the grid;
 * for hg_create it gets NULL when `prepare` is NULL. */
typedef struct alloc_scenario {
  void (*prepare)(hg_grid **grid);
  hg_status (*act)(hg_grid **grid);
  void (*unchanged)(hg_grid *grid);
  void (*done)(hg_grid *grid);
} alloc_scenario;

long long refuse_each_allocation(const alloc_scenario *scenario);

/* The same for a call on a chain that must stay one, looked at after each refusal or at the end only. */
long long refuse_each_allocation_on_chain(hg_status (*call)(hg_grid *grid));

#ifdef __cplusplus
}
#endif
