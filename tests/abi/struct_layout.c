/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* The binary layout on 64-bit machines: sizes, offsets and constants are frozen, and offered to Fortran by name. */
#include <hgrid/hgrid.h>

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* A size may grow (then its struct has new members at the end); an offset or a constant never changes. */
#define SIZES(X)          \
  X(hg_allocator, 32)     \
  X(hg_pair, 8)           \
  X(hg_grid_def, 184)     \
  X(hg_level, 32)         \
  X(hg_level_cost, 24)    \
  X(hg_grid_stats, 104)   \
  X(hg_array, 24)         \
  X(hg_contact_batch, 56) \
  X(hg_contact_key, 24)

#define OFFSETS(X)                      \
  X(hg_allocator, context, 0)           \
  X(hg_allocator, allocate, 8)          \
  X(hg_allocator, reallocate, 16)       \
  X(hg_allocator, release, 24)          \
  X(hg_pair, a, 0)                      \
  X(hg_pair, b, 4)                      \
  X(hg_contact_key, a, 0)               \
  X(hg_contact_key, b, 8)               \
  X(hg_contact_key, sub, 16)            \
  X(hg_grid_def, struct_size, 0)        \
  X(hg_grid_def, dimension, 4)          \
  X(hg_grid_def, thread_count, 8)       \
  X(hg_grid_def, index_base, 12)        \
  X(hg_grid_def, interaction, 16)       \
  X(hg_grid_def, accuracy, 20)          \
  X(hg_grid_def, pair_order, 24)        \
  X(hg_grid_def, level_rule, 28)        \
  X(hg_grid_def, level_count, 32)       \
  X(hg_grid_def, reserved0, 36)         \
  X(hg_grid_def, cell_sizes, 40)        \
  X(hg_grid_def, margin, 48)            \
  X(hg_grid_def, skin, 56)              \
  X(hg_grid_def, periodic, 64)          \
  X(hg_grid_def, reserved1, 76)         \
  X(hg_grid_def, box_min, 80)           \
  X(hg_grid_def, box_max, 104)          \
  X(hg_grid_def, cell_overhead, 128)    \
  X(hg_grid_def, level_price, 136)      \
  X(hg_grid_def, row_price, 144)        \
  X(hg_grid_def, tilt, 152)             \
  X(hg_grid_def, touching, 176)         \
  X(hg_grid_def, images, 180)           \
  X(hg_level, cell_size, 0)             \
  X(hg_level, largest_radius, 8)        \
  X(hg_level, occupancy, 16)            \
  X(hg_level, particle_count, 24)       \
  X(hg_level_cost, level_count, 0)      \
  X(hg_level_cost, reachable, 4)        \
  X(hg_level_cost, occupancy, 8)        \
  X(hg_level_cost, cost, 16)            \
  X(hg_grid_stats, particle_count, 0)   \
  X(hg_grid_stats, level_count, 8)      \
  X(hg_grid_stats, row_count, 16)       \
  X(hg_grid_stats, cell_count, 24)      \
  X(hg_grid_stats, candidate_count, 32) \
  X(hg_grid_stats, undecided_count, 40) \
  X(hg_grid_stats, exact_count, 48)     \
  X(hg_grid_stats, pair_count, 56)      \
  X(hg_grid_stats, build_count, 64)     \
  X(hg_grid_stats, search_count, 72)    \
  X(hg_grid_stats, byte_count, 80)      \
  X(hg_grid_stats, filter_count, 88)    \
  X(hg_grid_stats, stored_count, 96)    \
  X(hg_array, data, 0)                  \
  X(hg_array, stride, 8)                \
  X(hg_array, type, 16)                 \
  X(hg_array, reserved, 20)             \
  X(hg_contact_batch, count, 0)         \
  X(hg_contact_batch, a, 8)             \
  X(hg_contact_batch, b, 16)            \
  X(hg_contact_batch, dx, 24)           \
  X(hg_contact_batch, dy, 32)           \
  X(hg_contact_batch, dz, 40)           \
  X(hg_contact_batch, reach, 48)

#define CONSTANTS(X)     \
  X(HG_OK, 0)            \
  X(HG_ERR_NULL, 1)      \
  X(HG_ERR_ARGUMENT, 2)  \
  X(HG_ERR_MEMORY, 3)    \
  X(HG_ERR_CAPACITY, 4)  \
  X(HG_ERR_STATE, 5)     \
  X(HG_ERR_NOT_FOUND, 6) \
  X(HG_ERR_LIMIT, 7)     \
  X(HG_ERR_INTERNAL, 8)  \
  X(HG_ERR_MPI, 9)       \
  X(HG_ERR_REMOTE, 10)   \
  X(HG_CONTACT, 0)       \
  X(HG_MAX_RANGE, 1)     \
  X(HG_EXACT, 0)         \
  X(HG_DOUBLE, 1)        \
  X(HG_FLOAT, 2)         \
  X(HG_ORDER_GRID, 0)    \
  X(HG_ORDER_ID, 1)      \
  X(HG_LEVELS_AUTO, 0)   \
  X(HG_LEVELS_PAPER, 1)  \
  X(HG_LEVELS_USER, 2)   \
  X(HG_NEAREST_IMAGE, 0) \
  X(HG_ALL_IMAGES, 1)    \
  X(HG_HALF, 0)          \
  X(HG_FULL, 1)          \
  X(HG_MAX_LEVELS, 64)   \
  X(HG_REAL64, 0)        \
  X(HG_REAL32, 1)        \
  X(HG_MAX_GROUPS, 64)   \
  X(HG_MAX_BATCH, 1024)

#define ASSERT_SIZE(type, size) _Static_assert(sizeof(type) == (size), "size of " #type);
#define ASSERT_OFFSET(type, member, offset) _Static_assert(offsetof(type, member) == (offset), #type "%" #member);
#define ASSERT_CONSTANT(name, value) _Static_assert((name) == (value), #name);
SIZES(ASSERT_SIZE)
OFFSETS(ASSERT_OFFSET)
CONSTANTS(ASSERT_CONSTANT)

typedef struct named_number {
  const char *name;
  int64_t number;
} named_number;

#define SIZE_ROW(type, size) {#type, (size)},
#define OFFSET_ROW(type, member, offset) {#type "%" #member, (offset)},
#define CONSTANT_ROW(name, value) {#name, (value)},
static const named_number layout[] = {SIZES(SIZE_ROW) OFFSETS(OFFSET_ROW) CONSTANTS(CONSTANT_ROW)};

int64_t layout_length(void);
int64_t layout_number(const char *name);

int64_t layout_length(void) { return (int64_t)(sizeof layout / sizeof layout[0]); }

/* -1 if there is no such name. */
int64_t layout_number(const char *name) {
  for (size_t k = 0; k < sizeof layout / sizeof layout[0]; ++k) {
    if (strcmp(layout[k].name, name) == 0) {
      return layout[k].number;
    }
  }
  return -1;
}
