// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search of levels that are chunks of rows: a level with itself by what its chunks know of their neighbours, and
// points with a finer level, or images, by listing the chunks near them.
#pragma once

#include "src/index/index.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/search/search_tasks.hpp"

namespace hg {

class ChunkPairs {
 public:
  // As for the kernels: pairs of `points`, which search, and `particles`, which are found.
  ChunkPairs(const Index &index, const PointArrays &points, const PointArrays &particles, PairStream &stream);

  // False if the output stopped.
  bool run(const SearchTask &task);

 private:
  // Points that search together, the place of the first, and all places that they may meet.
  struct Searchers {
    ChunkGroup points;
    double place[3];
    PlaceBox box;
  };

  bool search_together(const SearchTask &task) const;
  void gather_particles(const SearchTask &task, uint32_t begin, Searchers &searchers) const;
  void gather_images(const SearchTask &task, uint32_t begin, Searchers &searchers) const;
  void set_box(const SearchTask &task, Searchers &searchers) const;
  bool search(const SearchTask &task, const ChunkTable &table, const Searchers &searchers);

  const Index &index_;
  const PointArrays &points_;
  const PointArrays &particles_;
  PairStream &stream_;
  const ChunkSearchKernel &kernel_;
};

}  // namespace hg
