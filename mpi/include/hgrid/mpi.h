/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* libhgrid_mpi: the pairs of particles that lie on several ranks of MPI. Each particle is owned by one rank, whoever
 * chose it; each pair is found by exactly one rank, that which owns the smaller of the two, and its larger particle may
 * be a ghost there: a copy of one that another rank owns. The pairs of all ranks together are those that one grid with
 * all particles finds; docs/theory/ghosts.md says why.
 *
 * Collective calls are made by all ranks of the communicator, in the same order. They succeed on all ranks or fail on
 * all: a rank whose own part failed gets its own status, the others HG_ERR_REMOTE; the text of hg_last_error names the
 * rank (the lowest, if several failed). Where MPI itself fails (HG_ERR_MPI) ranks cannot agree any more: end the
 * program. A call that refuses its arguments has changed nothing; one that fails later (memory, HG_ERR_LIMIT of a
 * grid) leaves the object without particles, and all but hg_mpi_set gives HG_ERR_STATE until that is called.
 * Ownership: the library copies what it is given and keeps no pointer of the caller. What it lends is valid until the
 * next call of hg_mpi_set, hg_mpi_balance or hg_mpi_move, pairs also until they are asked for again.
 * Threads: one at a time on one object; MPI_THREAD_FUNNELED is enough. Several objects, also of different
 * communicators, are independent. From inside a visitor all calls on its object give HG_ERR_STATE.
 * n is the number of owned particles, g that of ghosts, both of this rank. */
#ifndef HGRID_MPI_H
#define HGRID_MPI_H

#include <hgrid/hgrid.h>

#include <mpi.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Particles of all ranks of a communicator. Created by hg_mpi_create, freed by hg_mpi_destroy. */
typedef struct hg_mpi hg_mpi;

/* hg_mpi_def.balancer: how Zoltan cuts space. */
enum {
  HG_MPI_BISECTION = 0, /* recursive coordinate bisection: parts are boxes, the fewest ghosts */
  HG_MPI_CURVE = 1      /* a space-filling curve (Hilbert): parts have loose shapes, more ghosts */
};

enum { HG_MPI_MAX_GROUPS = 32 }; /* the most groups: the library needs the others of HG_MAX_GROUPS for ghosts */

/* How the ranks work together; the same on all. Fill it with hg_mpi_def_init, then change what you need. */
typedef struct hg_mpi_def {
  uint32_t struct_size; /* sizeof(hg_mpi_def) of the caller; set by hg_mpi_def_init */
  int32_t balancer;     /* HG_MPI_BISECTION or HG_MPI_CURVE (HG_MPI_BISECTION) */
  int32_t verify;       /* 1: hg_mpi_set also checks that no gid stands twice, on any ranks (0) */
  int32_t reserved0;    /* 0 */
  double imbalance;     /* largest over mean weight of a rank that hg_mpi_balance may leave, >= 1 (1.05) */
} hg_mpi_def;

/* Counters of this rank, unless they say otherwise. */
typedef struct hg_mpi_stats {
  int64_t owned_count;        /* n */
  int64_t ghost_count;        /* g */
  int64_t pair_count;         /* of the last hg_mpi_query_pairs or complete hg_mpi_visit_pairs */
  int64_t send_rank_count;    /* ranks that hold ghosts of this one's particles */
  int64_t receive_rank_count; /* ranks whose particles are ghosts here */
  int64_t sent_byte_count;    /* rows sent to other ranks since hg_mpi_create: ghosts, migration, forward, reverse */
  int64_t selection_count;    /* times ghosts were chosen since hg_mpi_create */
  int64_t update_count;       /* times their places alone were sent */
  int64_t opened_axis_count;  /* periodic axes that need not be periodic on this rank now */
  double imbalance;           /* largest over mean of all ranks: of weights as the last hg_mpi_balance left them, of n
                                 since hg_mpi_set; 1 without particles */
} hg_mpi_stats;

/* Fills `def` with the defaults (in brackets above). Local. Errors: HG_ERR_NULL; HG_ERR_ARGUMENT: struct_size is 0 or
 * larger than this library's. */
HG_API hg_status hg_mpi_def_init(hg_mpi_def *def, size_t struct_size);

/* Creates an object without particles; collective on `comm`, which is duplicated. grid_def: how pairs are decided, NULL
 * for the defaults; all that bears on pairs must be the same on all ranks (threads, order and levels may differ). Its
 * skin is that of the ghosts, too: they are chosen anew when a particle of any rank has moved plus grown by skin / 2.
 * def: NULL for the defaults. On failure *mpi is NULL.
 * Errors: as hg_create; HG_ERR_STATE: MPI is not initialised, or finalised already; HG_ERR_ARGUMENT: `comm` is none or
 * joins two groups, images is HG_ALL_IMAGES, a member of `def` is out of its range, or the definitions differ. */
HG_API hg_status hg_mpi_create(MPI_Comm comm, const hg_grid_def *grid_def, const hg_mpi_def *def, hg_mpi **mpi);
/* The same for a communicator as Fortran knows it: an integer. */
HG_API hg_status hg_mpi_create_f(int32_t fortran_comm, const hg_grid_def *grid_def, const hg_mpi_def *def,
                                 hg_mpi **mpi);

/* Frees the object and all it lent; collective. NULL is fine. After MPI_Finalize it frees memory only. */
HG_API hg_status hg_mpi_destroy(hg_mpi *mpi);

