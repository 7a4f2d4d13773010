/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* Two giants plough through a bed of grains 50 times smaller, in a box that is periodic along x and y, on any number of
 * ranks of MPI. Springs of friction are kept with the smaller grain of each contact and migrate with it; ranks are
 * balanced anew every 50 steps. Arguments: FILE [COUNT [STEPS]]. FILE gets place, velocity and spin of each grain, as
 * doubles, by gid: the same bytes on any number of ranks. The first rank prints what there was to do.
 *
 * Why the same bytes: whoever finds a contact computes it from the same bits in the same order (by gid); and forces are
 * rounded to multiples of a quantum so coarse that their sums are exact, in whatever order they are added. */
#include <hgrid/mpi.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SLOTS = 24, GIANTS = 2, BALANCE_EVERY = 50 };

static const double width = 4.2, stiffness = 1000, damping = 0.02, friction = 0.5, gravity = 10, dt = 2e-5;
static const double skin = 0.004;
/* A power of two. Sums of multiples are exact below 2^53 of them, 131072. */
static const double quantum = 1.0 / (1ll << 36), most = 131072;

/* The springs of contacts with larger grains. */
struct springs {
  int64_t count, partner[SLOTS];
  double stretch[SLOTS][3];
};

struct motion {
  double v[3], w[3]; /* velocity, spin */
};

/* What a grain feels: force, torque, and the sum of the sizes of all that was added, which bounds both. */
struct load {
  double f[3], t[3], size;
};

/* Owned grains, then ghosts; springs of owned grains only. */
static size_t count, ghost_count;
static int64_t *gid;
static double (*x)[3], *radius;
static struct motion *motion;
static struct load *load;
static struct springs *springs, *springs_before;
static hg_mpi *mpi;
static int rank, ranks;
static int64_t all; /* grains of all ranks */
static long long contact_count, sliding_count, balance_count;

static void fail(const char *what) {
  fprintf(stderr, "rank %d: %s\n", rank, what);
  MPI_Abort(MPI_COMM_WORLD, 1);
}

static void check(hg_status status) {
  if (status != HG_OK) fail(hg_last_error());
}

static void *resized(void *array, size_t rows, size_t row_bytes) {
  void *fresh = realloc(array, (rows + 1) * row_bytes);
  if (fresh == NULL) fail("no memory");
  return fresh;
}

static void resize_all(size_t rows) {
  gid = resized(gid, rows, sizeof *gid);
  x = resized(x, rows, sizeof *x);
  radius = resized(radius, rows, sizeof *radius);
  motion = resized(motion, rows, sizeof *motion);
  load = resized(load, rows, sizeof *load);
}

static double mass_of(double r) { return 4.18879020478639 * r * r * r; }

/* Between -0.5 and 0.5, of a grain, the same everywhere. */
static double noise(int64_t of, int which) {
  int64_t state = (of * 16 + which + 1) % 2147483647;
  for (int k = 0; k < 3; k++) state = state * 48271 % 2147483647;
  return (double)state / 2147483647.0 - 0.5;
}

/* The grain that has this gid: giants first, then layers on the floor. */
static void place_grain(int64_t of, size_t row) {
  const double step = 0.085;
  const int64_t side = (int64_t)(width / step), k = of - GIANTS;
  gid[row] = of;
  memset(&motion[row], 0, sizeof motion[row]);
  if (of < GIANTS) {
    radius[row] = 1;
    x[row][0] = 1 + 2.1 * (double)of;
    x[row][1] = 1 + 2.1 * (double)of;
    x[row][2] = 0.96 + step * (double)((all - GIANTS + side * side - 1) / (side * side)); /* above the layers */
    motion[row].v[0] = 2;
    motion[row].v[2] = -4;
    motion[row].w[1] = 3;
    return;
  }
  radius[row] = 0.02 * (1.5 + noise(of, 0));
  x[row][0] = ((double)(k % side) + 0.5 + 0.1 * noise(of, 1)) * step;
  x[row][1] = ((double)(k / side % side) + 0.5 + 0.1 * noise(of, 2)) * step;
  x[row][2] = ((double)(k / (side * side)) + 0.5) * step;
  for (int axis = 0; axis < 3; axis++) motion[row].v[axis] = 2 * noise(of, 3 + axis);
}

static double to_quantum(double number) {
  /* Of numbers this large the last bit is the quantum. */
  const double shift = 1.5 * 4503599627370496.0 * quantum;
  return (number + shift) - shift;
}

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const double *a, const double *b, double *c) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

/* Spring and dashpot along n, which leads from the first grain to the other, and a spring of friction across. `v`: of
 * the other's surface against the first's. */
