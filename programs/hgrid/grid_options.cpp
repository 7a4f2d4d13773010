// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Options of every command that searches: how the grid works.
#include "programs/hgrid/grid_options.hpp"

#include "particles/error.hpp"
#include "particles/insert.hpp"
#include "programs/hgrid/arguments.hpp"

#include <CLI/CLI.hpp>

#include <vector>

namespace command {
namespace {

constexpr int kMostThreads = 1024;

int32_t accuracy_of(const std::string &word) {
  if (word == "double") return HG_DOUBLE;
  return word == "float" ? HG_FLOAT : HG_EXACT;
}

}  // namespace

void add_base_option(CLI::App &command, GridOptions &options) {
  command.add_option("--base", options.index_base, "The number of the first particle of the file in a and b: 0 or 1")
      ->capture_default_str()
      ->check(CLI::IsMember({0, 1}));
}

void add_price_options(CLI::App &command, double &level_price, double &row_price, const std::string &group,
                       CLI::Option *instead) {
  auto *level = command.add_option("--level-price", level_price, "Cost of a level per particle, in tests (fitted)");
  auto *row = command.add_option("--row-price", row_price, "Cost of looking at a row of cells, in tests (fitted)");
  for (CLI::Option *price : {level, row}) {
    price->check(not_negative())->group(group);
    if (instead != nullptr) price->excludes(instead);
  }
}

void add_grid_options(CLI::App &command, GridOptions &options) {
  const char *const group = "Search";
  command.add_option("--margin", options.margin, "Also particles nearer than this to touching, in the file's unit")
      ->check(not_negative())
      ->group(group);
  command.add_flag("--max-range", options.max_range, "Radii are ranges: |xi - xj| < max(ri, rj) + margin")
      ->group(group);
  command.add_flag("--touching", options.touching, "Spheres that exactly touch count, too: <= instead of <")
      ->group(group);
  command
      .add_option("--images", options.images,
                  "Two particles meet once, by their nearest images (nearest), or once for each periodic image in\n"
                  "reach, also a particle with its own, in boxes of any length (all)")
      ->capture_default_str()
      ->check(CLI::IsMember({"nearest", "all"}))
      ->group(group);
  command.add_option("--accuracy", options.accuracy, "How overlap is decided: exact, double or float")
      ->capture_default_str()
      ->check(CLI::IsMember({"exact", "double", "float"}))
      ->group(group);
  command.add_option("--order", options.order, "Order of the contacts: id (ascending) or grid (fastest)")
      ->capture_default_str()
      ->check(CLI::IsMember({"id", "grid"}))
      ->group(group);
  auto *levels = command.add_option("--levels", options.levels, "Rule for the levels: auto or paper")
                     ->capture_default_str()
                     ->check(CLI::IsMember({"auto", "paper"}))
                     ->group(group);
  auto *count = command.add_option("--level-count", options.level_count, "At most so many levels; 0: the cheapest")
                    ->check(CLI::Range(0, static_cast<int>(HG_MAX_LEVELS)))
                    ->group(group);
  command.add_option("--cell-sizes", options.cell_sizes, "S1,S2,...: the cell edge of each level instead, ascending")
      ->group(group)
      ->excludes(levels)
      ->excludes(count);
  auto *overhead = command.add_option("--cell-overhead", options.cell_overhead, "Choose by the cost L (m + K), this K")
                       ->check(not_negative())
                       ->group(group);
  add_price_options(command, options.level_price, options.row_price, group, overhead);
  command.add_option("--threads", options.threads, "Threads; 0: all that the machine offers")
      ->capture_default_str()
      ->check(CLI::Range(0, kMostThreads))
      ->group(group);
}

hg_grid_def grid_def(const GridOptions &options, const particles::ParticleSet &particles,
                     const std::vector<double> &cell_sizes) {
  hg_grid_def def = hg_default_grid_def();
  particles::set_box(particles, def);
  def.index_base = options.index_base;
  def.margin = options.margin;
  def.interaction = options.max_range ? HG_MAX_RANGE : HG_CONTACT;
  def.touching = options.touching ? 1 : 0;
  def.images = options.images == "all" ? HG_ALL_IMAGES : HG_NEAREST_IMAGE;
  def.accuracy = accuracy_of(options.accuracy);
  def.pair_order = options.order == "id" ? HG_ORDER_ID : HG_ORDER_GRID;
  def.level_rule = options.levels == "paper" ? HG_LEVELS_PAPER : HG_LEVELS_AUTO;
  def.level_count = options.level_count;
  if (!cell_sizes.empty()) {
    def.level_rule = HG_LEVELS_USER;
    def.level_count = static_cast<int32_t>(cell_sizes.size());
    def.cell_sizes = cell_sizes.data();
  }
  def.cell_overhead = options.cell_overhead;
  def.level_price = options.level_price;
  def.row_price = options.row_price;
  def.thread_count = options.threads;
  return def;
}

hgrid::Grid filled_grid(const GridOptions &options, const particles::ParticleSet &particles, const std::string &file) {
  const std::vector<double> cell_sizes = number_list("--cell-sizes", options.cell_sizes);
  try {
    hgrid::Grid grid(grid_def(options, particles, cell_sizes));
    particles::insert(particles, grid);
    return grid;
  } catch (const hgrid::Error &error) {
    throw particles::Error(file, 0, particles::message_of(error));
  }
}

}  // namespace command