/* The particles that this rank owns from now on, in place of all before; collective. gids: [count], each one once on
 * all ranks together, any int64; centers: [count][dimension]; radii: [count]. Any rank may own any particles, none, or
 * all. Errors: as hg_insert, a periodic cell judged by the two largest radii of all ranks; HG_ERR_ARGUMENT: a gid
 * stands twice (with def.verify). Local ids are index_base + row; ghosts go on counting. */
HG_API hg_status hg_mpi_set(hg_mpi *mpi, size_t count, const int64_t *gids, const double *centers, const double *radii);

/* Chooses new owners by Zoltan, so that all ranks have about the same weight, and sends particles to them; collective.
 * weights: [n], >= 0, finite; NULL on all ranks: 1 + 2 for each pair that the rank of the particle finds of it as the
 * first. *new_count becomes the new n (may be NULL). The rows of this rank are other ones then: hg_mpi_owned lends
 * them, hg_mpi_migrate sends what else the caller has of each. Errors: HG_ERR_STATE: the library was built without
 * Zoltan, or before hg_mpi_set; HG_ERR_ARGUMENT: a weight, or only some ranks have weights; HG_ERR_MPI: Zoltan failed.
 */
HG_API hg_status hg_mpi_balance(hg_mpi *mpi, const double *weights, size_t *new_count);

/* The particles of this rank, row by row; local. Each of the pointers may be NULL. */
HG_API hg_status hg_mpi_owned(hg_mpi *mpi, size_t *count, const int64_t **gids, const double **centers,
                              const double **radii);

/* Rows of row_bytes each follow their particles as the last hg_mpi_balance sent them; collective. before: [n before],
 * after: [n]; they must not overlap. Errors: HG_ERR_STATE: no balance since hg_mpi_set; HG_ERR_ARGUMENT: row_bytes
 * above 2^31 - 1, or not the same on all ranks. */
HG_API hg_status hg_mpi_migrate(hg_mpi *mpi, size_t row_bytes, const void *before, void *after);

/* New centres of this rank's particles, and new radii unless NULL; collective. count: n. *ghosts_changed (may be NULL)
 * becomes 1 if ghosts were chosen anew, so that local ids of ghosts mean others now, else 0; the same on all ranks.
 * Which rank finds a pair goes by the radii at the last choice. Errors: as hg_mpi_set. */
HG_API hg_status hg_mpi_move(hg_mpi *mpi, size_t count, const double *centers, const double *radii,
                             int32_t *ghosts_changed);

/* As hg_set_groups, hg_set_group_pair and hg_set_bodies, of all ranks; collective. groups: [n], -1 or 0 ..
 * HG_MPI_MAX_GROUPS - 1; bodies: [n]. Both follow their particles to ghosts and in hg_mpi_balance; hg_mpi_set puts all
 * in group 0 and in no body. The table of group pairs stays. NULL (on all ranks or some): group 0, no body. Errors:
 * HG_ERR_STATE; HG_ERR_ARGUMENT: count is not n, a group or body is none, the group pairs differ between ranks. */
HG_API hg_status hg_mpi_set_groups(hg_mpi *mpi, size_t count, const int32_t *groups);
HG_API hg_status hg_mpi_set_group_pair(hg_mpi *mpi, int32_t group_a, int32_t group_b, int32_t interacts);
HG_API hg_status hg_mpi_set_bodies(hg_mpi *mpi, size_t count, const int32_t *bodies);

/* The pairs that this rank finds; local. All of them, on all ranks, are each pair once. a < b; a is owned; b is owned
 * or a ghost. The order as grid_def says; errors as hg_query_pairs. */
HG_API hg_status hg_mpi_query_pairs(hg_mpi *mpi, const hg_pair **pairs, size_t *count);
/* The same in batches; local. As hg_visit_pairs. */
HG_API hg_status hg_mpi_visit_pairs(hg_mpi *mpi, hg_pair_visitor *visit, void *context);

/* The ghosts, rank by rank: gids[g], owners[g] (ranks), centers[g][dimension] and radii[g] with the bits that their
 * owners hold; local. Ghost k has the local id index_base + n + k. Each of the pointers may be NULL. */
HG_API hg_status hg_mpi_ghosts(hg_mpi *mpi, size_t *count, const int64_t **gids, const int32_t **owners,
                               const double **centers, const double **radii);

/* Rows of owned particles (velocities, materials) to where these are ghosts; collective. owned: [n], ghosts: [g], rows
 * of row_bytes each. Errors: HG_ERR_ARGUMENT: row_bytes above 2^31 - 1 or not the same on all ranks. */
HG_API hg_status hg_mpi_forward(hg_mpi *mpi, size_t row_bytes, const void *owned, void *ghosts);

/* Adds what ghosts have got (forces) to the rows of their owners; collective. ghosts: [g][columns], owned:
 * [n][columns]. Added by ascending rank of the ghost, so that two runs on as many ranks have the same bits. */
HG_API hg_status hg_mpi_reverse_add(hg_mpi *mpi, size_t columns, const double *ghosts, double *owned);

/* Copies the counters into the first struct_size bytes of *stats; local. Errors: HG_ERR_NULL; HG_ERR_ARGUMENT if
 * struct_size is 0 or larger than this library's. */
HG_API hg_status hg_mpi_get_stats(hg_mpi *mpi, hg_mpi_stats *stats, size_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