static void contact_force(const double *n, double overlap, const double *v, double *stretch, double *f) {
  const double v_normal = dot(n, v), push = fmax(0, stiffness * overlap - damping * v_normal);
  double along, size, limit;
  for (int k = 0; k < 3; k++) stretch[k] += dt * (v[k] - v_normal * n[k]);
  along = dot(stretch, n);
  for (int k = 0; k < 3; k++) stretch[k] -= along * n[k];
  size = 0.5 * stiffness * sqrt(dot(stretch, stretch));
  limit = friction * push;
  if (size > limit) {
    for (int k = 0; k < 3; k++) stretch[k] *= limit / size;
    sliding_count++;
  }
  for (int k = 0; k < 3; k++) f[k] = push * n[k] - 0.5 * stiffness * stretch[k];
}

/* Adds a force on a grain at arm * n from its centre. */
static void add_load(struct load *l, const double *f, double sign, double arm, const double *n) {
  double torque[3];
  cross(n, f, torque);
  for (int k = 0; k < 3; k++) {
    const double one = to_quantum(sign * f[k]), other = to_quantum(arm * torque[k]);
    l->f[k] += one;
    l->t[k] += other;
    l->size += fabs(one) + fabs(other);
  }
}

static double *spring_of(const struct springs *before, struct springs *now, int64_t partner) {
  int64_t k = 0;
  if (now->count == SLOTS) fail("a grain touches more larger ones than it has slots for");
  now->partner[now->count] = partner;
  memset(now->stretch[now->count], 0, sizeof now->stretch[0]);
  while (k < before->count && before->partner[k] != partner) k++;
  if (k < before->count) memcpy(now->stretch[now->count], before->stretch[k], sizeof now->stretch[0]);
  return now->stretch[now->count++];
}

/* i has the smaller gid: all ranks compute alike. */
static void touch(size_t i, size_t j) {
  const int j_is_smaller = radius[j] != radius[i] ? radius[j] < radius[i] : 0;
  const size_t keeper = j_is_smaller ? j : i, partner = j_is_smaller ? i : j; /* the keeper is owned */
  double n[3], distance, w[3], v[3], f[3], arm_i, arm_j, overlap;
  for (int k = 0; k < 3; k++) n[k] = x[j][k] - x[i][k];
  for (int k = 0; k < 2; k++) n[k] -= width * round(n[k] / width);
  distance = sqrt(dot(n, n));
  overlap = radius[i] + radius[j] - distance;
  for (int k = 0; k < 3; k++) n[k] /= distance;
  arm_i = radius[i] - 0.5 * overlap;
  arm_j = radius[j] - 0.5 * overlap;
  for (int k = 0; k < 3; k++) w[k] = arm_i * motion[i].w[k] + arm_j * motion[j].w[k];
  cross(w, n, v);
  for (int k = 0; k < 3; k++) v[k] = motion[j].v[k] - motion[i].v[k] - v[k];
  contact_force(n, overlap, v, spring_of(&springs_before[keeper], &springs[keeper], gid[partner]), f);
  add_load(&load[i], f, -1, -arm_i, n);
  add_load(&load[j], f, 1, -arm_j, n);
  contact_count++;
}

static void find_loads(void) {
  const hg_pair *pair;
  size_t pair_count;
  struct springs *swap = springs_before;
  springs_before = springs;
  springs = swap;
  for (size_t k = 0; k < count; k++) springs[k].count = 0;
  memset(load, 0, (count + ghost_count) * sizeof *load);
  check(hg_mpi_query_pairs(mpi, &pair, &pair_count));
  for (size_t k = 0; k < pair_count; k++) {
    const size_t a = (size_t)pair[k].a, b = (size_t)pair[k].b;
    if (gid[a] < gid[b])
      touch(a, b);
    else
      touch(b, a);
  }
  check(hg_mpi_reverse_add(mpi, 7, load[count].f, load[0].f));
}

static void integrate(void) {
  for (size_t i = 0; i < count; i++) {
    const double mass = mass_of(radius[i]), inertia = 0.4 * mass * radius[i] * radius[i];
    const double depth = radius[i] - x[i][2];
    double floor = depth > 0 ? stiffness * depth - damping * motion[i].v[2] : 0;
    if (!(load[i].size < most)) fail("forces too large for sums that are exact");
    if (floor < 0) floor = 0;
    load[i].f[2] += floor - gravity * mass;
    for (int k = 0; k < 3; k++) {
      motion[i].v[k] += dt * load[i].f[k] / mass;
      motion[i].w[k] += dt * load[i].t[k] / inertia;
      x[i][k] += dt * motion[i].v[k];
    }
  }
}

