// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// `hgrid slice`: draws a plane through a packing, coloured by level, with the cells over it.
#include "programs/draw/slice.hpp"

#include "particles/error.hpp"
#include "particles/files/reader.hpp"
#include "particles/text/output.hpp"
#include "programs/draw/slice_picture.hpp"
#include "programs/hgrid/command.hpp"
#include "programs/hgrid/grid_options.hpp"
#include "programs/hgrid/particle_options.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace command {
namespace {

struct SliceOptions {
  ParticleOptions particles;
  GridOptions grid;
  std::string axis = "z";
  double at = 0.5;
  std::string output;
};

std::vector<draw::Level> levels_of(const SliceOptions &options, const particles::ParticleSet &particles) {
  hgrid::Grid grid = filled_grid(options.grid, particles, options.particles.file);
  std::vector<draw::Level> levels;
  for (const hg_level &level : grid.query_levels()) {
    if (!(level.largest_radius > 0)) continue;  // empty, or points: nothing to see
    levels.push_back({level.cell_size, level.largest_radius, static_cast<size_t>(level.particle_count)});
  }
  return levels;
}

void run_slice(const SliceOptions &options) {
  const particles::ParticleSet particles = load_particles(options.particles);
  particles::require_upright(particles, options.particles.file);
  if (particles.count() == 0) throw particles::Error(options.particles.file, 0, "no particles to draw");
  const int axis = options.axis[0] - 'x';
  const draw::Slice slice = draw::cut(particles, levels_of(options, particles), axis, options.at);
  if (slice.disks.empty()) {
    throw particles::Error(options.particles.file, 0,
                           "the plane " + options.axis + " = " + std::to_string(slice.position) + " cuts no particle");
  }
  particles::Output out(options.output);
  out << draw::slice_picture(slice);
  out.close();
  if (options.output == "-") return;
  std::printf("%s: %zu disks", options.output.c_str(), slice.disks.size());
  if (particles.dimension == 3) std::printf(" in the plane %s = %.6g", options.axis.c_str(), slice.position);
  std::printf(", %zu levels\n", slice.levels.size());
}

}  // namespace

void add_slice(CLI::App &parent) {
  auto options = std::make_shared<SliceOptions>();
  CLI::App *command = parent.add_subcommand("slice", "Draw a plane through the particles, coloured by level, as SVG");
  add_particle_options(*command, options->particles);
  command->add_option("-o,--output", options->output, "Picture to write, - for standard output")->required();
  command->add_option("--axis", options->axis, "Normal of the plane: x, y or z (three dimensions)")
      ->check(CLI::IsMember({"x", "y", "z"}))
      ->capture_default_str();
  command->add_option("--at", options->at, "Where the plane cuts the axis, as a fraction of the box")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--levels", options->grid.levels, "Rule that chooses the levels: auto or paper")
      ->check(CLI::IsMember({"auto", "paper"}))
      ->capture_default_str();
  command->add_option("--level-count", options->grid.level_count, "Number of levels, 0 = the cheapest")
      ->capture_default_str();
  command->callback([options] { run_slice(*options); });
}

}  // namespace command
