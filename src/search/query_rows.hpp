// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Many queries of single places at once: the rows of ids that they find, in the order of the queries. Inside they go
// along space, so that those that follow each other look at the same particles.
#pragma once

#include "src/base/memory.hpp"
#include "src/search/built_grid.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hg {

// Queries of one kind, which threads may ask at the same time.
class RowSource {
 public:
  virtual size_t count() const = 0;
  // Where query k is, more or less, as a centre.
  virtual void find_center(size_t k, double *center) const = 0;
  // Writes the ids that query k finds, ascending, behind the `count` that are in the buffer already. Returns how many
  // are there then.
  virtual size_t find(size_t k, Buffer<int32_t> &ids, size_t count) const = 0;

 protected:
  ~RowSource() = default;
};

// Puts ids [begin, end) into ascending order, each once: they stand there several times only if they `may_repeat`.
// Returns their end.
size_t ascend_row(Buffer<int32_t> &ids, size_t begin, size_t end, bool may_repeat);

// Not of a grid: it comes from malloc.
class QueryRows {
 public:
  // So much memory stays between queries, or as much as the last one took if that is more.
  static constexpr int64_t kMostKept = int64_t{1} << 24;  // bytes

  void find(const BuiltGrid &grid, const RowSource &source);

  // As in hg_query_neighbors.
  const int64_t *offsets() const { return offsets_.data(); }
  const int32_t *ids() const { return ids_.data(); }
  int64_t kept_bytes() const { return memory_.bytes(); }

 private:
  // What one thread finds, on cache lines of its own.
  struct alignas(128) Worker {
    explicit Worker(Memory &memory) : ids(memory) {}
    Buffer<int32_t> ids;
    size_t count = 0;
  };
  // Where a row lies until all are known.
  struct FoundRow {
    size_t begin;
    int worker;
  };

  void start(const BuiltGrid &grid, size_t count);

  Memory memory_{system_allocator()};
  Buffer<int64_t> offsets_{memory_};
  Buffer<int32_t> ids_{memory_};
  Buffer<uint64_t> order_{memory_};
  Buffer<FoundRow> rows_{memory_};
  std::vector<Worker> workers_;
};

}  // namespace hg
