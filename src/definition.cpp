// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/definition.hpp"

#include "src/base/error.hpp"
#include "src/base/ordered_bits.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace hg {
namespace {

constexpr uint32_t kFirstStructSize = offsetof(hg_grid_def, level_price);  // of version 0.1, the first

constexpr double kPaperOverhead = 0.3;  // K of Eq. 7

// Of `hgrid calibrate`: docs/decisions/0018-levels-by-cost.md.
constexpr double kLevelPrice = 4;
constexpr double kRowPrice = 18;

void check_choice(const char *name, int32_t value, int32_t least, int32_t greatest) {
  if (value < least || value > greatest) {
    fail(HG_ERR_ARGUMENT, "def.%s = %d is not in [%d, %d]", name, static_cast<int>(value), static_cast<int>(least),
         static_cast<int>(greatest));
  }
}

// A price in units of one test: the caller's, or the library's own where it is negative.
double check_price(const char *name, double value, double fitted) {
  if (!std::isfinite(value)) fail(HG_ERR_ARGUMENT, "def.%s = %g is not finite", name, value);
  return value < 0 ? fitted : value;
}

void check_length(const char *name, double value) {
  if (!std::isfinite(value) || is_negative(value))
    fail(HG_ERR_ARGUMENT, "def.%s = %g is not finite and >= 0", name, value);
}

Domain check_domain(const hg_grid_def &def) {
  Domain domain;
  domain.dimension = def.dimension;
  for (int axis = 0; axis < def.dimension; axis++) {
    if (def.periodic[axis] != 0 && def.periodic[axis] != 1) {
      fail(HG_ERR_ARGUMENT, "def.periodic[%d] = %d is not 0 or 1", axis, static_cast<int>(def.periodic[axis]));
    }
    const double low = def.box_min[axis], high = def.box_max[axis];
    if (!std::isfinite(low) || !std::isfinite(high)) {
      fail(HG_ERR_ARGUMENT, "def.box_min[%d], def.box_max[%d] = %g, %g are not finite", axis, axis, low, high);
    }
    domain.periodic[axis] = def.periodic[axis] == 1;
    domain.any_periodic = domain.any_periodic || domain.periodic[axis];
    if (high < low || (domain.periodic[axis] && high == low)) {
      fail(HG_ERR_ARGUMENT, "def.box_max[%d] = %g is not above def.box_min[%d] = %g", axis, high, axis, low);
    }
    domain.box_min[axis] = low;
    domain.box_max[axis] = high;
    domain.length[axis] = high - low;
    if (!std::isfinite(domain.length[axis]))
      fail(HG_ERR_ARGUMENT, "def.box_max[%d] - def.box_min[%d] overflows", axis, axis);
  }
  return domain;
}

LevelSettings check_levels(const hg_grid_def &def) {
  check_choice("level_rule", def.level_rule, HG_LEVELS_AUTO, HG_LEVELS_USER);
  if (def.level_count < 0) {
    fail(HG_ERR_ARGUMENT, "def.level_count = %d is negative", static_cast<int>(def.level_count));
  }
  if (def.level_count > HG_MAX_LEVELS) {
    fail(HG_ERR_LIMIT, "def.level_count = %d: at most %d levels", static_cast<int>(def.level_count),
         static_cast<int>(HG_MAX_LEVELS));
  }
  LevelSettings levels;
  levels.rule = def.level_rule;
  levels.level_count = def.level_count;
  levels.cell_overhead = check_price("cell_overhead", def.cell_overhead, kPaperOverhead);
  levels.counts_work = def.level_rule == HG_LEVELS_AUTO && def.cell_overhead < 0;
  levels.prices.level = check_price("level_price", def.level_price, kLevelPrice);
  levels.prices.row = check_price("row_price", def.row_price, kRowPrice);
  if (def.level_rule != HG_LEVELS_USER) return levels;
  if (def.level_count == 0) fail(HG_ERR_ARGUMENT, "def.level_count = 0: HG_LEVELS_USER needs cell_sizes");
  if (def.cell_sizes == nullptr) fail(HG_ERR_NULL, "def.cell_sizes is NULL with HG_LEVELS_USER");
  for (int h = 0; h < def.level_count; h++) {
    const double s = def.cell_sizes[h];
    if (!std::isfinite(s) || s <= 0) fail(HG_ERR_ARGUMENT, "def.cell_sizes[%d] = %g is not finite and > 0", h, s);
    if (h > 0 && s <= def.cell_sizes[h - 1]) {
      fail(HG_ERR_ARGUMENT, "def.cell_sizes[%d] = %g is not above cell_sizes[%d] = %g", h, s, h - 1,
           def.cell_sizes[h - 1]);
    }
    levels.cell_sizes[h] = s;
  }
  return levels;
}

}  // namespace

void fill_defaults(hg_grid_def *def, size_t struct_size) {
  if (struct_size < kFirstStructSize || struct_size > sizeof(hg_grid_def)) {
    fail(HG_ERR_ARGUMENT, "struct_size = %zu: this library knows %zu to %zu", struct_size,
         static_cast<size_t>(kFirstStructSize), sizeof(hg_grid_def));
  }
  hg_grid_def defaults;
  std::memset(&defaults, 0, sizeof defaults);
  defaults.struct_size = static_cast<uint32_t>(struct_size);
  defaults.dimension = 3;
  defaults.accuracy = HG_EXACT;
  defaults.pair_order = HG_ORDER_GRID;
  defaults.level_rule = HG_LEVELS_AUTO;
  defaults.cell_overhead = defaults.level_price = defaults.row_price = -1;
  std::memcpy(def, &defaults, struct_size);
}

Definition check_definition(const hg_grid_def &given) {
  if (given.struct_size < kFirstStructSize || given.struct_size > sizeof(hg_grid_def)) {
    fail(HG_ERR_ARGUMENT, "def.struct_size = %u: the definition was not initialised, or by a newer header",
         static_cast<unsigned>(given.struct_size));
  }
  hg_grid_def def;
  fill_defaults(&def, sizeof def);
  std::memcpy(&def, &given, given.struct_size);

  check_choice("dimension", def.dimension, 2, 3);
  check_choice("thread_count", def.thread_count, 0, 1024);
  check_choice("index_base", def.index_base, 0, 1);
  check_choice("interaction", def.interaction, 0, InteractionRules::kCount - 1);
  check_choice("accuracy", def.accuracy, HG_EXACT, HG_FLOAT);
  check_choice("pair_order", def.pair_order, HG_ORDER_GRID, HG_ORDER_ID);
  check_choice("reserved0", def.reserved0, 0, 0);
  check_choice("reserved1", def.reserved1, 0, 0);
  check_length("margin", def.margin);
  check_length("skin", def.skin);

  Definition checked;
  checked.dimension = def.dimension;
  checked.thread_count = def.thread_count;
  checked.index_base = def.index_base;
  checked.accuracy = def.accuracy;
  checked.pair_order = def.pair_order;
  checked.interaction = {def.interaction, def.margin};
  checked.skin = def.skin;
  checked.domain = check_domain(def);
  checked.levels = check_levels(def);
  return checked;
}

}  // namespace hg
