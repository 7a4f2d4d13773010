// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Who frees a handle: moves, empty objects, constructors that fail. The books of an allocator tell.
#include "tests/cpp/chain.hpp"
#include "tests/support/failing_alloc.h"

#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace hgtest;

template <class T>
constexpr bool kMovesOnly =
    std::is_nothrow_move_constructible_v<T> &&std::is_nothrow_move_assignable_v<T>
        &&std::is_nothrow_destructible_v<T> && !std::is_copy_constructible_v<T> && !std::is_copy_assignable_v<T>;
static_assert(kMovesOnly<hgrid::Grid> && kMovesOnly<hgrid::History>);
static_assert(std::is_base_of_v<std::exception, hgrid::Error> && std::is_nothrow_copy_constructible_v<hgrid::Error>);
static_assert(std::is_trivially_copyable_v<hgrid::View<hg_pair>>);

// Nothing is left once `check` is over.
template <void (*check)()>
void balanced() {
  failing_alloc_install();
  check();
  failing_alloc_remove();
  const alloc_books books = failing_alloc_books();
  require(books.calls > 0 && books.live_blocks == 0 && books.live_bytes == 0 && books.faults == 0, "memory is left");
}

void moved() {
  hgrid::Grid first = chain();
  hg_grid *const handle = first.get();
  hgrid::Grid second(std::move(first));
  require(second.get() == handle, "the handle has changed");
  require_chain(second);
  hgrid::Grid third;
  third = std::move(second);
  require(third.get() == handle, "the handle has changed");
  std::swap(third, second);
  std::vector<hgrid::Grid> grids(5);
  for (hgrid::Grid &grid : grids) grid = chain();
  grids.erase(grids.begin());
  grids.resize(50);
  for (size_t k = 0; k < 4; k++) require_chain(grids[k]);
  require_chain(second);
}

void moved_to_itself() {
  hgrid::Grid grid = chain();
  hgrid::Grid &same = grid;
  grid = std::move(same);
  require_chain(grid);
  hgrid::History history;
  hgrid::History &same_history = history;
  history = std::move(same_history);
  history.clear();
}

void empty_objects_refuse_calls() {
  std::vector<hgrid::Grid> grids(1);
  { const hgrid::Grid gone(std::move(grids[0])); }
  hgrid::Grid &grid = grids[0];
  require(grid.get() == nullptr, "a grid that was moved from has a handle");
  require_error(HG_ERR_NULL, "grid", [&] { grid.query_pairs(); });
  require_error(HG_ERR_NULL, "grid", [&] { grid.insert(0, nullptr, nullptr); });
  require_error(HG_ERR_NULL, "grid", [&] { grid.query_neighbors(HG_HALF); });
  require_error(HG_ERR_NULL, "grid", [&] { grid.set_box(kCenters, kRadii); });
  require_error(HG_ERR_NULL, "grid", [&] { grid.visit_pairs([](hgrid::View<hg_pair>) {}); });
  grid = chain();
  require_chain(grid);
  std::vector<hgrid::History> histories(1);
  const hgrid::History other(std::move(histories[0]));
  require_error(HG_ERR_NULL, "history", [&] { histories[0].pairs(); });
}

// Each request for memory is refused once.
void no_memory_to_create() {
  for (int refused = 0;; refused++) {
    failing_alloc_arm(refused);
    bool complete = true;
    try {
      const hgrid::Grid grid;
      const hgrid::History history;
    } catch (const hgrid::Error &error) {
      require(error.status() == HG_ERR_MEMORY, error.what());
      complete = false;
    }
    failing_alloc_arm(-1);
    require(failing_alloc_books().live_blocks == 0, "a constructor that failed left memory");
    if (complete) {
      require(refused > 1, "nothing was refused");
      return;
    }
  }
}

void no_memory_to_search() {
  for (int refused = 0;; refused++) {
    hgrid::Grid grid = chain();
    failing_alloc_arm(refused);
    bool complete = true;
    try {
      grid.query_pairs();
    } catch (const hgrid::Error &error) {
      require(error.status() == HG_ERR_MEMORY && error.what()[0] != '\0', error.what());
      complete = false;
    }
    failing_alloc_arm(-1);
    require_chain(grid);
    if (complete) {
      require(refused > 1, "nothing was refused");
      return;
    }
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(run<balanced<moved>>), cmocka_unit_test(run<balanced<moved_to_itself>>),
                              cmocka_unit_test(run<balanced<empty_objects_refuse_calls>>),
                              cmocka_unit_test(run<balanced<no_memory_to_create>>),
                              cmocka_unit_test(run<balanced<no_memory_to_search>>)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
