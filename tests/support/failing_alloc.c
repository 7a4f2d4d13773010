/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Books are kept under a lock: worker threads of a grid may ask for memory too. */
#include "tests/support/failing_alloc.h"

#include "tests/support/fixture.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

/* In front of each block: the size it was asked with. 16 keeps the alignment of malloc. */
enum { HEAD = 16 };

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static alloc_books books;
static long long countdown = -1;

/* Whether this request is granted; called with the lock held. */
static int granted(void) {
  ++books.calls;
  if (countdown < 0 || countdown-- > 0) return 1;
  ++books.refused;
  return 0;
}

static void *books_allocate(void *context, size_t size) {
  unsigned char *memory = NULL;
  (void)context;
  pthread_mutex_lock(&lock);
  if (granted()) memory = malloc(size + HEAD);
  if (memory != NULL) {
    memcpy(memory, &size, sizeof size);
    ++books.live_blocks;
    books.live_bytes += (long long)size;
  }
  pthread_mutex_unlock(&lock);
  return memory == NULL ? NULL : memory + HEAD;
}

/* Called with the lock held. */
static void check_size(const unsigned char *head, size_t told) {
  size_t asked;
  memcpy(&asked, head, sizeof asked);
  if (asked != told) ++books.faults;
}

static void *books_reallocate(void *context, void *memory, size_t old_size, size_t new_size) {
  unsigned char *head, *grown = NULL;
  if (memory == NULL) return books_allocate(context, new_size);
  head = (unsigned char *)memory - HEAD;
  pthread_mutex_lock(&lock);
  check_size(head, old_size);
  if (granted()) grown = realloc(head, new_size + HEAD);
  if (grown != NULL) {
    memcpy(grown, &new_size, sizeof new_size);
    books.live_bytes += (long long)new_size - (long long)old_size;
  }
  pthread_mutex_unlock(&lock);
  return grown == NULL ? NULL : grown + HEAD;
}

static void books_release(void *context, void *memory, size_t size) {
  unsigned char *head;
  (void)context;
  if (memory == NULL) return;
  head = (unsigned char *)memory - HEAD;
  pthread_mutex_lock(&lock);
  check_size(head, size);
  --books.live_blocks;
  books.live_bytes -= (long long)size;
  pthread_mutex_unlock(&lock);
  free(head);
}

void failing_alloc_install(void) {
  hg_allocator allocator;
  allocator.context = NULL;
  allocator.allocate = books_allocate;
  allocator.reallocate = books_reallocate;
  allocator.release = books_release;
  pthread_mutex_lock(&lock);
  memset(&books, 0, sizeof books);
  countdown = -1;
  pthread_mutex_unlock(&lock);
  assert_ok(hg_set_allocator(&allocator));
}

void failing_alloc_remove(void) { assert_ok(hg_set_allocator(NULL)); }

void failing_alloc_arm(long long refuse_at) {
  pthread_mutex_lock(&lock);
  countdown = refuse_at;
  books.refused = 0;
  pthread_mutex_unlock(&lock);
}

alloc_books failing_alloc_books(void) {
  alloc_books copy;
  pthread_mutex_lock(&lock);
  copy = books;
  pthread_mutex_unlock(&lock);
  return copy;
}

/* One round: the n-th request of the scenario's call is refused. Returns whether the call made that many. */
static int refuse_one(const alloc_scenario *scenario, long long n) {
  hg_grid *grid = NULL;
  hg_status status;
  long long refused;
  failing_alloc_install();
  if (scenario->prepare != NULL) scenario->prepare(&grid);
  failing_alloc_arm(n);
  status = scenario->act(&grid);
  refused = failing_alloc_books().refused;
  failing_alloc_arm(-1);
  if (refused > 0) {
    if (status != HG_ERR_MEMORY) print_error("request %lld was refused\n", n);
    assert_status(HG_ERR_MEMORY, status);
    if (scenario->unchanged != NULL) scenario->unchanged(grid);
    status = scenario->act(&grid);
  }
  assert_ok(status);
  if (scenario->done != NULL) scenario->done(grid);
  hg_destroy(grid);
  assert_int_equal(0, failing_alloc_books().live_blocks);
  assert_int_equal(0, failing_alloc_books().live_bytes);
  assert_int_equal(0, failing_alloc_books().faults);
  failing_alloc_remove();
  return refused > 0;
}

long long refuse_each_allocation(const alloc_scenario *scenario) {
  long long n = 0;
  while (refuse_one(scenario, n)) ++n;
  return n;
}

static hg_status (*call_on_chain)(hg_grid *grid);
static void prepare_chain(hg_grid **grid) { *grid = make_chain(NULL); }
static hg_status act_on_chain(hg_grid **grid) { return call_on_chain(*grid); }
static void still_a_chain(hg_grid *grid) { assert_chain(grid, 0); }

long long refuse_each_allocation_on_chain(hg_status (*call)(hg_grid *grid)) {
  const alloc_scenario looked_at = {prepare_chain, act_on_chain, still_a_chain, still_a_chain};
  const alloc_scenario left_alone = {prepare_chain, act_on_chain, NULL, still_a_chain};
  call_on_chain = call;
  refuse_each_allocation(&looked_at);
  return refuse_each_allocation(&left_alone);
}
