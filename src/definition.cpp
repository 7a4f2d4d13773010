// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/definition.hpp"

#include "src/base/error.hpp"
#include "src/base/ordered_bits.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace hg {
namespace {

constexpr uint32_t kFirstStructSize = offsetof(hg_grid_def, level_price);  // of version 0.1, the first

constexpr double kPaperOverhead = 0.3;  // K of Eq. 7

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

// `where`: "def." or nothing, for messages.
void check_box(Domain &domain, int axis, double low, double high, const char *where) {
  if (!std::isfinite(low) || !std::isfinite(high)) {
    fail(HG_ERR_ARGUMENT, "%sbox_min[%d], %sbox_max[%d] = %g, %g are not finite", where, axis, where, axis, low, high);
  }
  if (high < low || (domain.periodic[axis] && high == low)) {
    fail(HG_ERR_ARGUMENT, "%sbox_max[%d] = %g is not above %sbox_min[%d] = %g", where, axis, high, where, axis, low);
  }
  domain.box_min[axis] = low;
  domain.box_max[axis] = high;
  domain.length[axis] = high - low;
  if (!std::isfinite(domain.length[axis])) {
    fail(HG_ERR_ARGUMENT, "%sbox_max[%d] - %sbox_min[%d] overflows", where, axis, where, axis);
  }
}

// Of the higher axis to the lower one.
void check_tilt(Domain &domain, int higher, int lower, double tilt, const char *where) {
  const int k = kTiltOf[higher][lower];
  if (!std::isfinite(tilt)) fail(HG_ERR_ARGUMENT, "%stilt[%d] = %g is not finite", where, k, tilt);
  if (tilt == 0) return;
  if (higher >= domain.dimension || !domain.periodic[higher] || !domain.periodic[lower]) {
    fail(HG_ERR_ARGUMENT, "%stilt[%d] = %g needs periodic %c and %c", where, k, tilt, "xyz"[lower], "xyz"[higher]);
  }
  if (!(std::fabs(tilt) <= kMaxTiltedWraps * domain.length[lower])) {
    fail(HG_ERR_LIMIT, "%stilt[%d] = %g is more than 2^19 lengths %g of the box in %c", where, k, tilt,
         domain.length[lower], "xyz"[lower]);
  }
  domain.tilt[k] = tilt;
}

void check_tilts(Domain &domain, const double *tilt, const char *where) {
  for (int higher = 1; higher < 3; higher++) {
    for (int lower = 0; lower < higher; lower++) {
      check_tilt(domain, higher, lower, tilt[kTiltOf[higher][lower]], where);
    }
  }
  if (!domain.is_tilted()) return;
  double longest = 0, shortest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < domain.dimension; axis++) {
    if (!domain.periodic[axis]) continue;
    longest = std::max(longest, domain.length[axis]);
    shortest = std::min(shortest, domain.length[axis]);
  }
  if (shortest < longest / kMostStretched) {
    fail(HG_ERR_LIMIT, "%stilt: a cell with edges of %g and %g is too thin to be tilted", where, longest, shortest);
  }
}

Domain check_domain(const hg_grid_def &def) {
  Domain domain;
  domain.dimension = def.dimension;
  domain.all_images = def.images == HG_ALL_IMAGES;
  for (int axis = 0; axis < def.dimension; axis++) {
    if (def.periodic[axis] != 0 && def.periodic[axis] != 1) {
      fail(HG_ERR_ARGUMENT, "def.periodic[%d] = %d is not 0 or 1", axis, static_cast<int>(def.periodic[axis]));
    }
    domain.periodic[axis] = def.periodic[axis] == 1;
    domain.any_periodic = domain.any_periodic || domain.periodic[axis];
    check_box(domain, axis, def.box_min[axis], def.box_max[axis], "def.");
  }
  check_tilts(domain, def.tilt, "def.");
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
  levels.prices.level = check_price("level_price", def.level_price, kFittedPrice);
  levels.prices.row = check_price("row_price", def.row_price, kFittedPrice);
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
  check_choice("touching", def.touching, 0, 1);
  check_choice("images", def.images, HG_NEAREST_IMAGE, HG_ALL_IMAGES);
  check_length("margin", def.margin);
  check_length("skin", def.skin);

  Definition checked;
  checked.dimension = def.dimension;
  checked.thread_count = def.thread_count;
  checked.index_base = def.index_base;
  checked.accuracy = def.accuracy;
  checked.pair_order = def.pair_order;
  checked.interaction = {def.interaction, def.margin, def.touching == 1};
  checked.skin = def.skin;
  checked.domain = check_domain(def);
  checked.levels = check_levels(def);
  return checked;
}

Domain change_box(const Domain &domain, const double *box_min, const double *box_max, const double *tilt) {
  Domain changed = domain;
  for (int axis = 0; axis < domain.dimension; axis++) {
    if (domain.periodic[axis]) check_box(changed, axis, box_min[axis], box_max[axis], "");
  }
  std::fill(changed.tilt, changed.tilt + 3, 0.0);
  if (tilt != nullptr) check_tilts(changed, tilt, "");
  return changed;
}

}  // namespace hg