/* New owners: all that a grain has follows it. */
static void balance(void) {
  size_t new_count;
  const int64_t *gids;
  const double *centers, *radii;
  struct motion *motion_after = NULL;
  const hg_status status = hg_mpi_balance(mpi, NULL, &new_count);
  if (status == HG_ERR_STATE) return; /* the library was built without Zoltan: owners stay */
  check(status);
  motion_after = resized(motion_after, new_count, sizeof *motion);
  springs_before = resized(springs_before, new_count, sizeof *springs);
  check(hg_mpi_migrate(mpi, sizeof *motion, motion, motion_after));
  check(hg_mpi_migrate(mpi, sizeof *springs, springs, springs_before));
  springs = resized(springs, new_count, sizeof *springs);
  memcpy(springs, springs_before, new_count * sizeof *springs);
  check(hg_mpi_owned(mpi, NULL, &gids, &centers, &radii));
  count = new_count;
  resize_all(count);
  memcpy(gid, gids, count * sizeof *gid);
  memcpy(x, centers, count * sizeof *x);
  memcpy(radius, radii, count * sizeof *radius);
  memcpy(motion, motion_after, count * sizeof *motion);
  free(motion_after);
  balance_count++;
}

/* Behind the owned grains. */
static void fetch_ghosts(void) {
  const int64_t *gids;
  const double *centers, *radii;
  check(hg_mpi_ghosts(mpi, &ghost_count, &gids, NULL, &centers, &radii));
  resize_all(count + ghost_count);
  if (ghost_count > 0) {
    memcpy(gid + count, gids, ghost_count * sizeof *gid);
    memcpy(x + count, centers, ghost_count * sizeof *x);
    memcpy(radius + count, radii, ghost_count * sizeof *radius);
  }
  check(hg_mpi_forward(mpi, sizeof *motion, motion, motion + count));
}

static void begin(void) {
  hg_grid_def def = hg_default_grid_def();
  def.skin = skin;
  def.thread_count = 1;
  for (int k = 0; k < 2; k++) {
    def.periodic[k] = 1;
    def.box_max[k] = width;
  }
  resize_all((size_t)(all / ranks + 1));
  for (int64_t of = rank; of < all; of += ranks) place_grain(of, count++);
  springs = resized(springs, count, sizeof *springs);
  springs_before = resized(springs_before, count, sizeof *springs);
  for (size_t k = 0; k < count; k++) springs[k].count = 0;
  check(hg_mpi_create(MPI_COMM_WORLD, &def, NULL, &mpi));
  check(hg_mpi_set(mpi, count, gid, x[0], radius));
}

static void write_grains(const char *path) {
  MPI_File file;
  if (MPI_File_open(MPI_COMM_WORLD, path, MPI_MODE_CREATE | MPI_MODE_WRONLY, MPI_INFO_NULL, &file) != MPI_SUCCESS)
    fail("the file cannot be written");
  MPI_File_set_size(file, (MPI_Offset)(all * 9 * (int64_t)sizeof(double)));
  for (size_t k = 0; k < count; k++) {
    double row[9];
    memcpy(row, x[k], sizeof x[k]);
    memcpy(row + 3, &motion[k], sizeof motion[k]);
    if (MPI_File_write_at(file, (MPI_Offset)((size_t)gid[k] * sizeof row), row, 9, MPI_DOUBLE, MPI_STATUS_IGNORE) !=
        MPI_SUCCESS)
      fail("the file cannot be written");
  }
  MPI_File_close(&file);
}

int main(int argc, char **argv) {
  const int steps = argc > 3 ? atoi(argv[3]) : 500;
  long long mine[3], sums[3];
  hg_mpi_stats stats;
  double start;
  all = argc > 2 ? atoll(argv[2]) : 4000;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (argc < 2 || all < GIANTS || steps < 0) fail("usage: grains FILE [COUNT [STEPS]]");
  begin();
  start = MPI_Wtime();
  for (int step = 0; step < steps; step++) {
    check(hg_mpi_move(mpi, count, x[0], NULL, NULL));
    if (step % BALANCE_EVERY == 0) balance();
    fetch_ghosts();
    find_loads();
    integrate();
  }
  start = MPI_Wtime() - start;
  write_grains(argv[1]);
  check(hg_mpi_get_stats(mpi, &stats, sizeof stats));
  mine[0] = contact_count;
  mine[1] = sliding_count;
  mine[2] = stats.sent_byte_count;
  MPI_Reduce(mine, sums, 3, MPI_LONG_LONG, MPI_SUM, 0, MPI_COMM_WORLD);
  if (rank == 0) {
    printf("%lld grains, %d steps: %lld contacts, %lld of them slide\n", (long long)all, steps, sums[0], sums[1]);
    fprintf(stderr, "%d ranks: balanced %lld times, ghosts chosen %lld times, %lld bytes sent, %.2f s\n", ranks,
            balance_count, (long long)stats.selection_count, sums[2], start);
  }
  check(hg_mpi_destroy(mpi));
  MPI_Finalize();
  return 0;
}
