// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search of an index, cut into tasks of similar size: each level with itself, and with each finer one. The cut, and
// so the order of the pairs, does not depend on the number of threads.
#pragma once

#include "src/index/index.hpp"

namespace hg {

// Points [begin, end), particles of `level` or its images, against the particles of `target`, a level not coarser.
struct SearchTask {
  int level, target;
  bool images;
  uint32_t begin, end;
};

class SearchTasks {
 public:
  explicit SearchTasks(Memory &memory) : tasks_(memory) {}

  // All of the search, in the order of its pairs.
  void list(const Index &index);

  size_t count() const { return count_; }
  const SearchTask &operator[](size_t task) const { return tasks_[task]; }

 private:
  void add(const Index &index, int level, int target, bool images, uint32_t begin, uint32_t end);

  Buffer<SearchTask> tasks_;
  size_t count_ = 0;
};

}  // namespace hg
