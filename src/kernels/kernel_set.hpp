// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The kernels of each instruction set that this build holds, and the choice among them at run time. A kernel is a
// function over plain pointers and numbers, so that it can be compiled for an instruction set of its own without
// sharing inline functions with other files. The order is that of the data: input check, build, images, search,
// spheres; then, step by step, update and filter; last the order of the pairs.
#pragma once

#include "src/base/interval.hpp"
#include "src/exact/interaction.hpp"
#include "src/kernels/pair_stream.hpp"
#include "src/kernels/points.hpp"
#include "src/space/cell_table.hpp"
#include "src/space/chunk_table.hpp"
#include "src/space/fixed_point.hpp"

namespace hg {

// ---- input check: what the caller gives

// Arrays of count > 0 particles, and where to copy them.
struct InputArrays {
  size_t count;
  const double *centers, *radii;      // radii may be NULL
  double *center_copy, *radius_copy;  // may be NULL
};

struct InputSummary {
  Interval center[3];
  Interval radius;
  bool finite;  // without it the intervals mean nothing
};

using InputCheckKernel = InputSummary(const InputArrays &input);

// Copies `count` centres over those of before. Returns the longest way that one goes on any axis.
using MoveKernel = double(const double *centers, size_t count, double *copy);

// ---- build: from the caller's arrays to rows of points

// Of a level: rows are numbered row_base + z * count_y + y. An empty level has zero inverse widths and a single row.
struct LevelRows {
  double radius_limit;  // the largest radius that the level takes
  float inverse_y, last_y, inverse_z, last_z;
  uint32_t count_y, row_base;
};

// The caller's particles, and what makes points of them.
struct ParticleInput {
  const double *centers, *radii;
  const Interval *extent;  // of all centers, by axis
  FixedPoint map;
  double extra_radius;              // makes a radius a folded one
  const uint32_t *slots = nullptr;  // of the particles, if these are not their places
};

struct BuildInput : ParticleInput {
  int level_count;
  const LevelRows *levels;
};

struct RowCount {
  uint32_t *row_of;     // of each particle
  uint32_t *row_count;  // counted up
};

// A particle on its way from the caller's order to that of the cells. One record, as columns would be a cache line
// each; z is 0 in 2D.
struct RowParticle {
  int32_t x, y, z;
  float radius;
  uint32_t slot;
};

// Where particles go, in the order in which they come within each row.
struct RowScatter {
  const uint32_t *row_of;
  uint32_t *row_next;  // where the next particle of a row goes; counted up
  RowParticle *particles;
};

// The rows of a level, and where their particles go, sorted by cell.
struct RowSort {
  const RowParticle *particles;
  const uint32_t *row_begin;  // and where the last row ends
  int32_t row_cells;
  float inverse_width, last;  // of cells along x
  uint32_t *cell_begin;       // of all rows
  PointColumns output;
};

struct BuildKernel {
  void (*find_rows)(const BuildInput &input, size_t begin, size_t end, const RowCount &output);
  void (*put_into_rows)(const BuildInput &input, size_t begin, size_t end, const RowScatter &output);
  // `room`: a word for each particle of the longest row.
  void (*sort_rows)(const RowSort &rows, size_t begin, size_t end, uint32_t *room);
};

// Of a level that is kept as chunks of rows. The layers (rows of the same z) of all levels are numbered through.
struct ChunkLevelKey {
  double radius_limit;
  double inverse_cell, inverse_width;  // of a cell along x, of a row
  double low[3];                       // the place where cells begin
  uint64_t first_layer;
};

struct ChunkInput : ParticleInput {
  int level_count;
  const ChunkLevelKey *levels;
  int row_bits;  // of the number of a row in its layer
};

// Where a particle lies: row = layer << row_bits | row in the layer + 1, so that 0 is in no layer a row.
struct ChunkKey {
  uint64_t row;
  uint32_t cell, slot;
};

// The same in one number, row before cell before slot, which has the lowest bits.
struct PackedKeys {
  int cell_bits, slot_bits;
};
// `static`, as the kernels of each instruction set compile their own copy.
static inline uint64_t pack(const PackedKeys &packed, const ChunkKey &key) {
  return (key.row << packed.cell_bits | key.cell) << packed.slot_bits | key.slot;
}
static inline ChunkKey unpack(const PackedKeys &packed, uint64_t key) {
  const uint64_t place = key >> packed.slot_bits;
  return {place >> packed.cell_bits, static_cast<uint32_t>(place & ((uint64_t{1} << packed.cell_bits) - 1)),
          static_cast<uint32_t>(key & ((uint64_t{1} << packed.slot_bits) - 1))};
}

struct ChunkBuildKernel {
  void (*find_keys)(const ChunkInput &input, size_t begin, size_t end, Point *points, ChunkKey *keys);
  void (*find_packed_keys)(const ChunkInput &input, const PackedKeys &packed, size_t begin, size_t end, Point *points,
                           uint64_t *keys);
  // Column entry i, for i in [begin, end), becomes that of points[slots[i]].
  void (*put)(const Point *points, const uint32_t *slots, size_t begin, size_t end, const PointColumns &output);
};

// ---- images: which points reach across periodic faces

struct ImageInput {
  const int32_t *x[3];  // of the points; x[2] is not read in 2D
  bool periodic[3];
  int32_t period[3];  // may be 0 where the box is finer than the search
  float reach;        // how far outside the box an image may lie
  ImageSet wanted;    // other images are not looked for
};

struct PointImage {
  uint32_t point;
  Image image;
};

// Finds the images of points [begin, end), in the order of the points and ascending for each. Returns how many they
// are.
using ImageKernel = size_t(const ImageInput &input, size_t begin, size_t end, PointImage *found);

// ---- search: from points to pairs

// Points that step through the stencil together. The order of the pairs depends on it, so work is cut at multiples.
inline constexpr uint32_t kBlock = 16;

struct SearchKernel {
  // Pairs within one level: each of the points [begin, end), which are particles of that level, with those after it.
  // Rows must be at least as wide as the reach on that level. False if the output stopped.
  bool (*own_level)(const PointArrays &points, uint32_t begin, uint32_t end, const CellTable &cells,
                    PairStream *stream);
  // Pairs of each of the points [begin, end) with all particles of a level.
  bool (*cross_level)(const PointArrays &points, uint32_t begin, uint32_t end, const CellTable &cells,
                      const PointArrays &particles, PairStream *stream);
};

// Points that lie near each other, and the coordinates of a place near them.
struct ChunkGroup {
  uint32_t begin, end;
  int32_t place[3];
};

// The same where levels are chunks of rows.
struct ChunkSearchKernel {
  bool (*own_level)(const PointArrays &points, uint32_t begin, uint32_t end, const ChunkTable &chunks,
                    PairStream *stream);
  bool (*near_chunks)(const PointArrays &points, const ChunkGroup &group, const ChunkTable &chunks,
                      const NearChunks &near, const PointArrays &particles, PairStream *stream);
};

// ---- spheres: queries of single places

// A sphere among particles, its radius folded.
struct SpherePoint {
  Point at;
  bool may_be_sure;  // else nothing that is found is
};

// Set in a hit that is undecided.
inline constexpr uint32_t kUnsureHit = uint32_t{1} << 31;

// Which of the particles [begin, end) the sphere interacts with, by their place in the columns and in that order.
// `hits` has room for all of them and kPadding more. Returns how many they are.
using SphereKernel = size_t(const SpherePoint &sphere, const PointArrays &particles, uint32_t begin, uint32_t end,
                            uint32_t *hits);

// ---- update: where the particles of stored candidates are now

// Where particles were when the candidates were collected, and where they are now.
struct UpdateInput {
  const double *centers, *radii;  // the caller's; radii NULL: no radius has changed since the candidates were collected
  const Interval *extent;         // of all centers, by axis
  const uint32_t *slot;           // of each point in `centers`
  const int32_t *x[3];            // of each point when the candidates were collected; x[2] is not read in 2D
  const double *place[3];         // where coordinates wrap: likewise, as places; else NULL
  const float *radius;            // likewise, folded with the wider reach of the candidates
  FixedPoint map;
  double extra_radius, extra_wide_radius;  // make a radius a folded one, for the true and for the wider reach
  float room;                              // how far a particle may move and grow together, in quanta
};

// Writes points [begin, end), unless NULL: where the particles are now, beyond the faces of a periodic box if they left
// it. Radii are written only if given. Returns what is left of the room to the particle that has the least; negative,
// with any points, if one has moved too far.
using UpdateKernel = float(const UpdateInput &input, size_t begin, size_t end, Point *points);

// ---- filter: from stored candidates to pairs

// Candidates as pairs of points.
struct FilterInput {
  const Point *points;
  const uint32_t *slot;  // of each point
  const hg_pair *pairs;
  size_t count;
};

// Sends the candidates that interact to the stream, as slots and in their order. Undecided pairs name points instead of
// slots. False if the output stopped.
using FilterKernel = bool(const FilterInput &input, PairStream *stream);

// ---- direct: the same on the caller's doubles

struct DirectInput {
  const double *centers, *radii;  // by slot
  const hg_pair *pairs;           // of slots
  size_t count;
  double margin;
  // Decides a pair that the test leaves open.
  bool (*interact)(const void *judge, const hg_pair &pair, int64_t *exact);
  const void *judge;
};

// Sends the pairs that interact to the stream, in their order. False if the output stopped.
using DirectPairsKernel = bool(const DirectInput &input, PairStream *stream);

// Room for contacts, and kPadding more. Vectors lead from a to b.
struct ContactColumns {
  size_t room;
  int32_t id_offset;
  int32_t *a, *b;
  double *component[3], *reach;  // component[2] is not written in 2D
  size_t count;
  int64_t undecided, exact;  // counted up
};

// Fills the columns, from their begin on, with the pairs that interact. Returns how many pairs it looked at before they
// were full.
using DirectContactsKernel = size_t(const DirectInput &input, ContactColumns *to);

// NULL where an instruction set has no such kernels.
struct DirectKernel {
  DirectPairsKernel *pairs;
  DirectContactsKernel *contacts;
};

// ---- order: from partners row by row to pairs in ascending order

// Longer rows come in order already.
inline constexpr uint32_t kMostSorted = 32;

// The partners of consecutive particles, row after row, as slots. Row k ends before partners[end[k]].
struct PartnerRows {
  const uint32_t *partners;  // kPadding readable ones behind the last row
  const uint32_t *end;
  size_t count;
  int32_t first_id;   // of the particle of row 0
  int32_t id_offset;  // added to partners in pairs
};

// Writes the pairs of all rows, each row in ascending order, and anything to kPadding pairs behind. Returns their end.
using OrderKernel = hg_pair *(const PartnerRows &rows, hg_pair *next);

// ---- all of one instruction set, by dimension - 2 and by rule of interaction

struct KernelSet {
  const char *name;
  InputCheckKernel *check_input[2];
  MoveKernel *move[2];
  BuildKernel build[2];
  ChunkBuildKernel chunk_build[2];
  ImageKernel *find_images[2];
  SearchKernel search[2][InteractionRules::kCount];
  ChunkSearchKernel chunk_search[2][InteractionRules::kCount];
  SphereKernel *find_hits[2][InteractionRules::kCount];
  UpdateKernel *update[2];
  FilterKernel *filter[InteractionRules::kCount];
  DirectKernel direct[2][InteractionRules::kCount];
  OrderKernel *order;
};

extern const KernelSet kScalarKernels;
extern const KernelSet kSse2Kernels;
extern const KernelSet kAvx2Kernels;
extern const KernelSet kAvx512Kernels;
extern const KernelSet kNeonKernels;

// The best that this machine runs, or what the environment variable HGRID_ISA names. Chosen once, at the first call.
// Throws HG_ERR_ARGUMENT if HGRID_ISA names an instruction set that is unknown, not built or not supported here.
const KernelSet &active_kernels();

}  // namespace hg
