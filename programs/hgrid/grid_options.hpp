// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Options of every command that searches: how the grid works.
#pragma once

#include "particles/particle_set.hpp"

#include <hgrid/hgrid.hpp>

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace command {

struct GridOptions {
  double margin = 0;
  bool max_range = false;
  bool touching = false;
  std::string images = "nearest";  // nearest, all
  std::string accuracy = "exact";  // exact, double, float
  std::string order = "grid";      // id, grid
  std::string levels = "auto";     // auto, paper
  int level_count = 0;             // 0: the cheapest
  std::string cell_sizes;          // ascending, with commas; set: `levels` does not count
  double cell_overhead = -1;       // K of Eq. 7; negative: the paper's, or for auto prices instead
  double level_price = -1;         // of hg_grid_def; negative: the library's own
  double row_price = -1;
  int index_base = 0;  // the id of the first particle
  int threads = 0;     // 0: all
};

// Adds --margin, --max-range, --touching, --images, --accuracy, --order, --levels, --level-count, --cell-sizes,
// --cell-overhead, --level-price, --row-price, --threads. `options` must outlive the parse.
void add_grid_options(CLI::App &command, GridOptions &options);

// Adds --base, of commands that write pairs.
void add_base_option(CLI::App &command, GridOptions &options);

// Adds --level-price and --row-price, the prices of `hgrid calibrate`, which do not go with `instead`.
void add_price_options(CLI::App &command, double &level_price, double &row_price, const std::string &group,
                       CLI::Option *instead);

// What the options say, of these particles' box. The result points into `cell_sizes`, ascending, unless it is empty.
hg_grid_def grid_def(const GridOptions &options, const particles::ParticleSet &particles,
                     const std::vector<double> &cell_sizes);

// A grid for these particles as the options say; dimension, box and periodic axes are theirs. `file` is named where the
// library refuses them.
hgrid::Grid filled_grid(const GridOptions &options, const particles::ParticleSet &particles, const std::string &file);

}  // namespace command
