// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The cut of a search into tasks: together they hold each level with itself and with all finer ones, nothing twice.
#include "src/search/search_tasks.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/crowd.hpp"

#include <map>
#include <tuple>
#include <utility>

namespace {

using namespace hgtest;

using Range = std::pair<uint32_t, uint32_t>;
using Part = std::tuple<int, int, bool>;  // level, target, images

std::map<Part, Range> expected_parts(const hg::Index &index) {
  std::map<Part, Range> parts;
  for (int h = 0; h < index.level_count; h++) {
    const hg::IndexLevel &level = index.levels[h];
    for (int k = 0; k <= h; k++) {
      if (index.levels[k].begin == index.levels[k].end) continue;
      const uint32_t image_end = k == h ? level.image_forward_end : level.image_end;
      if (level.begin < level.end) parts[{h, k, false}] = {level.begin, level.end};
      if (level.image_begin < image_end) parts[{h, k, true}] = {level.image_begin, image_end};
    }
  }
  return parts;
}

void check_tasks(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  const Crowd crowd(seed, memory, any_shape(rng, rng.below(rng.chance(0.2) ? 60000 : 500)));
  const hg::Index &index = crowd.index;

  std::map<Part, Range> left = expected_parts(index);
  for (size_t t = 0; t < crowd.tasks.count(); t++) {
    const hg::SearchTask &task = crowd.tasks[t];
    const auto part = left.find({task.level, task.target, task.images});
    require(part != left.end(), "task %zu: level %d with %d is not due", t, task.level, task.target);
    require(task.begin == part->second.first && task.end > task.begin && task.end <= part->second.second,
            "task %zu: [%u, %u) where [%u, %u) is due", t, task.begin, task.end, part->second.first,
            part->second.second);
    part->second.first = task.end;
    if (part->second.first == part->second.second) left.erase(part);
    const bool last = left.find({task.level, task.target, task.images}) == left.end();
    require(last || (task.end - task.begin) % 16 == 0, "task %zu cuts a block: %u points", t, task.end - task.begin);
  }
  require(left.empty(), "%zu parts of the search are not done", left.size());
}

void tasks_cover_the_search(void **) { assert_true(sweep(60, check_tasks)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(tasks_cover_the_search)};
  return cmocka_run_group_tests_name("search_tasks", tests, nullptr, nullptr);
}
