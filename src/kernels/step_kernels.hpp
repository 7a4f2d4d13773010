// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The interface of the kernels that carry stored candidates from one step to the next: plain pointers and numbers, as
// in kernel.hpp.
#pragma once

#include <hgrid/types.h>

#include <cstddef>
#include <cstdint>

namespace hg {

struct PairSink;

// A particle in fixed point; the radius is folded (interaction.hpp).
struct Record {
  int32_t x, y, z;
  float radius;
};

// Where particles were when the candidates were collected, and where they are now. Lengths are in quanta (frame.hpp)
// except for the caller's.
struct FollowInput {
  const double *centers, *radii;  // the caller's; radii NULL: no radius has changed since the candidates were collected
  const uint32_t *slot;           // of each point in `centers`
  const int32_t *x[3];            // of each point when the candidates were collected; x[2] is not read in 2D
  const float *radius;            // likewise, folded with the wider reach of the candidates
  double scale, half_origin[3];   // of the frame
  double box_min[3], length[3];   // length 0 on open axes
  int32_t period[3];
  double extra_radius, extra_wide_radius;  // make a radius a folded one, for the true and for the wider reach
  float room;                              // how far a particle may move and grow together
};

// Writes points [begin, end): where the particles are now, beyond the faces of a periodic box if they left it. Radii
// are written only if given. False, with any points, if one has moved too far.
using FollowKernel = bool(const FollowInput &input, size_t begin, size_t end, Record *points);

// Candidates as pairs of points.
struct FilterInput {
  const Record *points;
  const uint32_t *slot;  // of each point
  const hg_pair *pairs;
  size_t count;
};

// Sends the candidates that interact to the sink, as slots and in their order. Open pairs name points instead of slots.
// False if the sink stopped.
using FilterKernel = bool(const FilterInput &input, PairSink *sink);

struct StepKernels {
  FollowKernel *follow[2];  // by dimension - 2
  FilterKernel *filter[2];  // by interaction
};

}  // namespace hg
