// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// check_definition(): what is accepted is copied, what is refused is named with its value.
#include "src/definition.hpp"
#include "tests/unit/checks.hpp"

#include <cstring>
#include <limits>

namespace {

using namespace hgtest;
using hg::check_definition;
using hg::Definition;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

hg_grid_def defaults() {
  hg_grid_def def;
  hg::fill_defaults(&def, sizeof def);
  return def;
}

// `change` makes the defaults wrong; the text must name the member and hold the value.
template <class Change>
void refused(hg_status status, const char *text, Change &&change) {
  hg_grid_def def = defaults();
  change(def);
  require_refused(text, status, text, [&] { check_definition(def); });
}

void check_defaults(uint64_t) {
  const hg_grid_def def = defaults();
  require(def.struct_size == sizeof def, "struct_size");
  const Definition checked = check_definition(def);
  require(checked.dimension == 3 && checked.index_base == 0, "dimension, index_base");
  require(checked.accuracy == HG_EXACT && checked.pair_order == HG_ORDER_GRID, "accuracy, pair_order");
  require(checked.interaction.kind == HG_CONTACT && checked.interaction.margin == 0, "interaction");
  require(checked.levels.rule == HG_LEVELS_AUTO && checked.levels.level_count == 0, "level_rule");
  require(checked.levels.counts_work && checked.levels.largest_diameter() == kInfinity, "AUTO counts work");
  require(checked.levels.prices.level < 0 && checked.levels.prices.row < 0, "fitted prices");
  require(!checked.domain.any_periodic && checked.domain.dimension == 3, "domain");
}

void check_copies(uint64_t) {
  const double sizes[2] = {0.5, 2};
  hg_grid_def def = defaults();
  def.dimension = 2;
  def.index_base = 1;
  def.interaction = HG_MAX_RANGE;
  def.accuracy = HG_FLOAT;
  def.pair_order = HG_ORDER_ID;
  def.level_rule = HG_LEVELS_USER;
  def.level_count = 2;
  def.cell_sizes = sizes;
  def.margin = 0.25;
  def.cell_overhead = 0;
  def.periodic[1] = 1;
  def.box_min[1] = -1;
  def.box_max[1] = 3;
  def.periodic[2] = 77;  // not an axis in 2D, so of no matter
  const Definition checked = check_definition(def);
  require(checked.dimension == 2 && checked.index_base == 1, "dimension, index_base");
  require(checked.interaction.kind == HG_MAX_RANGE && checked.interaction.margin == 0.25, "interaction");
  require(checked.accuracy == HG_FLOAT && checked.pair_order == HG_ORDER_ID, "accuracy, pair_order");
  require(checked.levels.rule == HG_LEVELS_USER && checked.levels.level_count == 2, "level_rule");
  require(checked.levels.cell_sizes[0] == 0.5 && checked.levels.cell_sizes[1] == 2, "cell_sizes");
  require(checked.levels.cell_overhead == 0 && checked.levels.largest_diameter() == 2, "cell_overhead");
  require(checked.domain.any_periodic && !checked.domain.periodic[0] && checked.domain.periodic[1], "periodic");
  require(checked.domain.box_min[1] == -1 && checked.domain.box_max[1] == 3 && checked.domain.length[1] == 4, "box");
}

// A caller who was compiled with version 0.1 knows no prices.
void check_first_size(uint64_t) {
  hg_grid_def def;
  std::memset(&def, 0x7f, sizeof def);
  hg::fill_defaults(&def, 136);
  require(def.struct_size == 136 && def.level_price > 1e300, "memory beyond the caller's struct was written");
  const Definition checked = check_definition(def), now = check_definition(defaults());
  require(checked.levels.prices.level == now.levels.prices.level && checked.levels.prices.row == now.levels.prices.row,
          "prices of an older caller");
}

void check_prices(uint64_t) {
  hg_grid_def def = defaults();
  def.level_price = 0;
  def.row_price = 7;
  Definition checked = check_definition(def);
  require(checked.levels.counts_work && checked.levels.prices.level == 0 && checked.levels.prices.row == 7,
          "the caller's prices");
  def.cell_overhead = 0;
  require(!check_definition(def).levels.counts_work, "AUTO with K goes by Eq. 7");
  def.cell_overhead = -1;
  def.level_rule = HG_LEVELS_PAPER;
  require(!check_definition(def).levels.counts_work, "PAPER goes by Eq. 7");
}

void check_paper_overhead(uint64_t) {
  hg_grid_def def = defaults();
  def.level_rule = HG_LEVELS_PAPER;
  require(check_definition(def).levels.cell_overhead == 0.3, "K of the paper is 0.3");
  def.cell_overhead = 0.45;
  require(check_definition(def).levels.cell_overhead == 0.45, "the caller's K");
}

void check_struct_size(uint64_t) {
  hg_grid_def def;
  require_refused("too small", HG_ERR_ARGUMENT, "struct_size", [&] { hg::fill_defaults(&def, 135); });
  require_refused("too large", HG_ERR_ARGUMENT, "struct_size", [&] { hg::fill_defaults(&def, sizeof def + 8); });
  refused(HG_ERR_ARGUMENT, "def.struct_size = 0", [](hg_grid_def &d) { d.struct_size = 0; });
  refused(HG_ERR_ARGUMENT, "def.struct_size", [](hg_grid_def &d) { d.struct_size += 8; });
}

void check_choices(uint64_t) {
  refused(HG_ERR_ARGUMENT, "def.dimension = 1", [](hg_grid_def &d) { d.dimension = 1; });
  refused(HG_ERR_ARGUMENT, "def.dimension = 4", [](hg_grid_def &d) { d.dimension = 4; });
  refused(HG_ERR_ARGUMENT, "def.thread_count = -1", [](hg_grid_def &d) { d.thread_count = -1; });
  refused(HG_ERR_ARGUMENT, "def.thread_count = 1025", [](hg_grid_def &d) { d.thread_count = 1025; });
  refused(HG_ERR_ARGUMENT, "def.index_base = -1", [](hg_grid_def &d) { d.index_base = -1; });
  refused(HG_ERR_ARGUMENT, "def.index_base = 2", [](hg_grid_def &d) { d.index_base = 2; });
  refused(HG_ERR_ARGUMENT, "def.interaction = 2", [](hg_grid_def &d) { d.interaction = 2; });
  refused(HG_ERR_ARGUMENT, "def.accuracy = 3", [](hg_grid_def &d) { d.accuracy = 3; });
  refused(HG_ERR_ARGUMENT, "def.accuracy = -1", [](hg_grid_def &d) { d.accuracy = -1; });
  refused(HG_ERR_ARGUMENT, "def.pair_order = 2", [](hg_grid_def &d) { d.pair_order = 2; });
  refused(HG_ERR_ARGUMENT, "def.level_rule = 3", [](hg_grid_def &d) { d.level_rule = 3; });
  refused(HG_ERR_ARGUMENT, "def.level_count = -1", [](hg_grid_def &d) { d.level_count = -1; });
  refused(HG_ERR_LIMIT, "def.level_count = 65", [](hg_grid_def &d) { d.level_count = HG_MAX_LEVELS + 1; });
}

void check_lengths(uint64_t) {
  for (double bad : {-1.0, -5e-324, kNaN, kInfinity}) {
    refused(HG_ERR_ARGUMENT, "def.margin = ", [&](hg_grid_def &d) { d.margin = bad; });
    refused(HG_ERR_ARGUMENT, "def.skin = ", [&](hg_grid_def &d) { d.skin = bad; });
  }
  refused(HG_ERR_ARGUMENT, "def.margin = -1", [](hg_grid_def &d) { d.margin = -1; });
  refused(HG_ERR_ARGUMENT, "def.cell_overhead = nan", [](hg_grid_def &d) { d.cell_overhead = kNaN; });
  refused(HG_ERR_ARGUMENT, "def.level_price = nan", [](hg_grid_def &d) { d.level_price = kNaN; });
  refused(HG_ERR_ARGUMENT, "def.row_price = -inf", [](hg_grid_def &d) { d.row_price = -kInfinity; });
  refused(HG_ERR_ARGUMENT, "def.cell_overhead = inf", [](hg_grid_def &d) { d.cell_overhead = kInfinity; });
}

void check_boxes(uint64_t) {
  refused(HG_ERR_ARGUMENT, "def.periodic[1] = 2", [](hg_grid_def &d) { d.periodic[1] = 2; });
  refused(HG_ERR_ARGUMENT, "def.box_max[2] = 0", [](hg_grid_def &d) { d.periodic[2] = 1; });
  refused(HG_ERR_ARGUMENT, "def.box_max[0] = -1", [](hg_grid_def &d) { d.box_max[0] = -1; });
  refused(HG_ERR_ARGUMENT, "box_max[0] = 0, nan", [](hg_grid_def &d) { d.box_max[0] = kNaN; });
  refused(HG_ERR_ARGUMENT, "box_max[1] = -inf, 0", [](hg_grid_def &d) { d.box_min[1] = -kInfinity; });
  refused(HG_ERR_ARGUMENT, "overflows", [](hg_grid_def &d) {
    d.box_min[0] = -1e308;
    d.box_max[0] = 1e308;
  });
}

void check_cell_sizes(uint64_t) {
  static constexpr double kDuplicate[] = {1, 1}, kFalling[] = {1, 0.5}, kZero[] = {0, 1}, kNegative[] = {-1, 1};
  static constexpr double kNotANumber[] = {1, kNaN}, kInfinite[] = {1, kInfinity};
  const auto with = [](const double *sizes, int32_t count) {
    return [=](hg_grid_def &d) {
      d.level_rule = HG_LEVELS_USER;
      d.level_count = count;
      d.cell_sizes = sizes;
    };
  };
  refused(HG_ERR_NULL, "def.cell_sizes", with(nullptr, 2));
  refused(HG_ERR_ARGUMENT, "def.level_count = 0", with(kDuplicate, 0));
  refused(HG_ERR_ARGUMENT, "def.cell_sizes[1] = 1", with(kDuplicate, 2));
  refused(HG_ERR_ARGUMENT, "def.cell_sizes[1] = 0.5", with(kFalling, 2));
  refused(HG_ERR_ARGUMENT, "def.cell_sizes[0] = 0", with(kZero, 2));
  refused(HG_ERR_ARGUMENT, "def.cell_sizes[0] = -1", with(kNegative, 2));
  refused(HG_ERR_ARGUMENT, "def.cell_sizes[1] = nan", with(kNotANumber, 2));
  refused(HG_ERR_ARGUMENT, "def.cell_sizes[1] = inf", with(kInfinite, 2));
}

void defaults_hold(void **) { assert_true(holds(0, check_defaults)); }
void members_are_copied(void **) { assert_true(holds(0, check_copies)); }
void paper_overhead(void **) { assert_true(holds(0, check_paper_overhead)); }
void first_size(void **) { assert_true(holds(0, check_first_size)); }
void prices(void **) { assert_true(holds(0, check_prices)); }
void struct_size(void **) { assert_true(holds(0, check_struct_size)); }
void choices(void **) { assert_true(holds(0, check_choices)); }
void lengths(void **) { assert_true(holds(0, check_lengths)); }
void boxes(void **) { assert_true(holds(0, check_boxes)); }
void cell_sizes(void **) { assert_true(holds(0, check_cell_sizes)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(defaults_hold),  cmocka_unit_test(members_are_copied),
      cmocka_unit_test(paper_overhead), cmocka_unit_test(struct_size),
      cmocka_unit_test(first_size),     cmocka_unit_test(prices),
      cmocka_unit_test(choices),        cmocka_unit_test(lengths),
      cmocka_unit_test(boxes),          cmocka_unit_test(cell_sizes),
  };
  return cmocka_run_group_tests_name("definition", tests, nullptr, nullptr);
}
