// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid::Grid::visit_pairs and visit_contacts: every kind of callable, how a visit ends, and what a callable throws.
#include "tests/cpp/chain.hpp"

#include <functional>
#include <memory>
#include <stdexcept>

namespace {

using namespace hgtest;

// Pairs enough for several batches: spheres that all meet each other.
constexpr size_t kCrowd = 200;
constexpr size_t kCrowdPairs = kCrowd * (kCrowd - 1) / 2;

hgrid::Grid crowd() {
  const std::vector<double> centers(3 * kCrowd, 0), radii(kCrowd, 1);
  hgrid::Grid grid;
  grid.insert(kCrowd, centers.data(), radii.data());
  return grid;
}

size_t found_by_function = 0;
void count_in_function(hgrid::View<hg_pair> pairs) { found_by_function += pairs.size(); }

void any_callable_will_do() {
  hgrid::Grid grid = crowd();
  size_t found = 0;
  grid.visit_pairs([&](hgrid::View<hg_pair> pairs) { found += pairs.size(); });
  require(found == kCrowdPairs, "a lambda that takes a view");
  found = 0;
  grid.visit_pairs([&](const hg_pair *, size_t count) { found += count; });
  require(found == kCrowdPairs, "a lambda that takes pointer and count");
  found = 0;
  grid.visit_pairs([&](auto pairs) {
    for (const hg_pair pair : pairs) found += pair.a < pair.b ? 1 : 0;
  });
  require(found == kCrowdPairs, "a generic lambda");
  found = 0;
  const std::function<void(hgrid::View<hg_pair>)> function = [&](hgrid::View<hg_pair> pairs) { found += pairs.size(); };
  grid.visit_pairs(function);
  require(found == kCrowdPairs, "a constant std::function");
  grid.visit_pairs(count_in_function);
  require(found_by_function == kCrowdPairs, "a function");
  grid.visit_pairs([own = std::make_unique<size_t>(0), &found](hgrid::View<hg_pair> pairs) mutable {
    *own += pairs.size();
    found = *own;
  });
  require(found == kCrowdPairs, "a lambda that can only be moved");
}

int32_t count_and_stop(void *context, const hg_pair *, size_t count) {
  *static_cast<size_t *>(context) += count;
  return 1;
}

void what_is_true_ends_the_visit() {
  hgrid::Grid grid = crowd();
  size_t batch = 0, visits = 0;
  grid.visit_pairs(count_and_stop, &batch);
  require(batch > 0 && batch < kCrowdPairs, "the C pair does not end the visit");
  grid.visit_pairs([&](hgrid::View<hg_pair>) { return ++visits == 2; });
  require(visits == 2, "true does not end the visit, or false does");
  visits = 0;
  grid.visit_pairs([&](const hg_pair *, size_t) { return ++visits < 3 ? 0 : 2; });
  require(visits == 3, "2 does not end the visit, or 0 does");
  require(grid.query_pairs().size() == kCrowdPairs, "the grid has suffered");
}

void exceptions_pass_around_c() {
  hgrid::Grid grid = crowd();
  size_t visits = 0;
  try {
    grid.visit_pairs([&](hgrid::View<hg_pair>) {
      if (++visits == 2) throw std::out_of_range("seen enough");
    });
    throw Failure("the exception is lost");
  } catch (const std::out_of_range &error) {
    require(error.what() == std::string("seen enough") && visits == 2, "the visit went on");
  }
  try {
    grid.visit_pairs([](const hg_pair *, size_t) -> bool { throw 17; });
    throw Failure("the number is lost");
  } catch (const int number) {
    require(number == 17, "another number");
  }
  require(grid.query_pairs().size() == kCrowdPairs, "the grid has suffered");
}

void calls_from_inside_are_refused() {
  hgrid::Grid grid = crowd();
  size_t visits = 0;
  require_error(HG_ERR_STATE, "visited", [&] {
    grid.visit_pairs([&](hgrid::View<hg_pair>) {
      visits++;
      grid.query_pairs();
    });
  });
  require(visits == 1, "the visit went on");
  grid.visit_pairs([&](hgrid::View<hg_pair>) {
    require_error(HG_ERR_STATE, "visited", [&] { grid.clear(); });
    return true;
  });
  require(grid.query_pairs().size() == kCrowdPairs, "the grid has suffered");
}

int32_t add_contacts(void *context, const hg_contact_batch *batch) {
  *static_cast<size_t *>(context) += batch->count;
  return 0;
}

void contacts_come_in_batches() {
  hgrid::Grid grid = crowd();
  size_t found = 0, visits = 0;
  grid.visit_contacts([&](const hg_contact_batch &batch) {
    for (size_t k = 0; k < batch.count; k++) {
      found += batch.a[k] < batch.b[k] && batch.dz[k] == 0 && batch.reach[k] == 2 ? 1 : 0;
    }
  });
  require(found == kCrowdPairs, "a lambda that takes a batch");
  found = 0;
  grid.visit_contacts([&](auto batch) { found += batch.count; });
  require(found == kCrowdPairs, "a generic lambda");
  found = 0;
  grid.visit_contacts(add_contacts, &found);
  require(found == kCrowdPairs, "a C visitor");
  grid.visit_contacts([&](const hg_contact_batch &) { return ++visits == 2; });
  require(visits == 2, "true does not end the visit, or false does");
  try {
    grid.visit_contacts([](const hg_contact_batch &) { throw 17; });
    throw Failure("the number is lost");
  } catch (const int number) {
    require(number == 17, "another number");
  }
  require_error(HG_ERR_STATE, "visited",
                [&] { grid.visit_contacts([&](const hg_contact_batch &) { grid.query_pair_vectors(); }); });
  require_error(HG_ERR_NULL, "visit", [&] { grid.visit_contacts(nullptr, nullptr); });
  require(grid.query_pairs().size() == kCrowdPairs, "the grid has suffered");
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(run<any_callable_will_do>), cmocka_unit_test(run<what_is_true_ends_the_visit>),
      cmocka_unit_test(run<exceptions_pass_around_c>), cmocka_unit_test(run<calls_from_inside_are_refused>),
      cmocka_unit_test(run<contacts_come_in_batches>)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
