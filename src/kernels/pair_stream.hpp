// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the kernels send the pairs that they find. Three parties meet here: the kernels write pairs, a PairOutput makes
// room for them, a PairJudge decides those that the fast test leaves undecided.
#pragma once

#include "src/kernels/points.hpp"

#include <hgrid/types.h>

namespace hg {

// Candidates are handed on in pieces of at most this many, so that an output needs room for no more at once.
inline constexpr uint32_t kMaxPiece = 1024;

// `next` .. `limit` is room for pairs, kPadding of them for writing beyond the end. Set up by the owner of the room.
struct PairOutput {
  hg_pair *next;
  hg_pair *limit;
  void *owner;
  // Makes room for `count` pairs more; false ends the search. No pair is undecided then.
  bool (*make_room)(PairOutput *output, size_t count);
};

// Stands among the found pairs until it is decided.
struct UndecidedPair {
  hg_pair *at;
  uint32_t a, b;  // slots, or whatever the judge knows the two by
  Image image;    // of a
};

struct PairStream;

// Given by the source of the pairs; the same for all of its streams.
struct PairJudge {
  void (*decide)(PairStream *stream);  // all that are undecided; takes those out that do not interact
  const void *source;
  const double *centers, *radii;  // the caller's, to fetch ahead
  uint32_t dimension;
  int32_t id_offset;    // added to slots in pairs
  float band_constant;  // of the fast test
};

// As many wait for the caller's doubles to arrive in cache.
inline constexpr uint32_t kMaxUndecided = 64;

struct PairStream {
  PairOutput output;
  PairJudge judge;
  uint32_t undecided_count = 0;
  UndecidedPair undecided[kMaxUndecided];  // in the order of the pairs
  int64_t candidate_total = 0, undecided_total = 0, exact_total = 0;

  PairStream(const PairJudge &of_source, const PairOutput &to) : output(to), judge(of_source) {}
};

}  // namespace hg
