/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* What every part of the interface shares: linkage, status codes, error texts, version and memory. */
#ifndef HGRID_BASE_H
#define HGRID_BASE_H

#include <hgrid/version.h>

#include <stddef.h>
#include <stdint.h>

#if defined(SWIG)
#define HG_API
#elif defined(HGRID_STATIC)
#define HG_API
#elif defined(_WIN32)
#ifdef HGRID_BUILDING
#define HG_API __declspec(dllexport)
#else
#define HG_API __declspec(dllimport)
#endif
#else
#define HG_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The result of every call that can fail. Values are never renumbered. */
typedef int32_t hg_status;
enum {
  HG_OK = 0,            /* success */
  HG_ERR_NULL = 1,      /* a pointer that must not be NULL is NULL */
  HG_ERR_ARGUMENT = 2,  /* a value is out of its range: NaN, infinity, negative radius, box too short ... */
  HG_ERR_MEMORY = 3,    /* memory could not be had; the grid is as it was before the call */
  HG_ERR_CAPACITY = 4,  /* a result does not fit in what the caller provides */
  HG_ERR_STATE = 5,     /* the call is not allowed now, e.g. from inside a visitor of the same grid */
  HG_ERR_NOT_FOUND = 6, /* no particle has that id */
  HG_ERR_LIMIT = 7,     /* a documented limit is exceeded: number of particles, of levels, of box lengths */
  HG_ERR_INTERNAL = 8,  /* a fault of the library: please report it */
  HG_ERR_MPI = 9,       /* libhgrid_mpi: a call of MPI failed; ranks cannot agree any more */
  HG_ERR_REMOTE = 10    /* libhgrid_mpi: the collective call failed on another rank, which the text names */
};

/* The name of a status, e.g. "HG_ERR_ARGUMENT"; "unknown status" for any other value. Never NULL; static storage. */
HG_API const char *hg_status_string(hg_status status);

/* What went wrong in the last failing call of this thread, naming the offending index and value.
 * Empty before the first failure. Borrowed: overwritten by the next failure of the same thread. */
HG_API const char *hg_last_error(void);

/* For libraries that stand on this one and report as it does: the text that hg_last_error returns on this thread from
 * now on; copied, at most 255 characters. NULL: empty. */
HG_API void hg_set_last_error(const char *text);

/* The version of the library that is loaded. Each pointer may be NULL. */
HG_API void hg_version(int *major, int *minor, int *patch);

/* Where a grid or a contact history takes its memory from.
 *
 * `allocate` returns at least `size` bytes aligned as by malloc, or NULL; `reallocate` behaves like realloc and is told
 * the old size; `release` gets the size that was asked for. All three must be set, and safe to call from several
 * threads at once. */
typedef struct hg_allocator {
  void *context; /* handed back in every call; may be NULL */
  void *(*allocate)(void *context, size_t size);
  void *(*reallocate)(void *context, void *memory, size_t old_size, size_t new_size);
  void (*release)(void *context, void *memory, size_t size);
} hg_allocator;

/* Sets the allocator of all grids and contact histories created afterwards; NULL restores malloc. Each keeps the one it
 * was created with.
 * Errors: HG_ERR_NULL if a member function is NULL (nothing changes).
 * Thread safety: safe at any time. */
HG_API hg_status hg_set_allocator(const hg_allocator *allocator);

#ifdef __cplusplus
}
#endif

#endif
