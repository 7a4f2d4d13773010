// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The interface of the search kernels: plain pointers and numbers only, so that a kernel can be compiled for an
// instruction set of its own without sharing inline functions with other files.
#pragma once

#include "src/kernels/step_kernels.hpp"

#include <hgrid/types.h>

#include <cstddef>
#include <cstdint>

namespace hg {

// Lengths here are in quanta (frame.hpp). What a window must allow for: coordinates are floored (1), wrapped and
// shifted across the box (2.5), converted to float (64 each) and compared with row borders computed in float (256).
// docs/exactness.md adds this up.
inline constexpr float kWindowSlack = 1024.0f;
inline constexpr float kWindowScale = 1.0f + 0x1p-20f;

// |t - (d^2 - R^2)| < R * (kBandLinear + kBandSquare * R) + kBandConstant wherever the sign of t could be wrong.
inline constexpr float kBandLinear = 13.0f;
inline constexpr float kBandSquare = 0x1p-19f;
inline constexpr float kBandConstant = 40.0f;

// Kernels read and write this many elements beyond the end of arrays, ignoring what they read there.
inline constexpr size_t kPadding = 16;

// Particles sorted by level, row and cell, with kPadding readable elements behind. Radii are folded (interaction.hpp).
struct PointArrays {
  const int32_t *x, *y, *z;  // z is not read in 2D
  const float *radius;
  const uint32_t *slot;
  const uint8_t *image;  // which periodic image the points stand for; NULL: kItself, all of them
};
inline constexpr uint8_t kItself = 13;

// Particles that step through the stencil together. The order of the pairs depends on it, so work is cut at multiples.
inline constexpr uint32_t kBlock = 16;

// The cells of one level: rows along x, stacked in y and z. Cell c of row (y, z) begins at
// cell_begin[(z * count[1] + y) * count[0] + c] in the sorted particles, and ends where the next cell begins.
struct CellTable {
  int32_t count[3];
  float width[3];
  float inverse_width[3];
  float largest_radius;  // folded, of the particles on the level
  const uint32_t *cell_begin;
};

// A pair that the fast test leaves open. It stands among the found pairs until settled.
struct OpenPair {
  hg_pair *at;
  uint32_t slot_a, slot_b;
  uint8_t image;  // of slot_a
};

// As many wait for the caller's doubles to arrive in cache.
inline constexpr uint32_t kMaxOpen = 64;

// Where found pairs go: `next` .. `limit` is room for pairs, kPadding of them for writing beyond the end.
struct PairSink {
  hg_pair *next;
  hg_pair *limit;
  // Settles what is open and makes room for `count` pairs more; false ends the search.
  bool (*make_room)(PairSink *sink, size_t count);
  // Decides the open pairs and takes those out that do not interact.
  void (*settle)(PairSink *sink);
  const void *overlap;
  const void *store;
  const double *centers, *radii;  // of the store, to fetch ahead
  uint32_t dimension;
  int32_t id_offset;
  uint32_t open_count;
  OpenPair open[kMaxOpen];  // in the order of the pairs
  int64_t candidate_count;
  int64_t undecided_count;
  int64_t exact_count;
  float band_constant;  // kBandConstant, or infinity to have every candidate decided
};

// Candidates are handed on in pieces of at most this many, so that a sink needs room for no more at once.
inline constexpr uint32_t kMaxPiece = 1024;

struct SearchKernel {
  // Pairs within one level: each of the points [begin, end), which are particles of that level, with those after it.
  // Rows must be at least as wide as the reach on that level. False if the sink stopped.
  bool (*own_level)(const PointArrays &points, uint32_t begin, uint32_t end, const CellTable &cells, PairSink *sink);
  // Pairs of each of the points [begin, end) with all particles of a level.
  bool (*cross_level)(const PointArrays &points, uint32_t begin, uint32_t end, const CellTable &cells,
                      const PointArrays &particles, PairSink *sink);
};

struct Extremes {
  double least, greatest;
};

// Arrays of count > 0 particles, and where to copy them.
struct SurveyInput {
  size_t count;
  const double *centers, *radii;      // radii may be NULL
  double *center_copy, *radius_copy;  // may be NULL
};

struct Survey {
  Extremes axis[3];  // of the centres
  Extremes radius;
  bool finite;  // without it the extremes mean nothing
};

// What building needs to know of a level: rows are numbered row_base + z * count_y + y. A level without a table of
// cells has zero inverse widths and a single row.
struct KeyLevel {
  double radius_limit;
  float inverse_y, last_y, inverse_z, last_z;
  uint32_t count_y, row_base;
};

struct KeyInput {
  const double *centers, *radii;
  double scale, half_origin[3], top;  // of the frame; top: the greatest coordinate
  double box_min[3], length[3];       // length 0 on open axes
  double extra_radius;                // makes a radius a folded one
  int level_count;
  const KeyLevel *levels;
};

struct RowCount {
  uint32_t *row_of;     // of each particle
  uint32_t *row_count;  // counted up
};

// Where particles go, in the order in which they come within each row.
struct RowScatter {
  const uint32_t *row_of;
  uint32_t *row_next;  // where the next particle of a row goes; counted up
  int32_t *x, *y, *z;  // z is not written in 2D
  float *radius;
  uint32_t *slot;
};

struct BuildKernel {
  void (*find_rows)(const KeyInput &input, size_t begin, size_t end, const RowCount &output);
  void (*put_into_rows)(const KeyInput &input, size_t begin, size_t end, const RowScatter &output);
};

// Kernels of one instruction set, by dimension - 2 (and interaction).
struct KernelSet {
  const char *name;
  SearchKernel search[2][2];
  Survey (*survey[2])(const SurveyInput &input);
  BuildKernel build[2];
  StepKernels steps;
};

}  // namespace hg
